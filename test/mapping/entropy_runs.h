#pragma once

#include "naive_entropy.h"

#include <pcl/mapping/map_entropy.h>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {

inline MapEntropy<PointNormal>
entropyOf(const PosedClouds& map, const NaiveEntropySettings& settings)
{
  MapEntropy<PointNormal> entropy;
  entropy.setBinSize(settings.bin);
  entropy.setSmoothing(settings.sigma);
  entropy.setProjectionWeight(settings.mu);
  entropy.setDirectionAware(settings.directions);
  for (std::size_t i = 0; i < map.clouds.size(); ++i)
    entropy.addPointCloud(map.clouds[i], map.poses[i]);
  return entropy;
}

/** \brief A cloud of points at given positions (x, z). */
inline PointCloud<PointNormal>::Ptr
cloudAt(const std::vector<Eigen::Vector2d>& places)
{
  PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
  for (const Eigen::Vector2d& place : places) {
    cloud->push_back(PointNormal());
    cloud->back().getVector3fMap() =
        Eigen::Vector3d(place[0], 0, place[1]).cast<float>();
    cloud->back().getNormalVector3fMap().setConstant(std::nanf(""));
  }
  return cloud;
}

/** \brief A pose with a change of x (axis 0), z (1) or theta (2). */
inline PlanarPose
shifted(PlanarPose pose, int axis, double by)
{
  (axis == 0 ? pose.x : axis == 1 ? pose.z : pose.theta) += by;
  return pose;
}

/** \brief Compares bytes, not values. */
inline bool
areSame(const MapEntropyTerms& a, const MapEntropyTerms& b)
{
  return std::memcmp(&a.total, &b.total, sizeof(double)) == 0 &&
         std::memcmp(&a.joint, &b.joint, sizeof(double)) == 0 &&
         std::memcmp(&a.along_x, &b.along_x, sizeof(double)) == 0 &&
         std::memcmp(&a.along_z, &b.along_z, sizeof(double)) == 0 &&
         a.points == b.points && a.dimensions == b.dimensions;
}

} // namespace pcl::acmap::test
