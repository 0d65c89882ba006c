#pragma once

#include "temporary_folder.h"

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/map_comparison.h>

#include <string>

namespace pcl::acmap::test {

/** \brief The truth.json of a room 4 m wide and 20 m long: floor, left wall (x = -2),
 * right wall (x = 2), far end (z = 20), a board with hardly any points, and a near end
 * without points. */
std::string
roomTruth();

/** \brief Five poses along the room, 2 m apart, that look forward. */
Trajectory
roomWay();

/** \brief The folder of a session with the room. */
class RoomSession {
public:
  explicit RoomSession(const std::string& truth = roomTruth());

  /** \brief Path of truth.json or of another file. */
  std::string
  path(const std::string& name) const
  {
    return folder_.path(name);
  }

  SessionTruth
  load() const
  {
    return loadSessionTruth(folder_.path("."));
  }

private:
  TemporaryFolder folder_;
};

/** \brief A plane of a map: a parallelogram with its normal along u x v. */
PlanePatch
patchOf(const Eigen::Vector3d& corner,
        const Eigen::Vector3d& u,
        const Eigen::Vector3d& v);

/** \brief A plane after a motion. */
PlanePatch
moved(const PlanePatch& patch, const Eigen::Isometry3d& motion);

/** \brief A rotation about a vertical axis through a point, degrees. */
Eigen::Isometry3d
turnAt(const Eigen::Vector3d& place, double angle);

/** \brief The true room: floor, left wall, right wall, far end. */
CompactMap
roomMap();

/** \brief The complete true trajectory, as that before and after. */
MappedTrajectory
trueWay();

} // namespace pcl::acmap::test
