#pragma once

#include <pcl/mapping/entropy_rectification.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/pipeline/plane_sightings.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The frame in which observations are mapped: its origin is the first sensor, y points
 * down and z ahead of it, level. Voxels and bins lie in it, so that the result does not depend
 * on the frame in which poses are given. */
class LevelFrame {
public:
  /** \brief The frame of the map itself. */
  LevelFrame() = default;

  /** \param[in] T_map_sensor the first pose
   * \param[in] up unit, in the map */
  LevelFrame(const Eigen::Isometry3d& T_map_sensor, const Eigen::Vector3d& up);

  /** \brief A level frame that was made before. */
  explicit LevelFrame(const Eigen::Isometry3d& T_frame_map)
  : is_of_map_(false)
  , T_frame_map_(T_frame_map)
  {}

  const Eigen::Isometry3d&
  T_frame_map() const
  {
    return T_frame_map_;
  }

  /** \brief The up direction in this frame.
   * \param[in] up in the map */
  Eigen::Vector3d
  up(const Eigen::Vector3d& up) const;

  /** \brief A pose in this frame, rounded (\ref roundedPose). */
  Eigen::Isometry3d
  place(const Eigen::Isometry3d& T_map_camera) const;

  std::vector<Eigen::Isometry3d>
  place(const std::vector<Eigen::Isometry3d>& poses) const;

  /** \brief What was found in this frame for a pose, in the map; if it did not move, the given
   * pose with all its digits. */
  Eigen::Isometry3d
  inMap(const Eigen::Isometry3d& found, const Eigen::Isometry3d& given) const;

private:
  bool is_of_map_ = true;
  Eigen::Isometry3d T_frame_map_ = Eigen::Isometry3d::Identity();
};

/** \brief A pose to a nanometre: it is the same to the last bit for all frames in which poses
 * were given, where one bit may decide. */
Eigen::Isometry3d
roundedPose(const Eigen::Isometry3d& pose);

/** \brief The pose of an observation (ObservationSequence::poseInHeader); none if its file cannot
 * be read, which is told when it is its turn. */
std::optional<Eigen::Isometry3d>
readablePose(const ObservationSequence& sequence, std::size_t i);

/** \brief The first pose that can be read; the identity if there is none. */
Eigen::Isometry3d
firstPoseOf(const ObservationSequence& sequence);

/** \brief Rectifies level observations in a frame.
 * \param[in] up unit, in their map
 * \param[in,out] rectification with its settings; with its report afterwards
 * \return T_map_sensor of each observation
 * \throws what EntropyRectification::compute does */
std::vector<Eigen::Isometry3d>
rectifiedPoses(const LevelFrame& frame,
               const ConsolidatedObservations& observations,
               const Eigen::Vector3d& up,
               EntropyRectification<PointNormal>& rectification);

/** \brief What was found on a merged cloud, which has no one sensor, in another frame. */
void
moveTo(const Eigen::Isometry3d& T_to_from, MappedPlanes& found);

void
moveTo(const Eigen::Isometry3d& T_to_from, PlaneSightings& sightings);

} // namespace pcl::acmap
