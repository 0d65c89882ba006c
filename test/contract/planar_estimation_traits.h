#pragma once

#include "shot_contract.h"
#include "stereo_matches.h"

#include <pcl/egomotion/transformation_estimation_planar.h>
#include <pcl/point_types.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief The output is the motion; empty if it is the identity. */
struct PlanarEstimationTraits
: CommonTraits<registration::TransformationEstimationPlanar<PointXYZ, PointXYZ>> {
  static constexpr const char* header =
      "egomotion/include/pcl/egomotion/transformation_estimation_planar.h";
  using Output = Eigen::Matrix4f;

  static void
  run(Class& object, int which, Output& output)
  {
    PointCloud<PointXYZ> source, target;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d place(corner & 1, corner >> 1 & 1, corner >> 2);
      source.push_back(pointAt(place));
      target.push_back(pointAt(planarMotion(0.1, 0.2, 0.3 + which) * place));
    }
    object.estimateRigidTransformation(source, target, output);
  }

  static PointXYZ
  pointAt(const Eigen::Vector3d& place)
  {
    PointXYZ point;
    point.getVector3fMap() = place.cast<float>();
    return point;
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.isIdentity();
  }

  static Output
  sentinel()
  {
    return Output::Constant(42);
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {
        {[](Class& o) {
           o.setCorrespondenceWeights({1, -2});
         },
         {"weight", "-2", "[0, "}},
        {[=](Class& o) { o.setCorrespondenceWeights({nan}); }, {"weight", "nan"}},
        {[=](Class& o) { o.setCorrespondenceWeights({infinity}); }, {"weight", "inf"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    const PointCloud<PointXYZ> cloud(3, 1);
    return {{"fewer target points",
             [=](Class& o, Output& output) {
               o.estimateRigidTransformation(cloud, Indices{0, 1}, cloud, output);
             }},
            {"an index outside",
             [=](Class& o, Output& output) {
               o.estimateRigidTransformation(cloud, Indices{0, 1, 3}, cloud, output);
             }},
            {"a match outside", [=](Class& o, Output& output) {
               const Correspondences matches{Correspondence(0, 3, 0)};
               o.estimateRigidTransformation(cloud, cloud, matches, output);
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << static_cast<int>(object.getMotionModel()) << ' '
          << static_cast<int>(object.getSolver());
    for (const double weight : object.getCorrespondenceWeights())
      words << ' ' << weight;
    return words.str();
  }
};

} // namespace pcl::acmap::test
