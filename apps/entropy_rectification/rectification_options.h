#pragma once

#include "tool.h"

#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_levelling_types.h>
#include <pcl/mapping/plane_adjustment_types.h>
#include <pcl/pipeline/bag_settings.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/rectification_pictures.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Options of the user. */
struct RectificationOptions {
  std::string folder; ///< of posed observations; empty with a log
  std::string log;    ///< CARMEN log, or a bag; empty with a folder
  std::string output;
  BagSettings bag;                   ///< how the bag, or the log, is read
  std::optional<double> laser_sweep; ///< of the log, radians; found if it is not set
  EntropyRectification<PointNormal> stage; ///< without observations
  std::optional<Eigen::Vector3d> up;       ///< of the input; found if it is not set
  PoseConventionCheck poses;               ///< of the folder
  bool measures_path = true;               ///< unless the user states what it is
  bool six_degrees = false;                ///< adjust by planes after the entropy
  bool write_observations = false;

  /** \brief Sets the bins for cameras, which see walls from a shorter distance and in
   * more detail than laser scanners, for which the class has its default. */
  RectificationOptions()
  {
    constexpr double bin_of_cameras = 0.05; // metres
    stage.setBinSize(bin_of_cameras);
  }

  /** \brief The folder or the log. */
  const std::string&
  input() const
  {
    return log.empty() ? folder : log;
  }
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, RectificationOptions& options);

/** \brief Adds only the options for the rectification. */
void
addRectificationChoices(Tool& tool, RectificationOptions& options);

/** \brief \throws UsageError when an option has no effect in the mode or for the input, or
 * exceeds what the bin size permits */
void
requireSense(Tool& tool, const RectificationOptions& options);

/** \brief Reports vertical and rectification. */
void
tellRectification(const RectificationOptions& options,
                  const MapLevellingReport& levelling,
                  const EntropyRectificationReport& report,
                  StageLog& log);

/** \brief Reports the points that were rectified.
 * \param[in] is_raw Were these as they were measured? */
void
tellConsolidated(const SequenceConsolidationReport& report,
                 std::size_t observations,
                 bool is_raw,
                 StageLog& log);

/** \brief Reports an adjustment by planes: lines of the summary, and `adjustment` in the
 * details. */
void
tellAdjustment(const PlaneAdjustmentReport& report,
               const std::optional<RevisitReport>& revisits,
               StageLog& log);

/** \brief Writes plan_before.png, plan_after.png, plan.png and energy.png.
 * \param[in] place path of a picture of a name */
void
savePictures(const RectificationPictures& pictures,
             const std::function<std::string(const char*)>& place);

/** \brief Rectifies a map and writes it into a folder: the complete work of
 * pcl_entropy_rectification.
 * \param[in] posed the observations of the options' folder
 * \throws according to the exit codes of its documentation page */
void
rectifyPoses(const RectificationOptions& options,
             const ObservationSequence& posed,
             const RunControls& controls,
             StageLog& log);

/** \brief The same for the scans of the options' log. */
void
rectifyScans(const RectificationOptions& options,
             const RunControls& controls,
             StageLog& log);

} // namespace pcl::acmap
