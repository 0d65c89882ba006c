#include "noise/noise_window.h"
#include "noise/point_sample.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/surface_noise.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace pcl::acmap {

namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr std::size_t max_points = std::size_t{1} << 21;
constexpr std::size_t candidates = 8000, wanted_places = 2000;
constexpr std::size_t few_points = 12;
constexpr std::size_t min_answers = 20;
constexpr double min_answered = 0.03;   ///< share of the places
constexpr double min_agreeing = 0.1;    ///< share of the places
constexpr double several_sheets = 0.28; ///< of a median split
constexpr double too_fine = 50;         ///< spacings over noise that is none

bool
isLess(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/** A number in [0, 1) that depends on the coordinates alone. */
double
hashOf(const Eigen::Vector3f& point, std::uint64_t seed)
{
  std::uint64_t hash = hashOfPlace(point, seed);
  hash *= 0xbf58476d1ce4e5b9u;
  hash ^= hash >> 32;
  return static_cast<double>(hash >> 11) * 0x1.0p-53;
}

/** The finite points but those at the origin, each once, in an order that does not depend
 * on that of the cloud. */
Points
cleaned(const PointView& points)
{
  Points kept;
  std::size_t finite = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    finite += points[i].allFinite();
  const double share = static_cast<double>(max_points) /
                       static_cast<double>(std::max<std::size_t>(finite, 1));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite() && !points[i].isZero(0) &&
        (share >= 1 || hashOf(points[i], 1) < share))
      kept.push_back(points[i]);
  std::sort(kept.begin(), kept.end(), isLess);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

/** The step of coordinates that were rounded, or 0: most gaps are multiples of the least
 * ones. */
double
roundingStep(const Points& points, int axis)
{
  std::vector<float> values;
  for (const Eigen::Vector3f& point : points)
    values.push_back(point[axis]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double resolution =
        double{std::numeric_limits<float>::epsilon()} *
        static_cast<double>(std::max(std::abs(values[i]), std::abs(values[i - 1])));
    const double gap =
        static_cast<double>(values[i]) - static_cast<double>(values[i - 1]);
    if (gap > 2 * resolution)
      gaps.push_back(gap);
  }
  constexpr std::size_t enough = 100;
  if (gaps.size() < enough)
    return 0;
  std::sort(gaps.begin(), gaps.end());
  const auto end =
      std::upper_bound(gaps.begin(), gaps.end(), 1.3 * gaps[gaps.size() / 100]);
  const double step = gaps[static_cast<std::size_t>(end - gaps.begin()) / 2];
  std::size_t small = 0, even = 0;
  for (const double gap : gaps)
    if (gap < 200 * step) {
      ++small;
      even += std::abs(std::remainder(gap, step)) < 0.1 * step;
    }
  const bool is_rounded =
      static_cast<double>(even) > 0.97 * static_cast<double>(small) &&
      2 * small > gaps.size();
  return is_rounded ? step : 0;
}

/** A place's answer. */
struct Answer {
  std::size_t place;
  std::size_t window; ///< the first of the three that agree
  double sigma, split, radius;
};

/** The windows of a place, from fine to coarse. */
class PlaceWindows {
public:
  PlaceWindows(const Points& points)
  {
    constexpr std::size_t fewest = 500;
    constexpr int coarsest = 6;
    trees_.emplace_back(points);
    for (int t = 1; t <= coarsest; ++t) {
      Points thinned;
      const double share = std::pow(0.25, t);
      for (const Eigen::Vector3f& point : points)
        if (hashOf(point, 2) < share)
          thinned.push_back(point);
      if (thinned.size() < fewest)
        break;
      trees_.emplace_back(thinned);
    }
  }

  std::size_t
  size() const
  {
    return 4 + 2 * (trees_.size() - 1);
  }

  NoiseWindow
  windowAt(const Eigen::Vector3f& place, std::size_t number) const
  {
    constexpr std::size_t finest[] = {12, 24, 48, 96}, others[] = {48, 96};
    return number < 4
               ? windowOf(trees_[0], place, finest[number])
               : windowOf(trees_[1 + (number - 4) / 2], place, others[number % 2]);
  }

  double
  radiusOf(const Eigen::Vector3f& place) const
  {
    return trees_[0].radius(place, few_points);
  }

private:
  std::vector<WindowTree> trees_;
};

/** Side of the square of surface for each point, where the places are. */
double
spacingOf(const Points& places, const PlaceWindows& windows)
{
  std::vector<double> areas;
  for (const Eigen::Vector3f& place : places)
    areas.push_back(M_PI * std::pow(windows.radiusOf(place), 2) / few_points);
  return std::sqrt(medianOf(areas));
}

bool
isFlat(const NoiseWindow& window)
{
  const Eigen::Vector3d& l = window.variances;
  return window.points > 0 && l[1] >= 10 * l[0] && l[1] >= 0.15 * l[2];
}

/** Do three windows in a row tell the same noise? */
bool
doAgree(const Eigen::Vector3f& place,
        const NoiseWindow& a,
        const NoiseWindow& b,
        const NoiseWindow& c,
        double step)
{
  constexpr double growth = 1.8, parallel = 0.95, one_sheet = 0.2;
  return isFlat(a) && isFlat(b) && isFlat(c) && c.rough <= growth * a.rough &&
         std::abs(a.normal.dot(c.normal)) >= parallel &&
         std::abs(b.normal.dot(place.cast<double>() - b.mean)) <= 3 * b.thickness &&
         (c.rough <= step || (b.split >= one_sheet && c.split >= one_sheet));
}

std::optional<Answer>
ask(const PlaceWindows& windows,
    const Eigen::Vector3f& place,
    std::size_t number,
    double step)
{
  NoiseWindow a = windows.windowAt(place, 0), b = windows.windowAt(place, 1);
  for (std::size_t w = 0; w + 2 < windows.size(); ++w) {
    NoiseWindow c = windows.windowAt(place, w + 2);
    if (doAgree(place, a, b, c, step))
      return Answer{number, w, b.rough, b.split, b.radius};
    a = std::move(b);
    b = std::move(c);
  }
  return std::nullopt;
}

/** Places that are uniform over the area of the surface. */
Points
placesOf(const Points& points, const PlaceWindows& windows)
{
  Points order = points;
  const std::size_t count = std::min(candidates, order.size());
  const auto isBefore = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    const double first = hashOf(a, 3), second = hashOf(b, 3);
    return first != second ? first < second : isLess(a, b);
  };
  std::partial_sort(order.begin(),
                    order.begin() + static_cast<std::ptrdiff_t>(count),
                    order.end(),
                    isBefore);
  order.resize(count);
  std::vector<double> areas(count);
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    areas[i] = windows.radiusOf(order[i]);
  });
  std::vector<double> sorted = areas;
  const double largest = quantileOf(sorted, 0.95);
  double sum = 0;
  for (double& area : areas) {
    area = std::pow(std::min(area, largest), 2);
    sum += area;
  }
  Points places;
  for (std::size_t i = 0; i < count; ++i)
    if (hashOf(order[i], 4) * sum < areas[i] * static_cast<double>(wanted_places))
      places.push_back(order[i]);
  return places;
}

/** Drops answers of coarse windows within which others found a far smaller noise: a slab
 * of planes is no noise. */
std::vector<Answer>
withoutContradicted(const std::vector<Answer>& answers, const Points& places)
{
  constexpr std::size_t coarse = 2;
  constexpr double share = 0.15, smaller = 1.0 / 3;
  std::vector<Answer> kept;
  for (const Answer& answer : answers) {
    std::size_t near = 0, finer = 0;
    if (answer.window >= coarse) {
      for (const Eigen::Vector3f& place : places)
        near += (place - places[answer.place]).norm() <= answer.radius;
      for (const Answer& other : answers)
        finer += other.window < answer.window && other.sigma < smaller * answer.sigma &&
                 (places[other.place] - places[answer.place]).norm() <= answer.radius;
    }
    if (static_cast<double>(finer) <= share * static_cast<double>(near))
      kept.push_back(answer);
  }
  return kept;
}

/** The answers about the mode of the noise, which holds the first large share of them. */
std::vector<Answer>
agreeing(std::vector<Answer> answers)
{
  std::sort(answers.begin(), answers.end(), [](const Answer& a, const Answer& b) {
    return a.sigma != b.sigma ? a.sigma < b.sigma : a.place < b.place;
  });
  constexpr double factor = 4, width = 0.35, tail = 0.2;
  const auto n = static_cast<double>(answers.size());
  const auto isBelow = [](const Answer& answer, double sigma) {
    return answer.sigma < sigma;
  };
  std::vector<double> shares;
  for (auto first = answers.begin(); first != answers.end(); ++first)
    shares.push_back(
        static_cast<double>(
            std::lower_bound(first, answers.end(), factor * first->sigma, isBelow) -
            first) /
        n);
  const double enough =
      std::max(0.25, *std::max_element(shares.begin(), shares.end()) / 2);
  const auto chosen = static_cast<std::size_t>(
      std::find_if(
          shares.begin(), shares.end(), [&](double f) { return f >= enough; }) -
      shares.begin());
  // bins of log sigma, from the start of the chosen factor
  const double begin = std::log(answers[chosen].sigma);
  const auto binOf = [&](const Answer& answer) {
    return static_cast<int>(std::floor((std::log(answer.sigma) - begin) / width));
  };
  std::map<int, std::size_t> bins;
  for (const Answer& answer : answers)
    ++bins[binOf(answer)];
  const auto countOf = [&](int bin) {
    const auto found = bins.find(bin);
    return found == bins.end() ? std::size_t{0} : found->second;
  };
  int peak = 0;
  for (int bin = 0; bin * width < std::log(factor); ++bin)
    if (countOf(bin) > countOf(peak))
      peak = bin;
  const auto holds = [&](int bin) {
    return static_cast<double>(countOf(bin)) >
           tail * static_cast<double>(countOf(peak));
  };
  int low = peak, high = peak;
  while (holds(low - 1))
    --low;
  while (holds(high + 1))
    ++high;
  std::vector<Answer> members;
  for (const Answer& answer : answers)
    if (binOf(answer) >= low && binOf(answer) <= high)
      members.push_back(answer);
  return members;
}

/** Sets the values of the noise. \param[in] members ascending */
void
conclude(const std::vector<Answer>& members, SurfaceNoise& noise)
{
  const auto sigmaAt = [&](double share) {
    const double last = static_cast<double>(members.size() - 1);
    return members[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * last + 0.5)]
        .sigma;
  };
  std::vector<double> splits;
  for (const Answer& member : members)
    splits.push_back(member.split);
  if (medianOf(splits) < several_sheets) {
    noise.reason = "most places show several sheets behind each other";
    return;
  }
  constexpr std::size_t max_counted = 400;
  const double half =
      1 / std::sqrt(static_cast<double>(std::min(members.size(), max_counted)));
  noise.is_determined = true;
  if (sigmaAt(0.5) <= noise.spacing / too_fine)
    return;
  noise.sigma = sigmaAt(0.5);
  noise.low = sigmaAt(0.5 - half);
  noise.high = sigmaAt(0.5 + half);
}

} // namespace

SurfaceNoise
measureSurfaceNoise(const PointView& points, unsigned threads)
{
  SurfaceNoise noise;
  withThreads(threads, [&] {
    const Points clean = cleaned(points);
    if (clean.size() < candidates / 100) {
      noise.reason = "there are too few points";
      return;
    }
    const PlaceWindows windows(clean);
    const Points places = placesOf(clean, windows);
    double step = 0;
    for (const int axis : {0, 1, 2})
      step = std::max(step, roundingStep(clean, axis));
    std::vector<std::optional<Answer>> all(places.size());
    oneapi::tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
      all[i] = ask(windows, places[i], i, step);
    });
    std::vector<Answer> answers;
    for (const std::optional<Answer>& answer : all)
      if (answer && answer->sigma > 0)
        answers.push_back(*answer);
    answers = withoutContradicted(answers, places);
    noise.places = places.size();
    noise.spacing = spacingOf(places, windows);
    noise.answers = answers.size();
    const auto asked = static_cast<double>(places.size());
    if (answers.size() < min_answers ||
        static_cast<double>(answers.size()) < min_answered * asked) {
      noise.reason = "few places are flat enough to tell noise from shape";
      return;
    }
    const std::vector<Answer> members = agreeing(answers);
    noise.members = members.size();
    if (members.size() < min_answers ||
        static_cast<double>(members.size()) < min_agreeing * asked) {
      noise.reason = "the places tell different noises";
      return;
    }
    conclude(members, noise);
  });
  return noise;
}

} // namespace pcl::acmap
