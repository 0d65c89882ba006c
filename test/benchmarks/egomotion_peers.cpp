#include "egomotion_methods.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/ndt.h>

#include <sstream>

namespace pcl::acmap::bench {
namespace {

using Points = PointCloud<PointXYZ>;

Points::Ptr
sparseCloud(const EgomotionCloud& cloud)
{
  constexpr float leaf = 0.05F, reach = 6; // metres
  const auto points = std::make_shared<Points>();
  for (const PointXYZRGBSigma& point : cloud)
    if (point.z <= reach) // not NaN
      points->push_back({point.x, point.y, point.z});
  VoxelGrid<PointXYZ> grid;
  grid.setInputCloud(points);
  grid.setLeafSize(leaf, leaf, leaf);
  const auto sparse = std::make_shared<Points>();
  grid.filter(*sparse);
  return sparse;
}

template <typename Registration>
std::optional<Eigen::Isometry3d>
aligned(Registration& registration,
        const EgomotionCloud& source,
        const EgomotionCloud& target)
{
  registration.setInputSource(sparseCloud(source));
  registration.setInputTarget(sparseCloud(target));
  Points moved;
  registration.align(moved);
  if (!registration.hasConverged())
    return std::nullopt;
  const Eigen::Matrix4d motion =
      registration.getFinalTransformation().template cast<double>();
  Eigen::Isometry3d T_target_source(
      Eigen::Quaterniond(Eigen::Matrix3d(motion.topLeftCorner<3, 3>())).normalized());
  T_target_source.translation() = motion.topRightCorner<3, 1>();
  return T_target_source;
}

} // namespace

EgomotionMethod
gicpMethod(double correspondence_distance, int neighbours)
{
  std::ostringstream title;
  title << "PCL GICP, to " << correspondence_distance << " m, " << neighbours
        << " neighbours";
  return {
      title.str(),
      [=](const EgomotionSequence& sequence, std::size_t source, std::size_t target) {
        GeneralizedIterativeClosestPoint<PointXYZ, PointXYZ> gicp;
        gicp.setMaxCorrespondenceDistance(correspondence_distance);
        gicp.setCorrespondenceRandomness(neighbours);
        return aligned(gicp, *sequence.clouds[source], *sequence.clouds[target]);
      }};
}

EgomotionMethod
ndtMethod(double resolution)
{
  // PCL's tutorial uses 0.01 and 35, with which it stops after the first step here.
  constexpr double step = 0.1, min_change = 1e-4; // metres, square metres
  constexpr int max_iterations = 100;
  std::ostringstream title;
  title << "PCL NDT, cells of " << resolution << " m";
  return {
      title.str(),
      [=](const EgomotionSequence& sequence, std::size_t source, std::size_t target) {
        NormalDistributionsTransform<PointXYZ, PointXYZ> ndt;
        ndt.setResolution(static_cast<float>(resolution));
        ndt.setStepSize(step);
        ndt.setTransformationEpsilon(min_change);
        ndt.setMaximumIterations(max_iterations);
        return aligned(ndt, *sequence.clouds[source], *sequence.clouds[target]);
      }};
}

} // namespace pcl::acmap::bench
