#include "lit_scenes.h"

#include <pcl/core/random.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** A wall with grain at 2 m, seen from two positions by a camera that carries a
 * projector: with and without its pattern. */
class PatternedLight : public testing::Test {
protected:
  struct Judgement {
    std::size_t right = 0;  ///< move like the wall
    std::size_t misled = 0; ///< move like the pattern, that is, not at all
    std::size_t matches = 0;
  };

  static SimulatedScene
  scene()
  {
    SimulatedScene scene = wallAt(2);
    scene.rig = smallRig(320);
    scene.geometry = {};
    scene.geometry.addRectangle(
        "wall", "wall", {{-5, 5, 2}, {10, 0, 0}, {0, -10, 0}}, {{120, 120, 120}, 5});
    scene.views.push_back(Eigen::Isometry3d(Eigen::Translation3d(step, 0, 0)));
    return scene;
  }

  /** Bright lines at irregular positions in both directions. */
  static RgbImage
  lines(const SimulatedProjector& projector)
  {
    Random random(3);
    RgbImage image = flatPattern(projector, 40);
    for (int line = 0; line < 160; ++line) {
      const bool upright = line % 2 == 0;
      const int length = upright ? image.height : image.width;
      const int across = upright ? image.width : image.height;
      const int at = static_cast<int>(random.uniform(0, across - 0.001));
      for (int i = 0; i < length; ++i)
        for (int channel = 0; channel < 3; ++channel)
          image.at(upright ? at : i, upright ? i : at)[channel] = 220;
    }
    return image;
  }

  Judgement
  judge(std::int32_t pattern) const
  {
    const GreyImage before = imageOf(0, pattern), now = imageOf(1, pattern);
    const std::vector<std::int32_t> source = keypointsOf(now);
    const std::vector<std::int32_t> target = keypointsOf(before);
    const std::vector<Eigen::Vector3f> nowhere(std::max(source.size(), target.size()),
                                               Eigen::Vector3f::Zero());
    const LogPolarSettings settings;
    MatchCounts counts;
    Judgement judgement;
    for (const PatchMatch& match :
         matchPatches(logPolarPatches(now, source, settings),
                      logPolarPatches(before, target, settings),
                      nowhere,
                      nowhere,
                      {},
                      settings,
                      counts)) {
      const std::int32_t from = target[static_cast<std::size_t>(match.target)];
      const std::int32_t to = source[static_cast<std::size_t>(match.source)];
      const double right = from % 320 - to % 320, down = to / 320 - from / 320;
      judgement.right += std::hypot(right - step * 260 / 2, down) < 2.5;
      judgement.misled += std::hypot(right, down) < 2.5;
      ++judgement.matches;
    }
    return judgement;
  }

private:
  static std::vector<std::int32_t>
  keypointsOf(const GreyImage& image)
  {
    KeypointSettings settings;
    settings.maximum = 400;
    KeypointCounts counts;
    return gradientMaxima(
        image, std::vector<std::uint8_t>(image.values.size(), 1), settings, counts);
  }

  GreyImage
  imageOf(std::size_t view, std::int32_t pattern) const
  {
    for (const TrinocularFrame::Ptr& frame : grabber_.observe(view))
      if (frame->pattern == pattern) {
        const CameraImage& seen = frame->images[0];
        GreyImage image{seen.width, seen.height, {}};
        for (std::size_t i = 0; i < seen.values.size();
             i += static_cast<std::size_t>(seen.channels))
          image.values.push_back(seen.values[i]);
        return image;
      }
    ADD_FAILURE() << "no such shot";
    return {};
  }

  static constexpr double step = 0.12; // metres
  const SimulatedLight light_ = plainLight();
  const SimulatedRigGrabber grabber_{scene(), {lines(light_.projector)}, light_};
};

TEST_F(PatternedLight, misleads)
{
  const Judgement judgement = judge(0);
  EXPECT_GT(judgement.misled, 30u);
  EXPECT_GT(judgement.misled, 4 * judgement.right);
}

TEST_F(PatternedLight, doesNotMisleadWhereItIsOff)
{
  const Judgement judgement = judge(TrinocularFrame::no_pattern);
  EXPECT_GT(judgement.right, 50u);
  EXPECT_GE(20 * judgement.right, 19 * judgement.matches);
  EXPECT_LE(20 * judgement.misled, judgement.right);
}

} // namespace
} // namespace pcl::acmap::test
