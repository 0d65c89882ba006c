#pragma once

#include "stereo_options.h"

#include <pcl/core/output_folder.h>

#include <map>

namespace pcl::acmap {

/** \brief Refuses a folder that already holds files with which results would mix.
 * \throws OutputFileException naming what it holds */
void
requireNoStereo(const OutputFolder& folder);

/** \brief Writes the disparities of an observation as numbers and as a picture, if
 * requested.
 * \throws OutputFileException when a file could not be written completely */
void
saveDisparity(const OutputFolder& folder,
              const StereoOptions& options,
              const SessionObservation& made);

/** \brief Statistics of all observations so far. */
struct StereoResults : SessionReport {
  /** \brief Those of each observation, in their order, for the report. */
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  std::size_t pixels = 0;
  /** \brief Numbers of the observations to which a remark applies. */
  std::map<std::string, std::vector<std::size_t>> remarks_of;

  void
  add(const SessionObservation& made);

  /** \brief Adds one of the \ref entries of an earlier run.
   * \throws nlohmann::json::exception when it has another form */
  void
  add(const nlohmann::ordered_json& observation);

  /** \brief Is an observation among the results? */
  bool
  has(std::size_t number) const;

  /** \brief Fraction of the pixels that have a disparity, in [0, 1]. */
  double
  matchedShare() const;

  /** \brief Reasons for missing disparities, most frequent first: "3.1 % untextured,
   * ...". */
  std::string
  rejected() const;

  /** \brief Writes the lines of the summary about pixels and points. */
  void
  tellPoints(StageLog& log) const;

  /** \brief Reports the remarks on observations as warnings. */
  void
  warnOfRemarks(StageLog& log) const;
};

/** \brief Reports the first findings about the frames as warnings. The report has
 * all. */
void
warnOfFindings(StageLog& log, const std::vector<std::string>& findings);

} // namespace pcl::acmap
