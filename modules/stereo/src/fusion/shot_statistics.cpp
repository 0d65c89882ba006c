#include "shot_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr float normal_deviations = 1.4826f; // per median absolute deviation
constexpr float max_deviations = 3.0f;
constexpr float min_limit = 1.0f;         // px
constexpr float median_variance = 1.571f; // relative to that of a mean

// Determined by simulation, see doc/stereo/disparity_fusion.md.
constexpr float min_scatter = 0.05f; // px, added to the sigma of a shot in quadrature
constexpr float test_scatter = 0.5f; // px, the same for the chi-square test
constexpr float prior_shots = 1.0f;  // weight of the reported variances, in shots
constexpr float common_share = 0.2f; // part of a shot's sigma common to all shots
constexpr float min_sigma = 0.005f;  // px

constexpr float
square(float value)
{
  return value * value;
}

float
varianceOf(const ShotDisparity& shot, float minimum)
{
  return square(shot.sigma) + square(minimum);
}

/** \brief Lower median of the absolute deviations from the lower median. */
float
medianDeviation(const ShotDisparity* begin, const ShotDisparity* end)
{
  const std::ptrdiff_t half = (end - begin - 1) / 2;
  const float middle = begin[half].disparity;
  const ShotDisparity* below = begin + half;
  const ShotDisparity* above = begin + half + 1;
  float deviation = 0.0f;
  for (std::ptrdiff_t i = 0; i < half; ++i) { // takes the nearest on either side
    const bool goes_up =
        below == begin ||
        (above != end && above->disparity - middle < middle - below[-1].disparity);
    deviation = goes_up ? (above++)->disparity - middle : middle - (--below)->disparity;
  }
  return deviation;
}

/** \brief The shots that are not too far from the middle one: at least half of them. */
std::pair<const ShotDisparity*, const ShotDisparity*>
inliersOf(const ShotDisparity* begin, const ShotDisparity* end)
{
  const float middle = begin[(end - begin - 1) / 2].disparity;
  const float limit = std::max(
      max_deviations * normal_deviations * medianDeviation(begin, end), min_limit);
  while (middle - begin->disparity > limit)
    ++begin;
  while (end[-1].disparity - middle > limit)
    --end;
  return {begin, end};
}

/** \brief Statistics of the shots of a pixel, for the sigma of the fused disparity. */
struct Scatter {
  float shots;    // number
  float worth;    // number of shots of an equally accurate mean
  float variance; // px^2, of one shot, as reported
  float misfit;   // sum of squared deviations, divided by the reported variances
};

/** \brief Scales the reported variance by the observed scatter between the shots.
 * Errors that are common to all shots (a slanted wall, an edge within the window) do
 * not appear in the scatter and are added. */
float
fusedSigma(const Scatter& of)
{
  const float scale = (prior_shots + of.misfit) / (prior_shots + of.shots - 1.0f);
  return std::sqrt(scale * of.variance * (1.0f / of.worth + square(common_share)) +
                   square(min_sigma));
}

/** \brief Returns true if most of the shots agree with this disparity. If the
 * disparities are spread widely, the robust deviation is large, and all of them are
 * inliers. */
bool
isAgreed(const ShotDisparity* begin, const ShotDisparity* end, float disparity)
{
  const auto agreed = std::count_if(begin, end, [=](const ShotDisparity& shot) {
    return agree(shot.disparity, disparity);
  });
  return isMajority(static_cast<std::size_t>(agreed),
                    static_cast<std::size_t>(end - begin));
}

} // namespace

void
sortShots(ShotDisparity* begin, ShotDisparity* end)
{
  std::sort(begin, end, [](const ShotDisparity& a, const ShotDisparity& b) {
    return a.disparity < b.disparity ||
           (a.disparity == b.disparity && a.sigma < b.sigma);
  });
}

FusedDisparity
medianOfShots(const ShotDisparity* begin, const ShotDisparity* end)
{
  const auto shots = static_cast<float>(end - begin);
  float precision = 0.0f; // the variance of a median depends on the mean of 1 / sigma
  for (const ShotDisparity* shot = begin; shot != end; ++shot)
    precision += 1.0f / std::sqrt(varianceOf(*shot, min_scatter)) / shots;
  const float variance = 1.0f / square(precision);
  const float deviation = normal_deviations * medianDeviation(begin, end);
  return {begin[(end - begin - 1) / 2].disparity,
          fusedSigma({shots,
                      shots / median_variance,
                      variance,
                      (shots - 1.0f) * square(deviation) / variance}),
          static_cast<std::uint16_t>(end - begin),
          true};
}

FusedDisparity
consistentMeanOfShots(const ShotDisparity* begin, const ShotDisparity* end)
{
  const auto [first, last] = inliersOf(begin, end);
  const float origin = first->disparity;
  float weights = 0.0f, offset = 0.0f;
  for (const ShotDisparity* shot = first; shot != last; ++shot) {
    const float weight = 1.0f / varianceOf(*shot, min_scatter);
    weights += weight;
    offset += weight * (shot->disparity - origin);
  }
  const float mean = origin + offset / weights;
  float misfit = 0.0f, tested = 0.0f;
  for (const ShotDisparity* shot = first; shot != last; ++shot) {
    misfit += square(shot->disparity - mean) / varianceOf(*shot, min_scatter);
    tested += square(shot->disparity - mean) / varianceOf(*shot, test_scatter);
  }
  const auto support = static_cast<std::uint16_t>(last - first);
  const auto shots = static_cast<float>(support);
  return {mean,
          fusedSigma({shots, shots, shots / weights, misfit}),
          support,
          isAgreed(begin, end, mean) && tested <= chiSquareLimit(support - 1U)};
}

bool
agree(float a, float b)
{
  return std::abs(a - b) <= min_limit;
}

bool
isMajority(std::size_t agreed, std::size_t all)
{
  constexpr float min_share = 0.6f;
  return static_cast<float>(agreed) >= min_share * static_cast<float>(all);
}

double
chiSquareLimit(std::size_t degrees_of_freedom)
{
  if (degrees_of_freedom == 0)
    return std::numeric_limits<double>::infinity();
  constexpr double deviations = 2.3263; // of the normal distribution, for 1 %
  const double part = 2.0 / (9.0 * static_cast<double>(degrees_of_freedom));
  const double root = 1.0 - part + deviations * std::sqrt(part);
  return static_cast<double>(degrees_of_freedom) * root * root * root;
}

} // namespace pcl::acmap
