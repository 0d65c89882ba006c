#pragma once

#include "contract.h"

#include <pcl/mapping/plane_adjustment.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace pcl::acmap::test {

struct PlaneAdjustmentTraits {
  using Class = PlaneAdjustment<PointXYZ>;

  struct Output {
    std::vector<Eigen::Matrix4d> poses;
    AdjustmentOutcome outcome = AdjustmentOutcome::Undetermined;
    std::string reason;

    /** Compares bytes. */
    bool
    operator==(const Output& other) const
    {
      if (poses.size() != other.poses.size())
        return false;
      for (std::size_t i = 0; i < poses.size(); ++i)
        if (std::memcmp(
                poses[i].data(), other.poses[i].data(), sizeof(Eigen::Matrix4d)) != 0)
          return false;
      return outcome == other.outcome && reason == other.reason;
    }
  };

  /** Adds the same cloud twice, because one view alone is never determined, at a
   * distance, because a plane through the sensor cannot be seen. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    const PointCloud<PointXYZ>::Ptr input(new PointCloud<PointXYZ>(cloud));
    for (PointXYZ& point : *input)
      point.z += 3;
    object.clear();
    object.addPointCloud(input, Eigen::Isometry3d::Identity());
    object.addPointCloud(input, Eigen::Isometry3d::Identity());
  }

  static void
  run(Class& object, Output& output)
  {
    object.compute();
    output.poses.clear();
    for (std::size_t i = 0; i < object.getNumberOfPointClouds(); ++i)
      output.poses.push_back(object.getPose(i).matrix());
    output.outcome = object.getReport().outcome;
    output.reason = object.getReport().reason;
  }

  /** Was the adjustment undetermined? */
  static bool
  isEmpty(const Output& output)
  {
    return output.outcome == AdjustmentOutcome::Undetermined;
  }

  static Output
  sentinel()
  {
    return {std::vector<Eigen::Matrix4d>(7, Eigen::Matrix4d::Zero()),
            AdjustmentOutcome::Refused,
            "no run"};
  }

  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<RefusedCall<Class>> calls;
    for (const auto& [value, word] :
         {std::pair(-0.5, "-0.5"), std::pair(nan, "nan"), std::pair(infinity, "inf")})
      for (int field = 0; field < 4; ++field) {
        const double bad = value;
        calls.push_back({[bad, field](Class& object) {
                           OdometryNoise noise;
                           (field == 0   ? noise.length
                            : field == 1 ? noise.length_per_metre
                            : field == 2 ? noise.turn
                                         : noise.turn_per_radian) = bad;
                           object.setOdometryNoise(noise);
                         },
                         {"odometry noise", word, field < 2 ? " m" : " rad"}});
      }
    calls.push_back({[](Class& object) {
                       object.setActionCovariances({acmap::ActionCovariance::Zero()});
                     },
                     {"positive definite", "rad^2"}});
    calls.push_back({[](Class& object) {
                       Eigen::Isometry3d mirror = Eigen::Isometry3d::Identity();
                       mirror.matrix()(0, 0) = -1;
                       object.addPointCloud(std::make_shared<PointCloud<PointXYZ>>(),
                                            mirror);
                     },
                     {"rigid motion", "1e9 m"}});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    const OdometryNoise& noise = object.getOdometryNoise();
    std::ostringstream words;
    words << "noise " << noise.length << ' ' << noise.length_per_metre << ' '
          << noise.turn << ' ' << noise.turn_per_radian << ", covariances "
          << object.getActionCovariances().size() << ", estimated "
          << object.getEstimateOdometryNoise() << ", threads "
          << object.getNumberOfThreads();
    return words.str();
  }

  /** Each cloud was added twice. */
  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points / 2;
  }

  static std::string
  header()
  {
    std::ifstream file(ACMAP_SOURCE_DIR
                       "/modules/mapping/include/pcl/mapping/plane_adjustment.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
