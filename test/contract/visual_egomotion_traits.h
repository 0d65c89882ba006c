#pragma once

#include "room_views.h"
#include "shot_contract.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief The output is the motion; empty if there is none. */
struct VisualEgomotionTraits : CommonTraits<VisualEgomotion<PointXYZRGBSigma>> {
  static constexpr const char* header =
      "egomotion/include/pcl/egomotion/visual_egomotion.h";
  using Output = Eigen::Matrix4d;

  static void
  run(Class& object, int which, Output& output)
  {
    object.setInputTarget(viewOf(Room(), Eigen::Isometry3d::Identity()));
    object.setInputSource(viewOf(Room(), poseOf({0, 0, 0.1}, 0.05 * which)));
    const auto estimate = object.compute();
    output = estimate ? estimate->T_target_source.matrix() : Output::Identity();
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
    return {{[](Class& o) { o.setMaximumTranslation(0); },
             {"translation", "0", "0.001", "m"}},
            {[=](Class& o) { o.setMaximumTranslation(nan); }, {"translation", "nan"}},
            {[](Class& o) { o.setMaximumRotation(-1); }, {"rotation", "-1", "rad"}},
            {[](Class& o) { o.setMaximumRotation(4); }, {"rotation", "4", "rad"}},
            {[](Class& o) { o.setMaximumKeypoints(9); },
             {"keypoints", "9", "10", "100000"}},
            {[](Class& o) { o.setMaximumShifts(11, 0); }, {"ring", "11", "10"}},
            {[](Class& o) { o.setMaximumShifts(0, -1); }, {"sector", "-1", "12"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    using Cloud = PointCloud<PointXYZRGBSigma>;
    const auto runOn =
        [](Class& object, const Cloud::ConstPtr& target, Output& output) {
          object.setInputSource(viewOf(Room(), Eigen::Isometry3d::Identity()));
          object.setInputTarget(target);
          if (const auto estimate = object.compute())
            output = estimate->T_target_source.matrix();
        };
    return {{"no target", [=](Class& o, Output& output) { runOn(o, nullptr, output); }},
            {"an unorganized target", [=](Class& o, Output& output) {
               runOn(o, Cloud::Ptr(new Cloud(100, 1)), output);
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << static_cast<int>(object.getMotionModel()) << ' '
          << static_cast<int>(object.getSolver()) << ' '
          << object.getMaximumTranslation() << ' ' << object.getMaximumRotation() << ' '
          << object.getMaximumKeypoints() << ' ' << object.getRefinement() << ' '
          << object.getPaperMode() << ' ' << object.getMaximumRingShifts() << ' '
          << object.getMaximumSectorShifts() << ' ' << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
