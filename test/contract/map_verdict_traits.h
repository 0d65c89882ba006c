#pragma once

#include "registered_clouds_traits.h"

#include <pcl/core/impl/size_text.h>
#include <pcl/mapping/map_verdict.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

struct MapVerdictTraits
: RegisteredCloudsTraits<MapVerdict, PointNormal, VerdictOutcome> {
  static constexpr const char* header = "mapping/include/pcl/mapping/map_verdict.h";

  static bool
  isOnLine(const Cloud& cloud)
  {
    constexpr float near = 1e-3F;
    std::vector<Eigen::Vector3f> off;
    for (const auto& point : cloud)
      if (point.getVector3fMap().allFinite())
        off.emplace_back(point.getVector3fMap());
    for (std::size_t i = 1; i < off.size(); ++i)
      off[i] -= off.front();
    if (!off.empty())
      off.front().setZero();
    return std::all_of(off.begin(), off.end(), [&](const Eigen::Vector3f& one) {
      return !(one.cross(off.back()).norm() > near);
    });
  }

  /** As many echoes from the walls of a square room; points that are not finite stay so. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    constexpr double half = 3; // metres
    if (isOnLine(cloud)) {
      addTwice(object, cloud, [](PointNormal& point) {
        if (point.getVector3fMap().allFinite())
          point.y = 0;
      });
      return;
    }
    std::size_t echo = 0;
    const double step = 2 * M_PI / static_cast<double>(2 * cloud.size() + 1);
    addTwice(object, cloud, [&](PointNormal& point) {
      const double angle = step * static_cast<double>(echo++);
      const double range =
          half / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
      if (point.getVector3fMap().allFinite())
        point.getVector3fMap() << static_cast<float>(range * std::sin(angle)), 0,
            static_cast<float>(range * std::cos(angle));
    });
  }

  static void
  run(Class& object, Output& output)
  {
    object.compute();
    output.poses.clear();
    output.outcome = object.getReport().outcome;
    output.reason = shortNumber(object.getReport().e95);
    for (const std::string& reason : object.getReport().reasons)
      output.reason += "; " + reason;
  }

  static Output
  sentinel()
  {
    return {{}, VerdictOutcome::Contradicted, "no run"};
  }

  static Calls
  refusedCalls()
  {
    return refusedNoiseAndPose();
  }

  static std::string
  parameters(const Class& object)
  {
    return "noise " + textOf(object.getOdometryNoise()) + ", seed " +
           std::to_string(object.getSeed()) + ", up " +
           shortNumber(object.getUpDirection().y()) + ", threads " +
           std::to_string(object.getNumberOfThreads());
  }
};

} // namespace pcl::acmap::test
