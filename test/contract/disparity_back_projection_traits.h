#pragma once

#include "shot_contract.h"

#include <pcl/core/random.h>
#include <pcl/stereo/disparity_back_projection.h>

#include <array>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {

/** \brief The output is compared bitwise, as missing points are NaN. */
struct DisparityBackProjectionTraits : CommonTraits<DisparityBackProjection> {
  static constexpr const char* header =
      "stereo/include/pcl/stereo/disparity_back_projection.h";
  using Output = std::vector<std::array<std::uint32_t, 5>>;

  static Class
  make()
  {
    Class object;
    object.setInputRig({});
    return object;
  }

  static MatchedDisparity
  noise(std::uint64_t seed)
  {
    Random random(seed);
    MatchedDisparity matched;
    matched.disparity = {640, 480, {}};
    for (int i = 0; i < 640 * 480; ++i) {
      matched.disparity.values.push_back(static_cast<float>(random.uniform(-1, 50)));
      matched.sigma.push_back(static_cast<float>(random.uniform(0, 1)));
    }
    matched.disparity.values[seed] = std::numeric_limits<float>::quiet_NaN();
    return matched;
  }

  static void
  run(Class& object, int which, Output& output)
  {
    project(object, noise(static_cast<std::uint64_t>(which)), output);
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.size() != 640 * 480;
  }

  static Output
  sentinel()
  {
    return {{7, 7, 7, 7, 7}};
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {
        {[](Class& o) { o.setMinimumDepth(-1); }, {"minimum", "-1", "[0, 10000] m"}},
        {[](Class& o) { o.setMinimumDepth(nan); }, {"minimum", "nan", "[0, 10000] m"}},
        {[](Class& o) { o.setMaximumDepth(0); }, {"maximum", "0", "[0.01, 10000] m"}},
        {[](Class& o) { o.setMaximumDepth(2e4); }, {"maximum", "20000", " m"}},
        {[](Class& o) {
           TrinocularRig rig;
           rig.focal_length = -3;
           o.setInputRig(rig);
         },
         {"focal_length", "-3", " px"}},
        {[](Class& o) {
           TrinocularRig rig;
           rig.baseline_horizontal = rig.baseline_vertical = 0;
           o.setInputRig(rig);
         },
         {"neighbour", "0 m"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no rig",
             [](Class&, Output& output) {
               Class object;
               project(object, noise(1), output);
             }},
            {"another size", [](Class& object, Output& output) {
               MatchedDisparity matched = noise(1);
               matched.disparity.width = 320;
               project(object, matched, output);
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "focal length " << object.getInputRig().focal_length << ", depths "
          << object.getMinimumDepth() << " to " << object.getMaximumDepth()
          << ", threads " << object.getNumberOfThreads();
    return words.str();
  }

private:
  static void
  project(Class& object, const MatchedDisparity& matched, Output& output)
  {
    PointCloud<PointXYZRGBSigma> cloud;
    object.project(matched, {}, cloud);
    Output bits;
    for (const PointXYZRGBSigma& point : cloud) {
      const std::array<float, 5> values{
          point.x, point.y, point.z, point.rgb, point.sigma};
      std::memcpy(bits.emplace_back().data(), values.data(), sizeof(values));
    }
    output = std::move(bits);
  }
};

} // namespace pcl::acmap::test
