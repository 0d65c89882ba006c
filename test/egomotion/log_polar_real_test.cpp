#include "test_data.h"

#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

const std::string folder = "C_sequence/redkitchen_000_495/frame-000";

GreyImage
greyOf(const std::string& number)
{
  const CameraImage seen =
      loadCameraImage(testDataPath(folder + number + ".color.jpg").string());
  GreyImage image{seen.width, seen.height, {}};
  for (std::size_t i = 0; i < seen.values.size(); i += 3)
    image.values.push_back(0.299F * static_cast<float>(seen.values[i]) +
                           0.587F * static_cast<float>(seen.values[i + 1]) +
                           0.114F * static_cast<float>(seen.values[i + 2]));
  return image;
}

/** Matches between two views of a kitchen, as pixels (now, before). */
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>
matchesOf(const std::string& now, const std::string& before)
{
  const GreyImage images[2] = {greyOf(now), greyOf(before)};
  LogPolarPatches patches[2];
  std::vector<std::int32_t> pixels[2];
  const LogPolarSettings settings;
  for (int i = 0; i < 2; ++i) {
    KeypointCounts counts;
    pixels[i] = gradientMaxima(
        images[i], std::vector<std::uint8_t>(images[i].values.size(), 1), {}, counts);
    patches[i] = logPolarPatches(images[i], pixels[i], settings);
  }
  MatchCounts counts;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> matches;
  const auto place = [&](int i, std::int32_t keypoint) {
    const std::int32_t pixel = pixels[i][static_cast<std::size_t>(keypoint)];
    return Eigen::Vector2d(pixel % images[i].width, pixel / images[i].width);
  };
  for (const PatchMatch& match :
       matchPatches(patches[0], patches[1], {}, {}, {}, settings, counts))
    matches.emplace_back(place(0, match.source), place(1, match.target));
  return matches;
}

/** Number of matches that move like most of their neighbours in the image. The camera
 * rotates so little between the views that the motions of neighbours differ by less
 * than 15 pixels. */
std::size_t
agreeing(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& matches)
{
  std::size_t count = 0;
  for (const auto& [now, before] : matches) {
    int near = 0, alike = 0;
    for (const auto& [other_now, other_before] : matches)
      if ((now - other_now).norm() < 80) {
        ++near;
        alike += (now - before - (other_now - other_before)).norm() < 15;
      }
    count += 2 * alike > near && near > 3;
  }
  return count;
}

TEST(LogPolarReal, neighboursOfAKitchenAgreeOnTheMove)
{
  if (!hasTestData(folder + "000.color.jpg"))
    GTEST_SKIP() << "needs redkitchen of the test data";
  for (const auto& [before, now] :
       {std::pair("000", "010"), std::pair("100", "110"), std::pair("200", "220")}) {
    const auto matches = matchesOf(now, before);
    EXPECT_GT(matches.size(), 60u) << now;
    EXPECT_GT(10 * agreeing(matches), 8 * matches.size())
        << now << ": " << agreeing(matches) << " of " << matches.size();
  }
}

} // namespace
} // namespace pcl::acmap::test
