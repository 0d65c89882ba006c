#pragma once

#include "contract.h"

#include <pcl/common/io.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Geometry>

#include <cstring>

namespace pcl::acmap::test {

/** \brief What the traits of EntropyRectification and PlaneAdjustment have in common. Each
 * cloud is added twice, because one observation alone is never determined. */
template <template <typename> class ClassT, typename Point, typename Outcome>
struct RegisteredCloudsTraits : CommonTraits<ClassT<Point>> {
  using typename CommonTraits<ClassT<Point>>::Calls;
  using typename CommonTraits<ClassT<Point>>::Class;

  struct Output {
    std::vector<Eigen::Matrix4d> poses;
    Outcome outcome = Outcome::Undetermined;
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

  /** \param[in] change of each point */
  template <typename Change>
  static void
  addTwice(Class& object, const Cloud& cloud, const Change& change)
  {
    const typename PointCloud<Point>::Ptr input(new PointCloud<Point>);
    copyPointCloud(cloud, *input);
    for (Point& point : *input)
      change(point);
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

  /** Was the result undetermined? */
  static bool
  isEmpty(const Output& output)
  {
    return output.outcome == Outcome::Undetermined;
  }

  static Output
  sentinel()
  {
    return {std::vector<Eigen::Matrix4d>(7, Eigen::Matrix4d::Zero()),
            Outcome::Refused,
            "no run"};
  }

  static Calls
  refusedNoiseAndPose()
  {
    Calls calls;
    for (int field = 0; field < 4; ++field)
      CommonTraits<Class>::refuse(calls,
                                  [field](Class& object, double bad) {
                                    OdometryNoise noise;
                                    (field == 0   ? noise.length
                                     : field == 1 ? noise.length_per_metre
                                     : field == 2 ? noise.turn
                                                  : noise.turn_per_radian) = bad;
                                    object.setOdometryNoise(noise);
                                  },
                                  nonsense,
                                  {"odometry noise", field < 2 ? " m" : " rad"});
    calls.push_back({[](Class& object) {
                       Eigen::Isometry3d mirror = Eigen::Isometry3d::Identity();
                       mirror.matrix()(0, 0) = -1;
                       object.addPointCloud(std::make_shared<PointCloud<Point>>(),
                                            mirror);
                     },
                     {"rigid motion", "mirrors"}});
    return calls;
  }

  static std::string
  textOf(const OdometryNoise& noise)
  {
    std::ostringstream words;
    words << "noise " << noise.length << ' ' << noise.length_per_metre << ' '
          << noise.turn << ' ' << noise.turn_per_radian;
    return words.str();
  }

  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points / 2;
  }
};

} // namespace pcl::acmap::test
