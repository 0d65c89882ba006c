#pragma once

#include "registered_clouds_traits.h"

#include <pcl/mapping/plane_adjustment.h>

namespace pcl::acmap::test {

struct PlaneAdjustmentTraits
: RegisteredCloudsTraits<PlaneAdjustment, PointXYZ, AdjustmentOutcome> {
  static constexpr const char* header =
      "mapping/include/pcl/mapping/plane_adjustment.h";

  /** At a distance, because a plane through the sensor cannot be seen. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    addTwice(object, cloud, [](PointXYZ& point) { point.z += 3; });
  }

  static Calls
  refusedCalls()
  {
    Calls calls = refusedNoiseAndPose();
    calls.push_back({[](Class& object) {
                       object.setActionCovariances({acmap::ActionCovariance::Zero()});
                     },
                     {"positive definite", "rad^2"}});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << textOf(object.getOdometryNoise()) << ", covariances "
          << object.getActionCovariances().size() << ", estimated "
          << object.getEstimateOdometryNoise() << ", threads "
          << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
