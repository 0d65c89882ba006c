#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/progress.h>
#include <pcl/egomotion/egomotion_types.h>
#include <pcl/egomotion/impl/keypoint_kernel.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>
#include <pcl/egomotion/impl/motion_fit_kernel.h>
#include <pcl/egomotion/impl/worst_out_kernel.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Scales (rings) and rotations (sectors) that are tried in either direction. */
struct PatchShifts {
  int rings = 0, sectors = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PatchShifts& shifts, Visitor&& visit)
{
  visit({"rings"}, shifts.rings);
  visit({"sectors"}, shifts.sectors);
}

/** \brief Settings of \ref estimateEgomotion; see VisualEgomotion. */
struct EgomotionSettings {
  MotionModel model = MotionModel::Planar;
  MotionSolver solver = MotionSolver::ConjugateGradient;
  double max_translation = 1;         ///< maximum between two views, metres
  double max_rotation = 0.5235987756; ///< maximum between two views, radians
  bool refines = true;                ///< use surfaces and brightness as well
  KeypointSettings keypoints;
  LogPolarSettings patches;
  std::optional<PatchShifts> shifts; ///< of patches; default: see \ref shiftsOf
  WorstOutSettings worst_out;
  bool paper = false;   ///< II-B.1 as printed, see \ref inMode
  unsigned threads = 0; ///< 0 = all
};

/** \brief Calls visit (field, value) for each field but the threads; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const EgomotionSettings& settings, Visitor&& visit)
{
  visit({"model"}, Named{settings.model, motion_model_names});
  visit({"solver"}, Named{settings.solver, motion_solver_names});
  visit({"max_translation", "m"}, settings.max_translation);
  visit({"max_rotation", "rad"}, settings.max_rotation);
  visit({"refines"}, settings.refines);
  visit({"keypoints"}, settings.keypoints);
  visit({"patches"}, settings.patches);
  visit({"shifts"}, settings.shifts);
  visit({"worst_out"}, settings.worst_out);
  visit({"paper"}, settings.paper);
}

/** \brief The shifts of patches that are tried: those that are set; otherwise none, or,
 * in paper mode, one in each direction. */
ACMAP_EXPORT PatchShifts
shiftsOf(const EgomotionSettings& settings);

/** \brief The settings of a run: in paper mode, whatever the paper does not have is
 * switched off. \ref prepareView and \ref estimateEgomotion take them. */
ACMAP_EXPORT EgomotionSettings
inMode(EgomotionSettings settings);

/** \brief A view of a camera, one value per pixel. */
struct CameraView {
  GreyImage image;
  std::vector<Eigen::Vector3f> points; ///< metres, camera frame; NaN if there is none
  std::vector<float> sigmas; ///< metres along the ray; if empty, they are estimated
};

/** \brief Data prepared from a view: features, their patches, surface blocks. */
struct EgomotionView;

ACMAP_EXPORT std::shared_ptr<const EgomotionView>
prepareView(CameraView view, const EgomotionSettings& settings);

/** \brief Pixels of the source and of the target. */
using PixelPairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** \brief A motion, if there is one, and the matches on which it is based. */
struct EgomotionSolution {
  std::optional<EgomotionEstimate> estimate;
  PixelPairs matches; ///< similar in appearance
  PixelPairs inliers; ///< the matches on which the motion is based
};

/** \param[in] source the later view
 * \param[in] target the earlier view
 * \throws CancelledException when the progress callback cancels */
ACMAP_EXPORT EgomotionSolution
estimateEgomotion(const EgomotionView& source,
                  const EgomotionView& target,
                  const EgomotionSettings& settings,
                  const Progress& progress,
                  EgomotionReport& report);

} // namespace pcl::acmap
