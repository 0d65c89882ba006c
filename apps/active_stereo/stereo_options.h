#pragma once

#include "tool.h"

#include <pcl/acquisition/rig_of_images.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/calibration_file.h>
#include <pcl/pipeline/session_conversion.h>
#include <pcl/pipeline/session_source.h>

namespace pcl::acmap {

/** \brief Options of the user. */
struct StereoOptions {
  std::string session; ///< folder; empty without a session
  TrinocularImageLists images;
  std::vector<std::string> rig;   ///< of the image lists: one file, or one a camera
  std::string rig_cameras;        ///< reference and neighbour in the file
  std::optional<double> baseline; ///< metres, in place of the file's
  std::optional<bool> rectify;    ///< the lists
  bool active = false;            ///< one image per camera was taken under a pattern
  std::string output;
  std::string method = "spacetime";
  bool has_method = false;  ///< whether the method was given
  SessionSettings settings; ///< without what the other options say
  std::string poses;        ///< trajectory; empty: none
  bool disparity = false;
  bool goes_on = false; ///< continue an interrupted run

  bool
  hasLists() const
  {
    return !images.reference.empty();
  }

  /** \brief Is there only one image per camera? */
  bool
  hasOneShot() const
  {
    return images.reference.size() == 1;
  }

  /** \brief Are the images matched as passive stereo? */
  bool
  isPassive() const
  {
    return settings.unlit || (hasOneShot() && !active);
  }

  /** \brief Path of the file of the rig. */
  std::string
  rigPath() const
  {
    return hasLists() ? rig.front() : session + "/rig.yaml";
  }

  /** \brief The rig of the image lists: cameras without a list are not used.
   * \throws InputFileException naming what cannot be read
   * \throws BadArgumentException for a list of a camera that is not in the rig */
  CalibratedRig
  rigOfLists() const;

  /** \brief All that these options say, except the cameras of image lists. */
  SessionSettings
  sessionSettings(unsigned threads) const;
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, StereoOptions& options);

/** \brief Adds only the options for matching and for the points. */
void
addStereoChoices(CLI::App& app, StereoOptions& options);

/** \brief The same for a choice that a whole session has. */
void
addUnlit(CLI::App& app, StereoOptions& options);

/** \brief Refuses options that exclude each other, and places for the results that
 * cannot be used.
 * \throws UsageError, OutputFileException naming them */
void
requireSense(const Tool& tool, const StereoOptions& options);

/** \brief Refuses a minimum depth that is not below the maximum depth, and a method where
 * no shots under patterns are fused.
 * \throws UsageError naming them */
void
requireStereoSense(const StereoOptions& options);

/** \brief Sets up stereo for a rig.
 * \param[in] make does so, as \ref setUpStereo
 * \throws UsageError for depths that do not suit the rig */
template <typename Make>
auto
withDepths(const Make& make)
{
  try {
    return make();
  }
  catch (const BadArgumentException&) {
    throw UsageError("--max-depth: " + failureOf(std::current_exception()).line);
  }
}

/** \brief Tells why there is no point. */
std::string
noPlaceText(const ConvertedSession& converted);

/** \brief Writes the lines of the summary about pixels and points. */
void
tellPoints(const ConvertedSession& converted, StageLog& log);

/** \brief Reports the remarks on observations as warnings. */
void
warnOfRemarks(const ConvertedSession& converted, StageLog& log);

/** \brief Reports the first findings about the frames as warnings. The report has all. */
void
warnOfFindings(StageLog& log, const std::vector<std::string>& findings);

/** \brief Computes the observations of a session, or the one of image lists, and writes
 * them into a folder: the complete work of pcl_active_stereo.
 * \throws according to the exit codes of its documentation page; InterruptedPartway
 * when observations were finished before an interruption, which are kept */
void
makeObservations(const StereoOptions& options,
                 const RunControls& controls,
                 StageLog& log);

} // namespace pcl::acmap
