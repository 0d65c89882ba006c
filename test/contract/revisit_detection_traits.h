#pragma once

#include "room_views.h"
#include "shot_contract.h"

#include <pcl/egomotion/revisit_detection.h>

namespace pcl::acmap::test {

/** \brief The output is the motions of the revisits of two views. */
struct RevisitDetectionTraits : CommonTraits<RevisitDetection<PointXYZRGBSigma>> {
  static constexpr const char* header =
      "egomotion/include/pcl/egomotion/revisit_detection.h";
  using Output = std::vector<Eigen::Matrix4d>;

  static Class
  make()
  {
    Class object;
    object.setMinimumSeparation(1);
    return object;
  }

  static void
  run(Class& object, int which, Output& output)
  {
    object.clear();
    object.addPointCloud(viewOf(Room(), Eigen::Isometry3d::Identity()));
    object.addPointCloud(viewOf(Room(), poseOf({0, 0, 0.1}, 0.05 * which)));
    object.compute();
    output = motionsOf(object);
  }

  static Output
  sentinel()
  {
    return {Eigen::Matrix4d::Constant(42)};
  }

  static Calls
  refusedCalls()
  {
    return {{[](Class& o) { o.setMinimumSeparation(0); }, {"separation", "0", "views"}},
            {[](Class& o) { o.setMinimumSeparation(2000000); },
             {"separation", "2e+06", "1e+06", "views"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no view",
             [](Class& o, Output& output) {
               o.clear();
               o.compute();
               output = motionsOf(o);
             }},
            {"a loader without a cloud", [](Class& o, Output& output) {
               o.clear();
               o.addPointCloudLoader([] { return nullptr; });
               o.compute();
               output = motionsOf(o);
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << object.getMinimumSeparation() << ' ' << object.getNumberOfThreads();
    return words.str();
  }

private:
  static Output
  motionsOf(const Class& object)
  {
    Output motions;
    for (const Revisit& revisit : object.getRevisits())
      motions.push_back(revisit.estimate.T_target_source.matrix());
    return motions;
  }
};

} // namespace pcl::acmap::test
