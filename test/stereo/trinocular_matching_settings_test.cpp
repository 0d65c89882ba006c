#include "matched_checks.h"
#include "synthetic_shots.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <array>

namespace pcl::acmap::test {
namespace {

/** Random settings, rigs and images, most of them unusual. */
class RandomRun {
public:
  explicit RandomRun(std::uint64_t seed)
  : random_(seed)
  {
    rig_ = syntheticRig(baseline(), 0);
    do
      rig_.baseline_vertical = baseline();
    while (rig_.baseline_horizontal == 0 && rig_.baseline_vertical == 0);
    rig_.width = whole(1, 90);
    rig_.height = whole(1, 70);
  }

  TrinocularMatching
  matching()
  {
    TrinocularMatching matching;
    matching.setInputRig(rig_);
    matching.setXOffset(whole(0, whole(0, 3) ? 20 : 4095));
    matching.setMaxDisparity(whole(8, whole(0, 5) ? 70 : 1024));
    matching.setRatioFilter(whole(0, 1) * whole(0, 100));
    if (whole(0, 1))
      matching.setPeakFilter(whole(0, 20));
    if (whole(0, 1))
      matching.setCorrelationThreshold(random_.uniform(-1, 1));
    matching.setLeftRightCheck(whole(0, 2) != 0);
    matching.setLeftRightCheckThreshold(whole(0, 16));
    matching.setPairAgreement(random_.uniform(0.1, 16));
    matching.setRequirePairAgreement(whole(0, 1) != 0);
    return matching;
  }

  std::vector<TrinocularFrame::Ptr>
  shots()
  {
    auto shots = shotsOf(flatScene(rig_, whole(0, 30)), whole(1, 7));
    const int kind = whole(0, 4);
    for (std::size_t shot = 0; kind > 0 && shot < shots.size(); ++shot)
      for (CameraImage& image : shots[shot]->images)
        fill(image, kind, shot);
    return shots;
  }

private:
  int
  whole(int minimum, int maximum)
  {
    return minimum + static_cast<int>(random_.bits() % static_cast<std::uint64_t>(
                                                           maximum - minimum + 1));
  }

  double
  baseline()
  {
    constexpr std::array<double, 6> all = {-0.1, 0.1, 0.0, -0.05, 0.13, 0.0301};
    return all[static_cast<std::size_t>(whole(0, 5))];
  }

  /** Noise, black and white pixels, black and white shots in turn, or nearly uniform;
   * grey or in colour. */
  void
  fill(CameraImage& image, int kind, std::size_t shot)
  {
    if (!image.empty() && whole(0, 1)) {
      image.channels = 3;
      image.values.resize(3 * image.values.size());
    }
    for (std::uint8_t& value : image.values) {
      const auto bits = static_cast<std::uint8_t>(random_.bits());
      const std::array<int, 4> levels = {
          bits, bits % 2 * 255, shot % 2 ? 255 : 0, 100 + bits % 2};
      value = static_cast<std::uint8_t>(levels[static_cast<std::size_t>(kind - 1)]);
    }
  }

  Random random_;
  TrinocularRig rig_;
};

TEST(TrinocularMatchingSettings, AnyGiveASoundResultOnAnyNumberOfThreads)
{
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    RandomRun run(seed);
    TrinocularMatching matching = run.matching();
    const auto shots = run.shots();
    const MatchedDisparity matched = matchSoundly(matching, shots);
    matching.setNumberOfThreads(3);
    EXPECT_TRUE(isSame(matchSoundly(matching, shots), matched));
    if (HasFailure())
      break;
  }
}

} // namespace
} // namespace pcl::acmap::test
