#pragma once

#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/pipeline/session_source.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

namespace acmap {
class OutputFolder;
}

/** \brief How the observations of a session are written. \ingroup pipeline */
struct SessionConversion {
  /** \brief Trajectory with the pose T_map_camera of each observation, in the row of its
   * number; empty: poses are not known. */
  std::string poses;
  bool writes_disparities = false; ///< as .pfm (px), and as .png
  bool numbers_disparities = true; ///< in their names; false for a single observation
  /** \brief Puts each observation into place when it is finished, and leaves out those that
   * an interrupted run has put there. */
  bool goes_on = false;
  ProgressCallback progress;
};

/** \brief What a session became: sums, and the figures of each observation.
 * \ingroup pipeline */
class ACMAP_EXPORT ConvertedSession {
public:
  SessionReport report; ///< with the seconds of all observations for each step

  /** \brief Numbers of the observations to which a remark applies. */
  std::map<std::string, std::vector<std::size_t>> remarks_of;

  /** \brief Adds an observation. */
  void
  add(const SessionObservation& made);

  /** \brief Is an observation among them? */
  bool
  has(std::size_t number) const;

  /** \brief Number of pixels of all disparity images. */
  std::size_t
  pixels() const;

  /** \brief Number of pixels with a disparity. */
  std::size_t
  matched() const;

  /** \brief Fraction of the pixels that have a disparity, in [0, 1]. */
  double
  matchedShare() const
  {
    return pixels() == 0
               ? 0.0
               : static_cast<double>(matched()) / static_cast<double>(pixels());
  }

  /** \brief The figures of each observation in the order in which they were added, a JSON
   * array of objects: number, file, the fields of both reports. */
  std::string
  figuresText() const;

  /** \brief Adds what \ref figuresText of an earlier run was.
   * \param[in] is_there is asked with the name of each file; others are left out
   * \return false, and nothing is added, if the text has another form */
  bool
  addFigures(const std::string& text,
             const std::function<bool(const std::string&)>& is_there);

private:
  std::vector<std::pair<std::size_t, std::string>> figures_; // numbers, JSON objects
};

/** \brief Would a file of that name be one of a converted session? */
ACMAP_EXPORT bool
isConvertedName(const std::string& name);

/** \brief Writes the observations of a session as PCDs, one after another, while the shots of
 * the next one are read; with known poses as VIEWPOINT and as trajectory.txt. Section II-A of
 * "Active Stereo Based Compact Mapping".
 * \code
 * const auto session = pcl::openSession (std::make_shared<pcl::TrinocularFileGrabber> ("session"));
 * pcl::acmap::OutputFolder folder ("observations");
 * pcl::ConvertedSession converted;
 * pcl::convertSession (*session, {}, folder, converted);
 * folder.commit ();
 * \endcode
 * \param[in] session of which no observation was read before
 * \param[in,out] folder is committed by the caller, who may refuse a session without points
 * \param[out] converted has all that was finished, also after an exception
 * \throws InputFileException if the trajectory cannot be read, or has too few rows; of the
 * session
 * \throws OutputFileException when a file could not be written completely
 * \throws CancelledException when the progress callback requests it \ingroup pipeline */
ACMAP_EXPORT void
convertSession(SessionSource& session,
               const SessionConversion& conversion,
               acmap::OutputFolder& folder,
               ConvertedSession& converted);

} // namespace pcl
