#pragma once

#include "stereo_options.h"
#include "stereo_shots.h"

#include <pcl/core/output_folder.h>
#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>

#include <map>

namespace pcl::acmap {

/** \brief The disparities that are searched. */
struct SearchRange {
  int minimum = 0; ///< px
  int count = 0;   ///< number of disparities, starting at the minimum

  int
  maximum() const
  {
    return minimum + count - 1;
  }
};

/** \brief Disparities between two depths, extended by one pixel at both ends, and
 * limited by the size of the image and the range of the matcher.
 * \param[in] rig with a neighbour
 * \param[in] nearest metres
 * \param[in] farthest metres, above the nearest
 * \throws UsageError when the image is too small for any of them */
SearchRange
disparitiesBetween(const TrinocularRig& rig, double nearest, double farthest);

/** \brief Depth of a disparity, metres. */
double
depthOf(const TrinocularRig& rig, double disparity);

/** \brief Sets fusion and projection for a rig.
 * \param[in] threads 0 = all
 * \return the disparities that are searched
 * \throws UsageError, BadArgumentException for depths that do not suit the rig
 * \throws MemoryRefused when the costs of all disparities do not fit. The memory of the
 * shots is not considered: their number is not known before they are read */
SearchRange
setUpStereo(const TrinocularRig& rig,
            const StereoOptions& options,
            unsigned threads,
            DisparityFusion& fusion,
            DisparityBackProjection& projection);

/** \brief Result of the shots of an observation. */
struct MadeObservation {
  MatchedDisparity matched;
  PointCloud<PointXYZRGBSigma> cloud; ///< organized, camera frame
  DisparityFusionReport fusion;
  DisparityBackProjectionReport projection;
};

/** \brief Computes the observations of one rig from their shots. */
class ShotFusion {
public:
  /** \throws what \ref setUpStereo does */
  ShotFusion(const TrinocularRig& rig, const StereoOptions& options, unsigned threads);

  const SearchRange&
  range() const
  {
    return range_;
  }

  /** \throws CancelledException when the callback requests it */
  MadeObservation
  make(const ObservationShots& shots, const ProgressCallback& progress);

private:
  DisparityFusion fusion_;
  DisparityBackProjection projection_;
  SearchRange range_; ///< set with both
};

/** \brief Refuses a folder that already holds files with which results would mix.
 * \throws OutputFileException naming what it holds */
void
requireNoStereo(const OutputFolder& folder);

/** \brief Writes an observation and, if requested, its disparities as numbers and as a
 * picture.
 * \throws OutputFileException when a file could not be written completely */
void
saveResults(const OutputFolder& folder,
            const StereoOptions& options,
            std::size_t number,
            const MadeObservation& made,
            const Eigen::Isometry3d& T_map_camera);

/** \brief Statistics of all observations so far. */
struct StereoResults {
  /** \brief Those of each observation, in their order, for the report. */
  nlohmann::ordered_json observations = nlohmann::ordered_json::array();
  std::size_t frames = 0;
  std::size_t pixels = 0;
  std::size_t points = 0;
  std::size_t too_near = 0;
  std::size_t too_far = 0;
  std::array<std::size_t, disparity_outcomes> outcomes{};
  /** \brief Numbers of the observations to which a remark applies. */
  std::map<std::string, std::vector<std::size_t>> remarks;

  /** \brief Adds an observation.
   * \param[in] frames number of its frames */
  void
  add(std::size_t number, std::size_t frames, const MadeObservation& made);

  /** \brief Adds one of the \ref observations of an earlier run.
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
