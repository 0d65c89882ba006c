#pragma once

#include "painted_views.h"
#include "shot_contract.h"

#include <pcl/egomotion/gradient_maximum_keypoint.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief The output consists of the positions of the keypoints. */
struct GradientMaximumTraits : CommonTraits<GradientMaximumKeypoint<PointXYZRGB>> {
  static constexpr const char* header =
      "egomotion/include/pcl/egomotion/gradient_maximum_keypoint.h";
  using Output = std::vector<Eigen::Vector3f>;

  static void
  detect(Class& object, const PointCloud<PointXYZRGB>::ConstPtr& cloud, Output& output)
  {
    PointCloud<PointXYZRGB> keypoints;
    object.setInputCloud(cloud);
    object.compute(keypoints);
    output.clear();
    for (const PointXYZRGB& keypoint : keypoints)
      output.push_back(keypoint.getVector3fMap());
  }

  static void
  run(Class& object, int which, Output& output)
  {
    const Wallpaper paper(static_cast<std::uint64_t>(which));
    detect(object, wallOf(paint(paper)), output);
  }

  static Output
  sentinel()
  {
    return {Eigen::Vector3f::Constant(42)};
  }

  static Calls
  refusedCalls()
  {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    return {
        {[](Class& o) { o.setMinimumGradient(-1); }, {"-1", "[0, 1000] grey levels"}},
        {[=](Class& o) { o.setMinimumGradient(nan); },
         {"nan", "[0, 1000] grey levels"}},
        {[](Class& o) { o.setMaximumKeypoints(0); }, {"0", "[1, 1e+06] keypoints"}},
        {[](Class& o) { o.setMaximumKeypoints(2000000); }, {"2e+06", "[1, 1e+06]"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no cloud",
             [](Class& object, Output& output) { detect(object, nullptr, output); }},
            {"no image", [](Class& object, Output& output) {
               PointCloud<PointXYZRGB>::Ptr row(new PointCloud<PointXYZRGB>(100, 1));
               detect(object, row, output);
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << object.getMinimumGradient() << ' ' << object.getMaximumKeypoints() << ' '
          << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
