#pragma once

#include "registered_clouds_traits.h"

#include <pcl/mapping/entropy_rectification.h>

namespace pcl::acmap::test {

struct EntropyRectificationTraits
: RegisteredCloudsTraits<EntropyRectification, PointNormal, RectificationOutcome> {
  static constexpr const char* header =
      "mapping/include/pcl/mapping/entropy_rectification.h";

  static void
  setInput(Class& object, const Cloud& cloud)
  {
    addTwice(object, cloud, [](PointNormal& point) {
      point.getNormalVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
    });
  }

  static Calls
  refusedCalls()
  {
    Calls calls = refusedNoiseAndPose();
    refuse(calls, &Class::setBinSize, nonsense, {"bin size", "[0.001, 25]", " m"});
    refuse(calls,
           &Class::setEntropyWeight,
           nonsense,
           {"entropy weight", "[0.001, 1000]", "no unit"});
    refuse(
        calls, &Class::setProjectionWeight, nonsense, {"mu", "[0, 1000]", "no unit"});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "bin " << object.getBinSize() << ", weight " << object.getEntropyWeight()
          << ", mu " << object.getProjectionWeight().value_or(-1) << ", "
          << textOf(object.getOdometryNoise()) << ", mode "
          << static_cast<int>(object.getMode()) << ", seed " << object.getSeed()
          << ", threads " << object.getNumberOfThreads();
    return words.str();
  }
};

/** \brief The same by the calls of a filter. */
struct RectifyingFilterTraits : EntropyRectificationTraits {
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    EntropyRectificationTraits::setInput(object, cloud);
    const auto observation = object.getTransformedCloud(0);
    object.clear();
    object.addPointCloud(observation, Eigen::Isometry3d::Identity());
    object.setInputCloud(observation);
  }

  static void
  run(Class& object, Output& output)
  {
    PointCloud<PointNormal> map;
    object.filter(map);
    output = {{}, object.getReport().outcome, object.getReport().reason};
    for (std::size_t i = 0; i < object.getNumberOfPointClouds(); ++i)
      output.poses.push_back(object.getPose(i).matrix());
  }
};

} // namespace pcl::acmap::test
