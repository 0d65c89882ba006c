#pragma once

#include "rectification_worlds.h"

#include <pcl/common/io.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/plane_adjustment.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace pcl::acmap::test {

/** \brief The first scans of a room in another type, each with the drifted pose of its sensor as
 * PCL keeps it. */
template <typename PointT>
std::vector<typename PointCloud<PointT>::Ptr>
posedScans()
{
  const World world = makeRoomWorld(21);
  const std::vector<PlanarPose> odometry = drifted(world.truth.poses, drift, 21);
  std::vector<typename PointCloud<PointT>::Ptr> scans;
  for (std::size_t i = 0; i < 12; ++i) {
    scans.emplace_back(new PointCloud<PointT>);
    copyPointCloud(*world.truth.clouds[i], *scans.back());
    const Eigen::Isometry3f pose = isometryOf(odometry[i]).cast<float>();
    scans.back()->sensor_origin_ << pose.translation(), 0;
    scans.back()->sensor_orientation_ = Eigen::Quaternionf(pose.linear());
  }
  return scans;
}

/** \brief The pose of a sensor, by other means than the class has. */
template <typename PointT>
Eigen::Isometry3d
poseOfSensor(const PointCloud<PointT>& cloud)
{
  return Eigen::Translation3d(
             cloud.sensor_origin_.template head<3>().template cast<double>()) *
         cloud.sensor_orientation_.template cast<double>().normalized();
}

template <typename PointT>
bool
haveSameBytes(const PointCloud<PointT>& a, const PointCloud<PointT>& b)
{
  return a.width == b.width && a.height == b.height && a.size() == b.size() &&
         (a.empty() ||
          std::memcmp(a.points.data(), b.points.data(), a.size() * sizeof(PointT)) ==
              0);
}

/** \brief The map by the calls of registration::LUM. */
template <typename Class, typename PointT>
PointCloud<PointT>
mapByLum(Class& object, const std::vector<typename PointCloud<PointT>::Ptr>& scans)
{
  for (const auto& scan : scans)
    object.addPointCloud(scan, poseOfSensor(*scan));
  object.compute();
  return *object.getConcatenatedCloud();
}

/** \brief The map by the calls of a filter. */
template <typename Class, typename PointT>
PointCloud<PointT>
mapByFilter(Class& object,
            const std::vector<typename PointCloud<PointT>::Ptr>& scans,
            const IndicesPtr& indices = nullptr)
{
  if (indices)
    object.setIndices(indices);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    object.setInputCloud(scans[i]);
    EXPECT_EQ(object.addPointsFromInputCloud(), i);
  }
  PointCloud<PointT> map;
  object.filter(map);
  return map;
}

/** \brief A filter gives what the calls of LUM give, byte for byte, of all points and of
 * some. \tparam Class one for clouds of PointT */
template <typename PointT, typename Class>
void
expectFilterOfAllAndOfSome()
{
  const auto scans = posedScans<PointT>();
  Class lum, filter;
  const PointCloud<PointT> wanted = mapByLum<Class, PointT>(lum, scans);
  ASSERT_GT(wanted.size(), 12U * 200U);
  const PointCloud<PointT> map = mapByFilter<Class, PointT>(filter, scans);
  EXPECT_TRUE(haveSameBytes(map, wanted));
  EXPECT_EQ(filter.getReport().outcome, lum.getReport().outcome);
  EXPECT_TRUE(map.sensor_origin_.isZero());
  EXPECT_TRUE(map.sensor_orientation_.isApprox(Eigen::Quaternionf::Identity(), 0.0F));

  const IndicesPtr some(new Indices);
  for (index_t i = 100; i >= 0; i -= 2) // in this order, too
    some->push_back(i);
  std::vector<typename PointCloud<PointT>::Ptr> parts;
  for (const auto& scan : scans) {
    parts.emplace_back(new PointCloud<PointT>);
    copyPointCloud(*scan, *some, *parts.back());
  }
  Class lum_of_parts, filter_of_parts;
  EXPECT_TRUE(haveSameBytes(mapByFilter<Class, PointT>(filter_of_parts, scans, some),
                            mapByLum<Class, PointT>(lum_of_parts, parts)));
}

} // namespace pcl::acmap::test
