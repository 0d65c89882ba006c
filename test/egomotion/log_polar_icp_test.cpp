#include "painted_views.h"

#include <pcl/core/random.h>
#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/registration/icp.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl::acmap::test {
namespace {

using Cloud = PointCloud<PointXYZRGB>;
using Icp = IterativeClosestPoint<PointXYZRGB, PointXYZRGB>;
using Matcher = registration::CorrespondenceEstimationLogPolar<PointXYZRGB>;

/** A painted floor and wall, seen by a camera: each ray is intersected with the nearer
 * one. */
Cloud::Ptr
corner(const Eigen::Isometry3d& T_world_camera)
{
  const Wallpaper paper(10);
  Cloud::Ptr cloud(new Cloud(240, 180));
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 240; ++x) {
      const Eigen::Vector3d ray((x - 119.5) / 200, (y - 89.5) / 200, 1);
      const Eigen::Vector3d way = T_world_camera.linear() * ray;
      const Eigen::Vector3d from = T_world_camera.translation();
      const double to_wall = (3 - from.z()) / way.z();
      const double to_floor = way.y() > 0 ? (0.7 - from.y()) / way.y() : 1e9;
      const double depth = std::min(to_wall, to_floor);
      const Eigen::Vector3d place = from + depth * way;
      PointXYZRGB& point = (*cloud)[static_cast<std::size_t>(y * 240 + x)];
      point.getVector3fMap() = (depth * ray).cast<float>();
      // the wall and the floor are continuous on the texture
      const Eigen::Vector2d on_paper(place.x(), place.y() + 3 - place.z());
      const double value = std::clamp(paper.at(80 * on_paper), 0.0, 255.0);
      point.r = point.g = point.b = static_cast<std::uint8_t>(std::lround(value));
    }
  return cloud;
}

TEST(LogPolarIcp, insideOfPclItFindsTheMotion)
{
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
  truth.rotate(Eigen::AngleAxisd(0.06, Eigen::Vector3d(0.2, 1, 0.1).normalized()));
  truth.pretranslate(Eigen::Vector3d(0.08, -0.03, 0.12));
  const Cloud::Ptr before = corner(Eigen::Isometry3d::Identity()), now = corner(truth);

  Icp icp;
  Matcher::Ptr matcher(new Matcher);
  matcher->setMinimumScore(0.9F);
  registration::CorrespondenceRejectorWorstOut::Ptr rejector(
      new registration::CorrespondenceRejectorWorstOut);
  icp.setCorrespondenceEstimation(matcher);
  icp.addCorrespondenceRejector(rejector);
  icp.setInputSource(now);
  icp.setInputTarget(before);
  icp.setMaximumIterations(5);
  Cloud aligned;
  icp.align(aligned);

  // matches of the last iteration: colours were kept with the transformed points
  EXPECT_GT(matcher->getReport().matches, 80u);
  const Eigen::Isometry3d found(icp.getFinalTransformation().cast<double>());
  const Eigen::Isometry3d error = found.inverse() * truth;
  EXPECT_LT(error.translation().norm(), 0.01);
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.005);
}

TEST(LogPolarIcp, aGuessThatDropsTheImageIsRefused)
{
  const Cloud::Ptr cloud = corner(Eigen::Isometry3d::Identity());
  Icp icp;
  icp.setCorrespondenceEstimation(Matcher::Ptr(new Matcher));
  icp.setInputSource(cloud);
  icp.setInputTarget(cloud);
  Cloud aligned;
  EXPECT_THROW(
      icp.align(aligned, Eigen::Affine3f(Eigen::Translation3f(1, 0, 0)).matrix()),
      UnorganizedPointCloudException);
}

} // namespace
} // namespace pcl::acmap::test
