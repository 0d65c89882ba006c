#pragma once

#include <pcl/core/random.h>
#include <pcl/stereo/disparity_fusion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::test {

constexpr std::array<DisparityFusion::Method, 3> fusion_methods = {
    DisparityFusion::Method::Median,
    DisparityFusion::Method::Statistical,
    DisparityFusion::Method::SpaceTime};

inline TrinocularRig
tinyRig()
{
  TrinocularRig rig;
  rig.width = 48;
  rig.height = 36;
  rig.focal_length = 40;
  rig.center_x = 23.5;
  rig.center_y = 17.5;
  return rig;
}

inline CameraImage
flatImage(std::uint8_t value, int channels = 1)
{
  return {
      48,
      36,
      channels,
      std::vector<std::uint8_t>(static_cast<std::size_t>(48 * 36 * channels), value)};
}

/** The same image for all cameras: a wall at infinity. */
inline TrinocularFrame::Ptr
shotOf(const CameraImage& image, int pattern)
{
  auto shot = std::make_shared<TrinocularFrame>();
  shot->pattern = pattern;
  shot->images.fill(image);
  return shot;
}

inline TrinocularFrame::Ptr
noiseShot(int pattern)
{
  Random random(static_cast<std::uint64_t>(pattern) + 7);
  CameraImage image = flatImage(0);
  for (std::uint8_t& value : image.values)
    value = static_cast<std::uint8_t>(random.bits());
  return shotOf(image, pattern);
}

inline TrinocularFrame::Ptr
noiseWithoutPattern()
{
  const auto shot = noiseShot(1);
  shot->pattern = TrinocularFrame::no_pattern;
  return shot;
}

inline DisparityFusion
fusionBy(DisparityFusion::Method method)
{
  DisparityFusion fusion;
  TrinocularMatching matching;
  matching.setMaxDisparity(8);
  fusion.setMatching(matching);
  fusion.setMethod(method);
  fusion.setInputRig(tinyRig());
  return fusion;
}

/** A fusion with some shots; all of them are used. */
inline DisparityFusion
fusionOf(DisparityFusion::Method method, int shots)
{
  DisparityFusion fusion = fusionBy(method);
  for (int i = 0; i < shots; ++i)
    fusion.addShot(noiseShot(i));
  return fusion;
}

inline MatchedDisparity
fused(DisparityFusion& fusion)
{
  MatchedDisparity result;
  fusion.fuse(result);
  return result;
}

inline void
expectSame(const MatchedDisparity& a, const MatchedDisparity& b)
{
  const auto isSame = [](float x, float y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  };
  const auto areSame = [&](const std::vector<float>& x, const std::vector<float>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), isSame);
  };
  EXPECT_TRUE(areSame(a.disparity.values, b.disparity.values));
  EXPECT_TRUE(areSame(a.sigma, b.sigma));
  EXPECT_EQ(a.support, b.support);
  EXPECT_EQ(a.outcome, b.outcome);
}

} // namespace pcl::acmap::test
