#pragma once

#include "contract.h"

#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace pcl::acmap::test {

struct CylinderHypothesisClusteringTraits
: CommonTraits<CylinderHypothesisClustering<PointXYZ>> {
  static constexpr const char* header =
      "segmentation/include/pcl/segmentation/cylinder_hypothesis_clustering.h";

  struct Output : std::vector<CylinderPatch> {
    /** Compares bytes, as covariances may be NaN. */
    bool
    operator==(const Output& other) const
    {
      return std::equal(begin(), end(), other.begin(), other.end(), areSame);
    }

    static bool
    areSame(const CylinderPatch& a, const CylinderPatch& b)
    {
      return a.axis_point == b.axis_point && a.axis_direction == b.axis_direction &&
             a.radius == b.radius && a.is_hollow == b.is_hollow &&
             a.axis_u == b.axis_u && a.low == b.low && a.high == b.high &&
             a.arc == b.arc && a.support == b.support && a.rms == b.rms &&
             a.area == b.area && a.planes == b.planes &&
             std::memcmp(&a.covariance, &b.covariance, sizeof a.covariance) == 0;
    }
  };

  /** Rolls up the cloud, so that a sheet becomes a part of a cylinder. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    constexpr float radius = 0.3F;
    const auto rolled = cloud.makeShared();
    for (PointXYZ& point : *rolled) {
      const float angle = point.x / radius, distance = radius + point.z;
      point.x = distance * std::sin(angle);
      point.z = distance * std::cos(angle);
    }
    object.setInputCloud(rolled);
  }

  static void
  run(Class& object, Output& output)
  {
    object.segment(static_cast<std::vector<CylinderPatch>&>(output));
  }

  static Output
  sentinel()
  {
    Output output;
    output.resize(2);
    output[1].support = 42;
    return output;
  }

  static Calls
  refusedCalls()
  {
    const auto setMinimum = [](Class& object, double value) {
      object.setRadiusLimits(value, 1);
    };
    const auto setMaximum = [](Class& object, double value) {
      object.setRadiusLimits(0.25, value);
    };
    Calls calls;
    refuse(calls, setMinimum, nonsense, {"minimum radius", "[0,", " m"});
    refuse(calls, setMaximum, nonsense, {"maximum radius", "[0.25,", " m"});
    refuse(calls, &Class::setNoise, nonsense, {"noise", "[0,", " m"});
    calls.push_back({[](Class& object) {
                       const Cloud::ConstPtr source(new Cloud);
                       object.setSourceCloud(
                           source, {{0, std::numeric_limits<float>::quiet_NaN(), 0}});
                     },
                     {"nan", "[-1e+09,", " m"}});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    double min_radius = 0, max_radius = 0;
    object.getRadiusLimits(min_radius, max_radius);
    std::ostringstream words;
    words << "radius " << min_radius << ' ' << max_radius << ", noise "
          << object.getNoise() << ", threads " << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
