#pragma once

#include "contract.h"

#include <pcl/common/io.h>
#include <pcl/mapping/map_levelling.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace pcl::acmap::test {

struct MapLevellingTraits : CommonTraits<MapLevelling<PointNormal>> {
  static constexpr const char* header = "mapping/include/pcl/mapping/map_levelling.h";

  struct Output {
    Eigen::Matrix4d pose = Eigen::Matrix4d::Zero();
    bool found = false;
    std::string reason;

    bool
    operator==(const Output& other) const
    {
      return pose == other.pose && found == other.found && reason == other.reason;
    }
  };

  /** The normal of the plane through all points; NaN for points on a line. */
  static Eigen::Vector3f
  normalOf(const Cloud& cloud)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double count = 0;
    for (const PointXYZ& place : cloud) {
      const Eigen::Vector3d p = place.getVector3fMap().cast<double>();
      if (!p.allFinite())
        continue;
      sum += p;
      squares += p * p.transpose();
      ++count;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        squares / count - sum * sum.transpose() / (count * count));
    const Eigen::Vector3d extents = solver.eigenvalues();
    if (!(extents[1] > 1e-6 * extents[2]))
      return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    return solver.eigenvectors().col(0).cast<float>();
  }

  static void
  setInput(Class& object, const Cloud& cloud)
  {
    const PointCloud<PointNormal>::Ptr input(new PointCloud<PointNormal>);
    copyPointCloud(cloud, *input);
    const Eigen::Vector3f normal = normalOf(cloud);
    for (PointNormal& point : *input)
      point.getNormalVector3fMap() = normal;
    object.clear();
    object.addPointCloud(input, Eigen::Isometry3d::Identity());
  }

  static void
  run(Class& object, Output& output)
  {
    object.compute();
    output = {object.getPose(0).matrix(),
              object.getReport().found,
              object.getReport().reason};
  }

  static bool
  isEmpty(const Output& output)
  {
    return !output.found;
  }

  static Output
  sentinel()
  {
    return {Eigen::Matrix4d::Constant(7), false, "no run"};
  }

  static Calls
  refusedCalls()
  {
    return {{[](Class& object) { object.setUpDirection(Eigen::Vector3d::Zero()); },
             {"up direction", "finite", "not zero"}},
            {[](Class& object) {
               object.setUpDirection({0, std::nan(""), 0});
             },
             {"up direction", "finite"}},
            {[](Class& object) {
               object.addPointCloud(nullptr, Eigen::Isometry3d::Identity());
             },
             {"cloud"}}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    if (object.getUpDirection())
      words << object.getUpDirection()->transpose() << ", ";
    words << "threads " << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
