#include <pcl/core/sensor_evidence.h>

#include <Eigen/Geometry>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;
using Rays = std::vector<Vector3d>; ///< from the position to points, metres

constexpr double pi = 3.14159265358979323846;

/** Rays to every n-th point, so that there are at most \a wanted. */
Rays
sampledRays(const PointView& points, const Vector3d& position, std::size_t wanted)
{
  const std::size_t stride = points.size() / (wanted + 1) + 1;
  Rays rays;
  rays.reserve(points.size() / stride + 1);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Vector3d ray = points[i].cast<double>() - position;
    if (ray.allFinite() && !ray.isZero(0))
      rays.push_back(ray);
  }
  return rays;
}

double
medianOf(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double
medianRange(const Rays& rays)
{
  std::vector<double> ranges;
  ranges.reserve(rays.size());
  for (const Vector3d& ray : rays)
    ranges.push_back(ray.norm());
  return medianOf(ranges);
}

/** Positions beside the assessed one, with which it is compared. */
std::vector<Vector3d>
positionsBeside(double range)
{
  constexpr double share = 0.15;
  std::vector<Vector3d> shifts;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      shifts.emplace_back(sign * share * range * Vector3d::Unit(axis));
  return shifts;
}

/** A ray by its angles, both from 0 to 1, and its length, metres. */
struct PolarRay {
  double height, turn, range;
};

std::vector<PolarRay>
polarRays(const Rays& rays)
{
  std::vector<PolarRay> polar;
  polar.reserve(rays.size());
  for (const Vector3d& ray : rays) {
    const double range = ray.norm();
    polar.push_back({std::asin(std::clamp(ray.z() / range, -1.0, 1.0)) / pi + 0.5,
                     std::atan2(ray.y(), ray.x()) / (2 * pi) + 0.5,
                     range});
  }
  return polar;
}

/** The nearest point of each direction, in cells of equal size. */
class NearestRanges {
public:
  /** \param[in] rows of 180 degrees */
  explicit NearestRanges(int rows)
  : rows_(rows)
  {
    for (int row = 0; row < rows; ++row) {
      const double middle = ((row + 0.5) / rows - 0.5) * pi;
      first_.push_back(size_);
      columns_.push_back(std::max(1, static_cast<int>(2 * rows * std::cos(middle))));
      size_ += static_cast<std::size_t>(columns_.back());
    }
    nearest_.assign(size_, std::numeric_limits<float>::infinity());
  }

  float&
  of(const PolarRay& ray)
  {
    const auto row = static_cast<std::size_t>(
        std::clamp(static_cast<int>(ray.height * rows_), 0, rows_ - 1));
    const int column =
        std::clamp(static_cast<int>(ray.turn * columns_[row]), 0, columns_[row] - 1);
    return nearest_[first_[row] + static_cast<std::size_t>(column)];
  }

private:
  int rows_;
  std::size_t size_ = 0;
  std::vector<std::size_t> first_; ///< cell of each row
  std::vector<int> columns_;
  std::vector<float> nearest_;
};

/** The share of the points that is hidden: behind the nearest one of its direction. */
double
hiddenShare(const std::vector<PolarRay>& rays)
{
  constexpr int coarsest = 120, finest = 1920; // rows of 180 degrees
  constexpr std::size_t points_a_cell = 6;
  for (int rows = coarsest;; rows *= 2) {
    NearestRanges nearest(rows);
    std::size_t cells = 0, hidden = 0;
    for (const PolarRay& ray : rays) {
      float& range = nearest.of(ray);
      cells += std::isinf(range);
      range = std::min(range, static_cast<float>(ray.range));
    }
    if (rays.size() > points_a_cell * cells && rows < finest)
      continue;
    constexpr double behind = 1.3; // a slanted surface is not that deep within a cell
    for (const PolarRay& ray : rays)
      hidden += ray.range > behind * static_cast<double>(nearest.of(ray));
    return static_cast<double>(hidden) / static_cast<double>(rays.size());
  }
}

/** The fewest bins of a histogram that hold most of the values, and the number of rows that
 * they form. */
struct Sharpness {
  std::size_t bins = 0, rows = 0;
};

/** Shares of the values whose bins are counted. On a level ground, rows are circles, which are
 * sharp from everywhere above their middle: there, the few points that are not on it decide. */
constexpr std::array<double, 2> counted_shares = {0.9, 0.97};

/** One for each of these shares. */
template <typename Value>
using ForShares = std::array<Value, counted_shares.size()>;

ForShares<Sharpness>
sharpnessOf(std::vector<double> values)
{
  constexpr std::size_t number = 4096;
  constexpr double rim = 0.01;
  const auto at = [&](double share) {
    const auto place =
        values.begin() +
        static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const double low = at(rim), width = (at(1 - rim) - low) / number;
  ForShares<Sharpness> results;
  if (!(width > 0)) {
    results.fill({1, 1});
    return results;
  }
  std::vector<std::size_t> counts(number +
                                  3); // values at both ends, and a last, empty bin
  for (const double value : values) {
    const double bin = std::floor((value - low) / width + 0.5);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0.0, 1.0 * number + 1))];
  }
  std::vector<std::size_t> order = counts;
  std::sort(order.begin(), order.end(), std::greater<>());
  for (std::size_t share = 0; share < results.size(); ++share) {
    Sharpness& result = results[share];
    const double wanted = counted_shares[share] * static_cast<double>(values.size());
    for (double sum = 0; sum < wanted; ++result.bins)
      sum += static_cast<double>(order[result.bins]);
    const std::size_t fewest = order[result.bins - 1];
    for (std::size_t bin = 0; bin + 1 < counts.size(); ++bin)
      result.rows += counts[bin] >= fewest && counts[bin + 1] < fewest;
  }
  return results;
}

/** The coordinates of a ray that are constant in a row: its elevation about each axis of the
 * frame, and its height in a picture along z. A point at the position itself has no direction,
 * and is level. */
constexpr int row_kinds = 4;

double
rowOf(const Vector3d& ray, int kind)
{
  const double row = kind < 3 ? std::asin(std::clamp(ray[kind] / ray.norm(), -1.0, 1.0))
                              : std::atan(ray.y() / ray.z());
  return std::isnan(row) ? 0 : row;
}

/** What is seen from a position, compared with positions beside it. */
struct Contrast {
  double ratio = 0; ///< how many times clearer it is from the position
  std::size_t rows = 0;
};

ForShares<Contrast>
contrastOfRows(const Rays& rays, const std::vector<Vector3d>& shifts, int kind)
{
  const auto from = [&](const Vector3d& shift) {
    std::vector<double> values;
    values.reserve(rays.size());
    for (const Vector3d& ray : rays)
      values.push_back(rowOf(ray - shift, kind));
    return sharpnessOf(std::move(values));
  };
  const auto areRows = [](const Sharpness& sharpness) {
    constexpr std::size_t fewest = 4, most = 512;
    return sharpness.rows >= fewest && sharpness.rows <= most;
  };
  ForShares<Contrast> contrasts;
  const ForShares<Sharpness> here = from(Vector3d::Zero());
  if (std::none_of(here.begin(), here.end(), areRows))
    return contrasts;
  std::vector<ForShares<Sharpness>> beside(shifts.size());
  oneapi::tbb::parallel_for(std::size_t{0}, shifts.size(), [&](std::size_t k) {
    beside[k] = from(shifts[k]);
  });
  for (std::size_t share = 0; share < here.size(); ++share) {
    const auto [bins, rows] = here[share];
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const ForShares<Sharpness>& one : beside)
      fewest = std::min(fewest, one[share].bins);
    if (areRows(here[share]))
      contrasts[share] = {static_cast<double>(fewest) / static_cast<double>(bins),
                          rows};
  }
  return contrasts;
}

/** Triples of consecutive points from windows all over the file; what is no point in
 * between is left out. */
std::vector<std::array<Vector3d, 3>>
tripletsOf(const PointView& points, const Vector3d& position)
{
  constexpr std::size_t windows = 512, length = 64;
  const std::size_t stride = std::max(length, points.size() / windows);
  std::vector<std::array<Vector3d, 3>> triplets;
  for (std::size_t begin = 0; begin + length <= points.size(); begin += stride) {
    std::vector<Vector3d> rays;
    for (std::size_t i = begin;
         i < std::min(begin + stride, points.size()) && rays.size() < length;
         ++i)
      if (const Vector3d ray = points[i].cast<double>() - position;
          ray.allFinite() && !ray.isZero(0))
        rays.push_back(ray);
    for (std::size_t i = 0; i + 2 < rays.size(); ++i)
      triplets.push_back({rays[i], rays[i + 1], rays[i + 2]});
  }
  return triplets;
}

/** How much the direction and length of the steps between consecutive rays change, relative
 * to the steps; the median of all triples. */
double
unsteadiness(const std::vector<std::array<Vector3d, 3>>& triplets,
             const Vector3d& shift)
{
  std::vector<double> changes;
  changes.reserve(triplets.size());
  for (const auto& triplet : triplets) {
    const Vector3d a = (triplet[0] - shift).normalized(),
                   b = (triplet[1] - shift).normalized(),
                   c = (triplet[2] - shift).normalized();
    const double steps = (b - a).norm() + (c - b).norm();
    changes.push_back(steps > 0 ? (c - 2 * b + a).norm() / steps : 1);
  }
  return medianOf(changes);
}

Contrast
contrastOfOrder(const PointView& points,
                const Vector3d& position,
                const std::vector<Vector3d>& shifts)
{
  constexpr std::size_t fewest = 200;
  constexpr double steady = 0.3, finest = 1e-3;
  const auto triplets = tripletsOf(points, position);
  if (triplets.size() < fewest)
    return {};
  const double here = unsteadiness(triplets, Vector3d::Zero());
  if (here > steady)
    return {};
  double beside = std::numeric_limits<double>::infinity();
  for (const Vector3d& shift : shifts)
    beside = std::min(beside, unsteadiness(triplets, shift));
  return {beside / std::max(here, finest), 0};
}

std::string
rounded(double value)
{
  constexpr double most = 1e9;
  return std::to_string(std::lround(std::min(value, most)));
}

/** Are there rows or an order that no place beside the position has as clearly? */
SensorEvidence
provedBy(const PointView& points,
         const Vector3d& position,
         const Rays& rays,
         double range)
{
  constexpr double clearer = 2;
  SensorEvidence result;
  const auto prove = [&](double confidence, std::string evidence) {
    result.outcome = SensorOutcome::Proved;
    result.confidence = confidence;
    result.evidence = std::move(evidence);
    return result;
  };
  const std::vector<Vector3d> shifts = positionsBeside(range);
  std::array<ForShares<Contrast>, row_kinds> contrasts;
  for (int kind = 0; kind < row_kinds; ++kind)
    contrasts[static_cast<std::size_t>(kind)] = contrastOfRows(rays, shifts, kind);
  Contrast best;
  for (std::size_t share = 0; share < counted_shares.size(); ++share)
    for (const ForShares<Contrast>& of_kind : contrasts)
      if (best.ratio < clearer && of_kind[share].ratio > best.ratio)
        best = of_kind[share];
  if (best.ratio >= clearer)
    return prove(1 - 1 / (best.ratio * best.ratio),
                 std::to_string(best.rows) + " rows of equal elevation, " +
                     rounded(best.ratio) + " times sharper than from beside it");
  const Contrast order = contrastOfOrder(points, position, shifts);
  if (order.ratio >= clearer)
    return prove(1 - 1 / (order.ratio * order.ratio),
                 "the rays advance steadily in the order of the points, " +
                     rounded(order.ratio) + " times more than from beside it");
  result.evidence = "neither rows nor the order of the points show rays from it";
  result.confidence = 1 - std::max(best.ratio, order.ratio) / clearer;
  return result;
}

} // namespace

SensorEvidence
assessSensor(const PointView& points, std::size_t width, const Vector3d& position)
{
  constexpr std::size_t wanted = std::size_t{1} << 16, fewest = 200;
  // of leaves and rims, many are; without proof, an empty room is not much less
  constexpr double most_hidden = 0.25, most_if_proved = 0.4;
  SensorEvidence result;
  if (isSingleView(points, width, position)) {
    result.outcome = SensorOutcome::Proved;
    result.confidence = 1;
    result.evidence = "a picture, whose rays have the same handedness everywhere";
    return result;
  }
  const Rays rays = sampledRays(points, position, wanted);
  if (rays.size() < fewest) {
    result.evidence = "fewer than 200 points";
    return result;
  }
  const double range = medianRange(rays);
  const double hidden =
      hiddenShare(polarRays(sampledRays(points, position, 4 * wanted)));
  result = provedBy(points, position, rays, range);
  const bool is_proved = result.outcome == SensorOutcome::Proved;
  if (hidden > (is_proved ? most_if_proved : most_hidden)) {
    result.outcome = SensorOutcome::Refuted;
    result.confidence = hidden;
    result.evidence.clear();
  }
  result.hidden = hidden;
  if (!result.evidence.empty())
    result.evidence += ", ";
  result.evidence += rounded(100 * hidden) + " % of the points are hidden from it";
  return result;
}

namespace {

/** \brief Minimum number of triples of neighbouring pixels for a decision. */
constexpr std::size_t min_triples = 100;

} // namespace

bool
isSingleView(const PointView& view, std::size_t width, const Eigen::Vector3d& origin)
{
  if (width < 2 || view.size() < 2 * width || view.size() % width != 0)
    return false;
  const auto ray = [&](std::size_t i) -> Eigen::Vector3d {
    return view[i].cast<double>() - origin;
  };
  std::size_t left_handed = 0, triples = 0;
  for (std::size_t i = 0; i + width < view.size(); ++i) {
    if (i % width + 1 == width)
      continue;
    const double volume = ray(i).cross(ray(i + 1)).dot(ray(i + width));
    if (!std::isfinite(volume) || volume == 0)
      continue;
    ++triples;
    left_handed += volume < 0;
  }
  return triples >= min_triples &&
         std::min(left_handed, triples - left_handed) * 100 <= triples;
}

} // namespace pcl::acmap
