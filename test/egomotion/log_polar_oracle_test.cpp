#include "painted_views.h"

#include "log_polar/normalized_samples.h"
#include "log_polar/score_table.h"
#include "simd/score_kernels.h"

#include <pcl/core/impl/simd_choice.h>
#include <pcl/core/random.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Samples = std::vector<double>;

/** Pearson's correlation coefficient, by its definition. */
double
pearson(const Samples& a, const Samples& b)
{
  const double n = static_cast<double>(a.size());
  double sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum_a += a[k];
    sum_b += b[k];
    aa += a[k] * a[k];
    bb += b[k] * b[k];
    ab += a[k] * b[k];
  }
  return (n * ab - sum_a * sum_b) /
         std::sqrt((n * aa - sum_a * sum_a) * (n * bb - sum_b * sum_b));
}

/** An image with its keypoints. */
struct PatchSide {
  std::vector<std::int32_t> pixels;
  std::vector<Eigen::Vector3f> points;
  LogPolarPatches patches;
};

/** Straightforward matching: every pair, every shift, every threshold. */
class NaiveMatching {
public:
  NaiveMatching(const LogPolarSettings& settings, const MatchGate& gate)
  : settings_(settings)
  , gate_(gate)
  {}

  /** Pairs of keypoints, sorted by source. */
  std::vector<std::pair<int, int>>
  match(const PatchSide& source, const PatchSide& target) const
  {
    const std::size_t n = source.patches.pixels.size();
    const std::size_t m = target.patches.pixels.size();
    std::vector<std::vector<double>> scores(n, std::vector<double>(m));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j)
        scores[i][j] = score(source, i, target, j);
    std::vector<std::vector<double>> transposed(m, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j)
        transposed[j][i] = scores[i][j];
    std::vector<std::pair<int, int>> matches;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j)
        if (isChosen(scores[i], j, target.patches) &&
            isChosen(transposed[j], i, source.patches))
          matches.emplace_back(source.patches.keypoint[i], target.patches.keypoint[j]);
    return matches;
  }

private:
  bool
  isChosen(const std::vector<double>& scores,
           std::size_t which,
           const LogPolarPatches& patches) const
  {
    double second = -1;
    for (std::size_t j = 0; j < scores.size(); ++j) {
      if (scores[j] > scores[which])
        return false;
      const int right =
          patches.pixels[j] % patches.width - patches.pixels[which] % patches.width;
      const int down =
          patches.pixels[j] / patches.width - patches.pixels[which] / patches.width;
      if (std::hypot(right, down) > settings_.second_distance)
        second = std::max(second, scores[j]);
    }
    return scores[which] >= settings_.min_score &&
           1.003 - scores[which] < settings_.max_ambiguity * (1.003 - second);
  }

  double
  score(const PatchSide& a, std::size_t i, const PatchSide& b, std::size_t j) const
  {
    const int pixel_a = a.patches.pixels[i], pixel_b = b.patches.pixels[j];
    const int width = a.patches.width;
    if (std::hypot(pixel_a % width - pixel_b % width,
                   pixel_a / width - pixel_b / width) > gate_.image_distance)
      return -2;
    const Eigen::Vector3f& from =
        a.points[static_cast<std::size_t>(a.patches.keypoint[i])];
    const Eigen::Vector3f& to =
        b.points[static_cast<std::size_t>(b.patches.keypoint[j])];
    if (std::isfinite(gate_.distance) &&
        !((from - to).norm() <= gate_.distance + gate_.distance_per_metre * to.norm()))
      return -2;
    double best = -2;
    for (int ring = -settings_.ring_shifts; ring <= settings_.ring_shifts; ++ring)
      for (int turn = -settings_.sector_shifts; turn <= settings_.sector_shifts; ++turn)
        best = std::max(best, scoreOfShift(a.patches, i, b.patches, j, ring, turn));
    return best;
  }

  /** Score of the common rings, with one patch scaled and rotated. */
  double
  scoreOfShift(const LogPolarPatches& a,
               std::size_t i,
               const LogPolarPatches& b,
               std::size_t j,
               int ring_shift,
               int turn) const
  {
    Samples first, second;
    const int size = settings_.rings * settings_.sectors;
    for (int ring = 0; ring < settings_.rings; ++ring)
      for (int sector = 0; sector < settings_.sectors; ++sector) {
        const int other = ring + ring_shift;
        if (other < 0 || other >= settings_.rings)
          continue;
        const int turned = (sector + turn + settings_.sectors) % settings_.sectors;
        first.push_back(
            a.samples[i * static_cast<std::size_t>(size) +
                      static_cast<std::size_t>(other * settings_.sectors + turned)]);
        second.push_back(
            b.samples[j * static_cast<std::size_t>(size) +
                      static_cast<std::size_t>(ring * settings_.sectors + sector)]);
      }
    return pearson(first, second);
  }

  LogPolarSettings settings_;
  MatchGate gate_;
};

class LogPolarOracle : public testing::Test {
protected:
  PatchSide
  sideOf(const ViewChange& change) const
  {
    const GreyImage image = paint(paper_, change);
    PatchSide side;
    side.pixels = keypointsOf(image, 150);
    const auto wall = wallOf(image);
    for (const std::int32_t pixel : side.pixels)
      side.points.push_back((*wall)[static_cast<std::size_t>(pixel)].getVector3fMap());
    side.patches = logPolarPatches(image, side.pixels, settings_);
    return side;
  }

  /** Compares with the straightforward matching. \return number of matches */
  std::size_t
  compare(const MatchGate& gate = {}) const
  {
    const PatchSide source = sideOf({0.1, 1.1, {6, -4}}), target = sideOf({});
    MatchCounts counts;
    std::vector<std::pair<int, int>> pairs;
    for (const PatchMatch& match : matchPatches(source.patches,
                                                target.patches,
                                                source.points,
                                                target.points,
                                                gate,
                                                settings_,
                                                counts))
      pairs.emplace_back(match.source, match.target);
    EXPECT_EQ(pairs, NaiveMatching(settings_, gate).match(source, target));
    EXPECT_EQ(pairs.size() + counts.weak + counts.ambiguous + counts.one_sided,
              source.patches.pixels.size());
    return pairs.size();
  }

  const Wallpaper paper_{3};
  LogPolarSettings settings_;
};

TEST_F(LogPolarOracle, matchesAreThoseOfEveryPairCompared)
{
  EXPECT_GT(compare(), 20u);
  settings_.min_score = 0.95F;
  settings_.max_ambiguity = 0.4F;
  EXPECT_GT(compare(), 5u);
  settings_.max_ambiguity = 1;
  settings_.min_score = -1;
  EXPECT_GT(compare(), 40u);
}

TEST_F(LogPolarOracle, shiftsAreThoseOfRingsAndSectors)
{
  settings_.min_score = 0.9F;
  settings_.ring_shifts = 2;
  EXPECT_GT(compare(), 20u);
  settings_.sector_shifts = 3;
  EXPECT_GT(compare(), 20u);
  settings_.rings = 5; // an odd number of samples
  settings_.sectors = 9;
  settings_.ring_shifts = 1;
  EXPECT_GT(compare(), 5u);
}

TEST_F(LogPolarOracle, gatesLeavePairsOut)
{
  settings_.min_score = 0.5F;
  MatchGate near;
  near.image_distance = 12;
  const std::size_t in_the_image = compare(near);
  EXPECT_GT(in_the_image, 20u);
  near.distance = 0.05F;
  const std::size_t in_space = compare(near);
  EXPECT_GT(in_space, 5u);
  EXPECT_LT(in_space, in_the_image);
  near.distance_per_metre = 0.02F;
  EXPECT_GT(compare(near), in_space);
}

TEST_F(LogPolarOracle, patchesAreSamplesOfTheSmoothedImage)
{
  const GreyImage image = paint(paper_);
  const LogPolarPatches patches = logPolarPatches(image, {100 + 90 * 240}, settings_);
  // a Gaussian only attenuates the waves, so that the samples are known approximately
  Samples wanted, found(patches.samples.begin(), patches.samples.end());
  double sum = 0, squares = 0;
  for (int ring = 0; ring < 12; ++ring)
    for (int sector = 0; sector < 24; ++sector) {
      const double radius = std::pow(20, ring / 11.0), angle = sector * 0.2617993878;
      const Eigen::Vector2d place(100 + radius * std::cos(angle),
                                  90 + radius * std::sin(angle));
      double smoothed = 0;
      for (int u = -4; u <= 4; ++u)
        for (int v = -4; v <= 4; ++v)
          smoothed += std::exp(-(u * u + v * v) / 2 / 1.96) *
                      paper_.at(place + Eigen::Vector2d(u, v));
      wanted.push_back(smoothed);
      const double sample = found[static_cast<std::size_t>(ring * 24 + sector)];
      sum += sample;
      squares += sample * sample;
    }
  EXPECT_GT(pearson(wanted, found), 0.9995);
  EXPECT_NEAR(sum, 0, 1e-4);
  EXPECT_NEAR(squares, 1, 1e-4);
}

std::vector<std::int16_t>
draw(std::size_t size, int range)
{
  Random random(4 + size);
  std::vector<std::int16_t> samples(size);
  for (std::int16_t& sample : samples)
    sample = static_cast<std::int16_t>(std::lround(random.uniform(-range, range)));
  return samples;
}

/** Runs one variant on rows and columns of random samples, with some minimums. */
std::vector<std::uint8_t>
foundBy(FindPairs find, std::size_t pairs, std::size_t blocks, int range)
{
  const auto rows = draw(score_rows * 2 * pairs, range);
  const auto columns = draw(blocks * score_columns * 2 * pairs, range);
  std::vector<std::int32_t> sums(score_rows * blocks * score_columns);
  for (std::size_t i = 0; i < score_rows; ++i)
    for (std::size_t j = 0; j < blocks * score_columns; ++j)
      for (std::size_t k = 0; k < 2 * pairs; ++k) {
        const std::size_t block = j / score_columns * score_columns * 2 * pairs;
        sums[i * blocks * score_columns + j] +=
            rows[i * 2 * pairs + k] * columns[block + (k / 2) * 2 * score_columns +
                                              2 * (j % score_columns) + k % 2];
      }
  std::vector<std::uint8_t> all;
  for (const std::int32_t minimum : {sums.front(), sums.front() + 1, 0, sums.back()}) {
    std::vector<std::uint8_t> found(score_rows * blocks), naive(found.size());
    find({rows.data(), columns.data(), blocks, pairs}, minimum, found.data());
    for (std::size_t place = 0; place < sums.size(); ++place)
      if (sums[place] >= minimum)
        naive[place / score_columns] |=
            static_cast<std::uint8_t>(1 << place % score_columns);
    EXPECT_EQ(found, naive);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

TEST(ScoreKernels, everyVariantGivesTheNaiveSums)
{
  for (const auto& [pairs, blocks, range] :
       {std::tuple(1, 1, 32000), std::tuple(144, 5, 2000), std::tuple(7, 2, 8000)}) {
    const auto wanted = foundBy(findPairsBase,
                                static_cast<std::size_t>(pairs),
                                static_cast<std::size_t>(blocks),
                                range);
    EXPECT_EQ(foundBy(findPairs(),
                      static_cast<std::size_t>(pairs),
                      static_cast<std::size_t>(blocks),
                      range),
              wanted);
  }
  for (std::size_t length = 0; length <= 20 * score_samples; length += score_samples) {
    const auto a = draw(length, 2000), b = draw(length, 1999);
    std::int32_t sum = 0;
    for (std::size_t k = 0; k < length; ++k)
      sum += a[k] * b[k];
    EXPECT_EQ(productOfBase(a.data(), b.data(), length), sum);
    EXPECT_EQ(productOf()(a.data(), b.data(), length), sum);
  }
#ifdef ACMAP_SIMD_AVX2
  EXPECT_EQ(findPairs() == findPairsAvx2, isAvx2Chosen());
  EXPECT_EQ(productOf() == productOfAvx2, isAvx2Chosen());
#endif
}

#ifdef ACMAP_SIMD_AVX2
TEST(ScoreKernels, bothGiveTheSameForAllSizes)
{
  if (!__builtin_cpu_supports("avx2"))
    GTEST_SKIP() << "this processor has no AVX2";
  for (std::size_t pairs = 0; pairs <= 40; ++pairs)
    for (std::size_t blocks = 1; blocks <= 5; ++blocks)
      for (const int range : {1, 5000})
        ASSERT_EQ(foundBy(findPairsAvx2, pairs, blocks, range),
                  foundBy(findPairsBase, pairs, blocks, range))
            << pairs << " pairs, " << blocks << " blocks";
}
#endif

/** Patches of integers as matching makes them: waves under white noise.
 * \param[in] noise amplitude relative to the waves */
std::vector<std::vector<std::int16_t>>
patchesOf(int rings, int sectors, double noise)
{
  Random random(7);
  const auto size = static_cast<std::size_t>(rings * sectors);
  std::vector<std::vector<std::int16_t>> patches;
  for (int patch = 0; patch < 60; ++patch) {
    // every second one is nearly the one before
    const bool is_alike = patch % 2 == 1;
    const double ring = random.uniform(0, 6), sector = random.uniform(0, 6);
    std::vector<float> samples(size);
    for (std::size_t k = 0; k < size; ++k)
      samples[k] = static_cast<float>(
          is_alike ? patches.back()[k] + random.uniform(-300, 300)
                   : std::sin(ring + 0.4 * double(k / std::size_t(sectors))) +
                         std::cos(sector + 6.2831853 * double(k) / sectors) +
                         noise * random.uniform(-1, 1));
    normalizeSamples(samples.data(), size);
    std::vector<std::int16_t> integers;
    for (const float sample : samples)
      integers.push_back(static_cast<std::int16_t>(std::lround(sample * score_length)));
    patches.push_back(integers);
  }
  return patches;
}

TEST(PatchWaves, boundEveryScoreFromAbove)
{
  for (const auto& [rings, sectors, noise] : {std::tuple(12, 24, 0.3),
                                              std::tuple(11, 24, 3.0),
                                              std::tuple(12, 24, 0.0),
                                              std::tuple(5, 9, 1.0),
                                              std::tuple(2, 4, 1.0)}) {
    const PatchWaves waves(rings, sectors);
    const auto patches = patchesOf(rings, sectors, noise);
    std::vector<std::array<std::int16_t, PatchWaves::size>> numbers(patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i)
      waves.numbersOf(patches[i].data(), numbers[i].data());
    double looseness = 0;
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (std::size_t j = 0; j < patches.size(); ++j) {
        std::int64_t score = 0, bound = 0;
        for (std::size_t k = 0; k < patches[i].size(); ++k)
          score += patches[i][k] * patches[j][k];
        for (std::size_t k = 0; k < PatchWaves::size; ++k)
          bound += numbers[i][k] * numbers[j][k];
        EXPECT_GE(bound, PatchWaves::boundOf(static_cast<std::int32_t>(score)));
        EXPECT_LE(bound, std::numeric_limits<std::int32_t>::max());
        looseness += static_cast<double>(bound - score) /
                     static_cast<double>(patches.size() * patches.size());
      }
    const double allowed = noise < 1 ? 0.1 : 2; // without noise, all waves are long
    EXPECT_LT(looseness, allowed * score_length * score_length);
  }
}

} // namespace
} // namespace pcl::acmap::test
