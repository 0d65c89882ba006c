#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/planar_pose.h>

namespace pcl {

Eigen::Quaterniond
uprightRotation(const Eigen::Vector3d& up)
{
  const Eigen::Vector3d expected = -Eigen::Vector3d::UnitY();
  return up == expected ? Eigen::Quaterniond::Identity()
                        : acmap::smallestRotation(up, expected);
}

} // namespace pcl
