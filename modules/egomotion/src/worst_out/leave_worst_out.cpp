#include "worst_out/distance_ratios.h"

#include <pcl/egomotion/impl/worst_out_kernel.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace pcl::acmap {

namespace {

RatioSums
emptySums(std::size_t size)
{
  return {std::vector<double>(size, 0.0), std::vector<std::int32_t>(size, 0)};
}

void
addRatiosTo(std::size_t one,
            const MatchPlaces& others,
            const MatchPlaces& places,
            const WorstOutSettings& settings,
            int sign,
            RatioSums& sums)
{
  float at[6];
  for (int axis = 0; axis < 6; ++axis)
    at[axis] = others.coordinates[axis][one];
  addRatios(places,
            at,
            static_cast<float>(settings.min_distance),
            settings.paper ? 1.0F : 0.0F,
            sign,
            sums);
}

/** Eq. 1 of each match of \a places, as a mean over \a others. */
RatioSums
sumsOver(const MatchPlaces& others,
         const MatchPlaces& places,
         const WorstOutSettings& settings)
{
  RatioSums sums = emptySums(places.size());
  for (std::size_t one = 0; one < others.size(); ++one)
    addRatiosTo(one, others, places, settings, 1, sums);
  return sums;
}

/** The match with the largest D_ij; the first one of equal ones. */
std::size_t
worstOf(const RatioSums& sums)
{
  std::size_t worst = 0;
  double maximum = sums.distortion(0);
  for (std::size_t place = 1; place < sums.sums.size(); ++place)
    if (const double distortion = sums.distortion(place); distortion > maximum) {
      worst = place;
      maximum = distortion;
    }
  return worst;
}

/** Removes the worst match until the rest agree, or too few remain. */
void
clean(MatchPlaces& places, const WorstOutSettings& settings, WorstOutOutcome& outcome)
{
  RatioSums sums = sumsOver(places, places, settings);
  while (places.size() > 0 && places.size() >= settings.min_matches) {
    const std::size_t worst = worstOf(sums);
    outcome.distortion = sums.distortion(worst);
    if (outcome.distortion <= settings.max_distortion)
      return;
    addRatiosTo(worst, places, places, settings, -1, sums);
    outcome.removed.push_back(places.matches[worst]);
    places.erase(worst);
    sums.sums.erase(sums.sums.begin() + static_cast<std::ptrdiff_t>(worst));
    sums.counts.erase(sums.counts.begin() + static_cast<std::ptrdiff_t>(worst));
  }
  outcome.removed.insert(
      outcome.removed.end(), places.matches.begin(), places.matches.end());
  places = MatchPlaces();
}

/** The sample over which Eq. 1 is averaged, evenly chosen, and the other matches. */
struct Sampled {
  MatchPlaces sample, others;
};

Sampled
sampled(const std::vector<Eigen::Vector3f>& source,
        const std::vector<Eigen::Vector3f>& target,
        const std::vector<std::int32_t>& matches,
        std::size_t size)
{
  Sampled parts;
  const std::size_t n = matches.size();
  for (std::size_t k = 0; k < n; ++k) {
    // As in Bresenham's algorithm, chooses size of n evenly.
    const bool is_in = size >= n || (k + 1) * size / n > k * size / n;
    const auto match = static_cast<std::size_t>(matches[k]);
    (is_in ? parts.sample : parts.others)
        .push_back(matches[k], source[match], target[match]);
  }
  return parts;
}

/** Evaluates Eq. 1 for the other matches with the remaining sample. */
void
judge(const MatchPlaces& others,
      const MatchPlaces& sample,
      const WorstOutSettings& settings,
      WorstOutOutcome& outcome)
{
  const RatioSums sums = sumsOver(sample, others, settings);
  for (std::size_t place = 0; place < others.size(); ++place) {
    const double distortion = sums.distortion(place);
    if (distortion <= settings.max_distortion) {
      outcome.kept.push_back(others.matches[place]);
      outcome.distortion = std::max(outcome.distortion, distortion);
    }
    else
      outcome.removed.push_back(others.matches[place]);
  }
}

/** Replaces the settings that Eq. 1 as printed does not have. */
WorstOutSettings
asPrinted(WorstOutSettings settings)
{
  settings.min_distance = 0;
  settings.min_matches = 1;
  settings.sample = std::numeric_limits<std::size_t>::max();
  return settings;
}

} // namespace

WorstOutOutcome
leaveWorstOut(const std::vector<Eigen::Vector3f>& source,
              const std::vector<Eigen::Vector3f>& target,
              const WorstOutSettings& given)
{
  const WorstOutSettings settings = given.paper ? asPrinted(given) : given;
  WorstOutOutcome outcome;
  std::vector<std::int32_t> finite;
  for (std::size_t match = 0; match < source.size(); ++match)
    (source[match].allFinite() && target[match].allFinite() ? finite : outcome.removed)
        .push_back(static_cast<std::int32_t>(match));

  Sampled parts =
      sampled(source, target, finite, std::max(settings.sample, settings.min_matches));
  clean(parts.sample, settings, outcome);
  outcome.kept = parts.sample.matches;
  judge(parts.others, parts.sample, settings, outcome);
  std::sort(outcome.kept.begin(), outcome.kept.end());
  if (outcome.kept.empty())
    outcome.distortion = 0;
  return outcome;
}

} // namespace pcl::acmap
