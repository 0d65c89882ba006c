#pragma once

#include "compact_mapping/truth_report.h"
#include "temporary_folder.h"

#include <pcl/core/compact_map.h>

#include <string>

namespace pcl::acmap::test {

/** \brief A room 4 m wide and 20 m long, as a simulated session tells it: floor, left wall
 * (x = -2), right wall (x = 2), far end (z = 20), a board of which hardly anything is seen,
 * and a near end of which nothing is. */
std::string
roomTruth();

/** \brief Five places along the room, 2 m apart, that look ahead. */
Trajectory
roomWay();

/** \brief A session's folder with the room. */
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

/** \brief A plane of a map: a parallelogram that looks to the side of u x v. */
PlanePatch
patchOf(const Eigen::Vector3d& corner,
        const Eigen::Vector3d& u,
        const Eigen::Vector3d& v);

/** \brief A plane that was moved. */
PlanePatch
moved(const PlanePatch& patch, const Eigen::Isometry3d& motion);

/** \brief A turn about an upright axis through a place, degrees. */
Eigen::Isometry3d
turnAt(const Eigen::Vector3d& place, double angle);

/** \brief The room as it is: floor, left wall, right wall, far end. */
CompactMap
roomMap();

/** \brief The true way, all of it, before and after. */
MappedTrajectory
trueWay();

} // namespace pcl::acmap::test
