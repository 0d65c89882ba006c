#include "view_pieces.h"

#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/quantile.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>

namespace pcl::acmap {
namespace {

constexpr int parts_across = 4;
constexpr int parts = parts_across * parts_across;

/** A measured point as a direction and a distance. */
struct RaySample {
  Eigen::Vector3f ray; ///< unit vector
  float inverse;       ///< 1/m, inverse distance; 0: not measured
  float sigma;         ///< as given, 1 without
};

/** A regression of inverse distance: 1 / distance = plane . ray. */
struct RayFit {
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  double chi2 = 0;          ///< per degree of freedom
  double part_chi2 = 0;     ///< of the means of the parts
  double part_variance = 0; ///< of the means beyond the noise, in units of sigma^2
  int filled_parts = 0;
  std::size_t points = 0;

  bool
  isSolved() const
  {
    return points > 0;
  }
};

/** In which quantity the noise of a sensor is symmetric. */
enum class NoiseKind { Range, Inverse };

/** Part of the tile that a sample lies in. */
using PartOf = std::vector<std::uint8_t>;

constexpr std::size_t min_piece_points = 12;
constexpr double max_tile_radius = 0.2, max_cube_radius = 0.3; // metres
constexpr double largest_radius = 0.5; // of a tile that cannot be divided, metres

double
variance(const RaySample& sample, double distance, const RangeNoise& noise)
{
  const double sd = noise.sigma(distance, static_cast<double>(sample.sigma));
  const double inverse_sd = sd / (distance * distance);
  return inverse_sd * inverse_sd;
}

/** The inverse distance of a sample as a linear function of its noise: 1 / distance is
 * larger on average than that of the true distance, and over the length of a corridor
 * the curvature of a floor by a tenth of a millimetre adds up to decimetres.
 * \param[in] model inverse distance of the plane */
double
response(const RaySample& sample, double model, NoiseKind kind)
{
  const auto inverse = static_cast<double>(sample.inverse);
  return kind == NoiseKind::Inverse ? inverse : 2 * model - model * model / inverse;
}

/** Solves for the plane with weights and responses at the inverse distances that
 * \a modelOf returns. */
template <typename ModelOf>
bool
regress(const std::vector<RaySample>& samples,
        const RangeNoise& noise,
        NoiseKind kind,
        const ModelOf& modelOf,
        Eigen::Vector3d& plane)
{
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const RaySample& sample : samples) {
    const Eigen::Vector3d ray = sample.ray.cast<double>();
    const double model = modelOf(sample, ray);
    if (!(model > 0))
      return false;
    const double weight = 1 / variance(sample, 1 / model, noise);
    products.noalias() += weight * ray * ray.transpose();
    right += weight * response(sample, model, kind) * ray;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(products);
  const Eigen::Vector3d diagonal = solver.vectorD();
  if (!(diagonal.minCoeff() > 1e-12 * diagonal.maxCoeff()))
    return false;
  plane = solver.solve(right);
  return plane.allFinite();
}

RayFit
fitRays(const std::vector<RaySample>& samples,
        const PartOf& part_of,
        const RangeNoise& noise,
        NoiseKind kind)
{
  RayFit fit;
  if (samples.size() < min_piece_points)
    return fit;
  Eigen::Vector3d plane;
  const auto measured = [](const RaySample& sample, const Eigen::Vector3d&) {
    return static_cast<double>(sample.inverse);
  };
  if (!regress(samples, noise, NoiseKind::Inverse, measured, plane))
    return fit;
  const Eigen::Vector3d first = plane;
  const auto predicted = [&first](const RaySample&, const Eigen::Vector3d& ray) {
    return first.dot(ray);
  };
  if (!regress(samples, noise, kind, predicted, plane))
    return fit;
  double sum = 0, weights[parts] = {}, means[parts] = {};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const RaySample& sample = samples[i];
    const Eigen::Vector3d ray = sample.ray.cast<double>();
    const double model = plane.dot(ray);
    if (!(model > 0))
      return fit;
    const double error = response(sample, model, kind) - model;
    const double weight = 1 / variance(sample, 1 / model, noise);
    sum += weight * error * error;
    weights[part_of[i]] += weight;
    means[part_of[i]] += weight * error;
  }
  fit.plane = plane;
  fit.points = samples.size();
  fit.chi2 = sum / static_cast<double>(samples.size() - 3);
  const double mean_weight = std::accumulate(weights, weights + parts, 0.0) /
                             static_cast<double>(samples.size());
  double square = 0, expected = 0;
  for (int part = 0; part < parts; ++part)
    if (weights[part] > 0) {
      const double mean = means[part] / weights[part];
      const double extra = noise.common * noise.common / mean_weight;
      fit.part_chi2 += mean * mean / (1 / weights[part] + extra);
      square += mean * mean * mean_weight;
      expected += mean_weight / weights[part];
      ++fit.filled_parts;
    }
  const double free = 1 - 3.0 / std::max(fit.filled_parts, 4);
  fit.part_variance = square / fit.filled_parts - expected * free / fit.filled_parts;
  return fit;
}

/** Strict, because pieces with a sliver of the next surface tilt distant views, which
 * adds up along a corridor; quartering gives them a second chance. */
bool
isPlanar(const RayFit& fit)
{
  const double free = static_cast<double>(fit.points) - 3;
  const double limit = 1.1 * (1 + 2 * std::sqrt(2 / free));
  const double part_free = fit.filled_parts - 3;
  return fit.chi2 < limit && fit.filled_parts > 3 &&
         fit.part_chi2 < part_free + 1.5 * std::sqrt(2 * part_free);
}

/** The piece of a fitted plane.
 * \return false if it is seen too obliquely, is too large, or its normal is uncertain */
bool
makePiece(const std::vector<RaySample>& samples,
          const Eigen::Vector3d& plane,
          const RangeNoise& noise,
          double max_radius,
          PlanePiece& piece)
{
  constexpr double min_cosine = 0.17, max_normal_sd = 0.35;
  const double length = plane.norm();
  const Eigen::Vector3d away = plane / length;
  piece.normal = -away;
  piece.cluster.setZero();
  for (const RaySample& sample : samples) {
    const Eigen::Vector3d ray = sample.ray.cast<double>();
    const double distance = 1 / plane.dot(ray);
    const double sd =
        noise.sigma(distance, static_cast<double>(sample.sigma)) * away.dot(ray);
    const double weight = 1 / (sd * sd);
    Eigen::Vector4d point;
    point << distance * ray, 1;
    piece.cluster.noalias() += weight * point * point.transpose();
  }
  const double weight = piece.weight();
  piece.center = piece.cluster.col(3).head<3>() / weight;
  const Eigen::Matrix3d spread = piece.cluster.topLeftCorner<3, 3>() / weight -
                                 piece.center * piece.center.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread,
                                                            Eigen::EigenvaluesOnly);
  const double narrow = std::max(axes.eigenvalues()[1], 1e-12);
  piece.radius = std::sqrt(std::max(spread.trace(), 0.0));
  piece.normal_sd = 1 / std::sqrt(weight * narrow);
  return away.dot(piece.center.normalized()) > min_cosine &&
         piece.normal_sd < max_normal_sd && piece.radius < max_radius &&
         piece.cluster.allFinite();
}

/** Cuts an organized view. */
class TileCutter {
public:
  TileCutter(std::vector<RaySample> samples,
             std::size_t width,
             NoiseKind kind,
             const RangeNoise& noise)
  : samples_(std::move(samples))
  , width_(width)
  , kind_(kind)
  , noise_(noise)
  {}

  static constexpr std::size_t largest = 32, smallest = 8; // pixels

  /** Calls visit (samples, fit) for all tiles of the largest size. */
  template <typename Visit>
  void
  visitTiles(const Visit& visit)
  {
    for (std::size_t y = 0; y < height(); y += largest)
      for (std::size_t x = 0; x < width_; x += largest) {
        gather({x, y, x + largest, y + largest});
        visit(tile_, fitRays(tile_, part_of_, noise_, kind_));
      }
  }

  void
  cut(std::vector<PlanePiece>& pieces)
  {
    for (std::size_t y = 0; y < height(); y += largest)
      for (std::size_t x = 0; x < width_; x += largest)
        cutTile(x, y, largest, pieces);
  }

private:
  /** Pixels from (left, top) to before (right, bottom). */
  struct Window {
    std::size_t left, top, right, bottom;
  };

  void
  cutTile(std::size_t x,
          std::size_t y,
          std::size_t size,
          std::vector<PlanePiece>& pieces)
  {
    const Window tile{x, y, x + size, y + size};
    gather(tile);
    if (tile_.size() < min_piece_points)
      return;
    const RayFit fit = fitRays(tile_, part_of_, noise_, kind_);
    PlanePiece piece;
    if (fit.isSolved() && isPlanar(fit) &&
        makeInnerPiece(
            fit, tile, size > smallest ? max_tile_radius : largest_radius, piece))
      pieces.push_back(piece);
    else if (size > smallest)
      for (const std::size_t dy : {std::size_t{0}, size / 2})
        for (const std::size_t dx : {std::size_t{0}, size / 2})
          cutTile(x + dx, y + dy, size / 2, pieces);
  }

  /** The piece of a planar tile, without the quarters of it beyond which the surface
   * does not go on: it may end within them already, and the few points of the next
   * surface, which noise hides, would pull all pieces of this edge the same way. On the
   * other sides the rest must go on, too: else it leans against the edge. */
  bool
  makeInnerPiece(RayFit fit, const Window& tile, double max_radius, PlanePiece& piece)
  {
    const std::array<bool, 4> ends = endsOf(fit.plane, tile);
    if (ends != std::array<bool, 4>{}) {
      const std::size_t strip = (tile.right - tile.left) / parts_across;
      gather({tile.left + (ends[0] ? strip : 0),
              tile.top + (ends[1] ? strip : 0),
              tile.right - (ends[2] ? strip : 0),
              tile.bottom - (ends[3] ? strip : 0)});
      fit = fitRays(tile_, part_of_, noise_, kind_);
      if (!fit.isSolved())
        return false;
      const std::array<bool, 4> ends_now = endsOf(fit.plane, tile);
      for (std::size_t side = 0; side < 4; ++side)
        if (ends_now[side] && !ends[side])
          return false;
    }
    return makePiece(tile_, fit.plane, noise_, max_radius, piece);
  }

  /** Does a plane end at the left, upper, right and lower side of a tile? */
  std::array<bool, 4>
  endsOf(const Eigen::Vector3d& plane, const Window& tile) const
  {
    const std::size_t strip = (tile.right - tile.left) / parts_across;
    return {tile.left > 0 &&
                !goesOn(plane, {tile.left - strip, tile.top, tile.left, tile.bottom}),
            tile.top > 0 &&
                !goesOn(plane, {tile.left, tile.top - strip, tile.right, tile.top}),
            !goesOn(plane, {tile.right, tile.top, tile.right + strip, tile.bottom}),
            !goesOn(plane, {tile.left, tile.bottom, tile.right, tile.bottom + strip})};
  }

  /** Do the measured points of a window lie on a plane, on average? Where nothing is
   * measured, no other surface can have come in. */
  bool
  goesOn(const Eigen::Vector3d& plane, const Window& window) const
  {
    constexpr double limit = 3; // standard deviations
    double weights = 0, sum = 0, count = 1e-9;
    for (std::size_t y = window.top; y < std::min(window.bottom, height()); ++y)
      for (std::size_t x = window.left; x < std::min(window.right, width_); ++x) {
        const RaySample& sample = samples_[y * width_ + x];
        if (!(sample.inverse > 0))
          continue;
        const double model = plane.dot(sample.ray.cast<double>());
        if (!(model > 0))
          return false;
        const double weight = 1 / variance(sample, 1 / model, noise_);
        weights += weight;
        sum += weight * (response(sample, model, kind_) - model);
        count += 1;
      }
    const double common = noise_.common * noise_.common * weights / count;
    return sum * sum <= limit * limit * weights * (1 + common);
  }

  std::size_t
  height() const
  {
    return samples_.size() / width_;
  }

  void
  gather(const Window& window)
  {
    const std::size_t bottom = std::min(window.bottom, height()),
                      right = std::min(window.right, width_);
    tile_.clear();
    part_of_.clear();
    for (std::size_t y = window.top; y < bottom; ++y)
      for (std::size_t x = window.left; x < right; ++x) {
        const RaySample& sample = samples_[y * width_ + x];
        if (!(sample.inverse > 0))
          continue;
        tile_.push_back(sample);
        part_of_.push_back(static_cast<std::uint8_t>(
            (y - window.top) * parts_across / (window.bottom - window.top) *
                parts_across +
            (x - window.left) * parts_across / (window.right - window.left)));
      }
  }

  std::vector<RaySample> samples_;
  std::size_t width_;
  NoiseKind kind_;
  const RangeNoise& noise_;
  std::vector<RaySample> tile_;
  PartOf part_of_;
};

/** Cuts a view without an image into cubes. */
class CubeCutter {
public:
  CubeCutter(std::vector<RaySample> samples, const RangeNoise& noise)
  : samples_(std::move(samples))
  , noise_(noise)
  {
    samples_.erase(std::remove_if(samples_.begin(),
                                  samples_.end(),
                                  [](const RaySample& s) { return !(s.inverse > 0); }),
                   samples_.end());
  }

  static constexpr double largest = 1, smallest = 0.25; // metres

  template <typename Visit>
  void
  visitTiles(const Visit& visit)
  {
    forEachCube([&](std::vector<RaySample>& cube) { visit(cube, fit(cube)); });
  }

  void
  cut(std::vector<PlanePiece>& pieces)
  {
    forEachCube([&](std::vector<RaySample>& cube) { cutCube(cube, largest, pieces); });
  }

private:
  static std::array<std::int64_t, 3>
  cellOf(const RaySample& sample, double edge)
  {
    const Eigen::Vector3d point =
        sample.ray.cast<double>() / static_cast<double>(sample.inverse);
    return {static_cast<std::int64_t>(std::floor(point.x() / edge)),
            static_cast<std::int64_t>(std::floor(point.y() / edge)),
            static_cast<std::int64_t>(std::floor(point.z() / edge))};
  }

  /** Calls visit (samples) for each cube of an edge length. */
  template <typename Visit>
  static void
  divide(const std::vector<RaySample>& samples, double edge, const Visit& visit)
  {
    std::vector<std::pair<std::array<std::int64_t, 3>, std::size_t>> order;
    order.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      order.emplace_back(cellOf(samples[i], edge), i);
    std::sort(order.begin(), order.end());
    std::vector<RaySample> cube;
    for (std::size_t i = 0; i < order.size(); ++i) {
      cube.push_back(samples[order[i].second]);
      if (i + 1 == order.size() || order[i + 1].first != order[i].first) {
        visit(cube);
        cube.clear();
      }
    }
  }

  template <typename Visit>
  void
  forEachCube(const Visit& visit)
  {
    divide(samples_, largest, visit);
  }

  void
  cutCube(std::vector<RaySample>& cube, double edge, std::vector<PlanePiece>& pieces)
  {
    if (cube.size() < min_piece_points)
      return;
    const RayFit found = fit(cube);
    PlanePiece piece;
    if (found.isSolved() && isPlanar(found) &&
        makePiece(cube, found.plane, noise_, max_cube_radius, piece))
      pieces.push_back(piece);
    else if (edge > smallest)
      divide(cube, edge / 2, [&](std::vector<RaySample>& part) {
        cutCube(part, edge / 2, pieces);
      });
  }

  /** Parts are cells of the direction's image, as seen along the mean ray. */
  RayFit
  fit(const std::vector<RaySample>& cube)
  {
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const RaySample& sample : cube)
      mean += sample.ray;
    const Eigen::Vector3f right = mean.unitOrthogonal(),
                          down = mean.normalized().cross(right);
    Eigen::Array2f low(1e9F, 1e9F), high = -low;
    for (const RaySample& sample : cube) {
      const Eigen::Array2f place(sample.ray.dot(right), sample.ray.dot(down));
      low = low.min(place);
      high = high.max(place);
    }
    const Eigen::Array2f scale = parts_across / (high - low).max(1e-9F);
    part_of_.clear();
    for (const RaySample& sample : cube) {
      const Eigen::Array2f place(sample.ray.dot(right), sample.ray.dot(down));
      const Eigen::Array2f cell = ((place - low) * scale).min(parts_across - 0.5F);
      part_of_.push_back(static_cast<std::uint8_t>(
          static_cast<int>(cell.y()) * parts_across + static_cast<int>(cell.x())));
    }
    return fitRays(cube, part_of_, noise_, NoiseKind::Range);
  }

  std::vector<RaySample> samples_;
  const RangeNoise& noise_;
  PartOf part_of_;
};

std::vector<RaySample>
samplesOf(const AdjustedView& view, PieceCounts& counts)
{
  std::vector<RaySample> samples(view.points.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3f point = view.points[i];
    RaySample& sample = samples[i];
    sample = {Eigen::Vector3f::Zero(), 0, 1};
    const double distance = point.cast<double>().norm();
    if (!point.allFinite()) {
      ++counts.invalid_points;
      continue;
    }
    ++counts.points;
    if (!(distance > 0.01 && distance < 1e4))
      continue;
    if (view.sigmas) {
      std::memcpy(&sample.sigma,
                  reinterpret_cast<const char*>(view.sigmas) + i * view.sigma_stride,
                  sizeof(float));
      if (!(sample.sigma > 1e-6F && sample.sigma < 100))
        continue;
    }
    sample.ray = (point.cast<double>() / distance).cast<float>();
    sample.inverse = static_cast<float>(1 / distance);
  }
  return samples;
}

bool
isImage(const AdjustedView& view)
{
  return view.width > 1 && view.points.size() > view.width &&
         fitPinhole(view.points, view.width).has_value();
}

/** Calls visit (cutter) with the cutter for the kind of a view. */
template <typename Visit>
void
withCutter(const AdjustedView& view,
           const RangeNoise& noise,
           PieceCounts& counts,
           const Visit& visit)
{
  std::vector<RaySample> samples = samplesOf(view, counts);
  if (isImage(view)) {
    // Depth images without sigma come from triangulation, which is uniform in 1/z.
    const NoiseKind kind = view.sigmas ? NoiseKind::Range : NoiseKind::Inverse;
    TileCutter cutter(std::move(samples), view.width, kind, noise);
    visit(cutter);
  }
  else {
    CubeCutter cutter(std::move(samples), noise);
    visit(cutter);
  }
}

} // namespace

std::size_t
RangeNoise::binOf(double distance)
{
  const double place = 2 * std::log2(std::max(distance, 0.125) / 0.125);
  return std::min(static_cast<std::size_t>(place), bins - 1);
}

void
RangeNoise::set(const std::array<double, bins>& factors)
{
  for (std::size_t bin = 0; bin < bins; ++bin) {
    factors_[bin] = 0;
    for (std::size_t step = 0; step < bins && !(factors_[bin] > 0); ++step) {
      if (bin >= step && factors[bin - step] > 0)
        factors_[bin] = factors[bin - step];
      else if (bin + step < bins && factors[bin + step] > 0)
        factors_[bin] = factors[bin + step];
    }
    if (!(factors_[bin] > 0))
      factors_[bin] = 1;
  }
}

RangeNoise
measureRangeNoise(const AdjustedViewReader& read, std::size_t views)
{
  constexpr std::size_t max_views = 16, min_tiles = 20;
  constexpr double planar = 0.3; // share of the tiles that is taken as planar
  const RangeNoise units;
  std::array<std::vector<double>, RangeNoise::bins> squares;
  std::vector<std::pair<double, double>> commons; // chi^2 and part variance of a tile
  std::vector<std::size_t> bins;
  const std::size_t step = 1 + (views - 1) / max_views;
  PieceCounts counts;
  for (std::size_t i = 0; i < views; i += step)
    read(i, [&](const AdjustedView& view) {
      withCutter(view, units, counts, [&](auto& cutter) {
        cutter.visitTiles([&](const std::vector<RaySample>& tile, const RayFit& fit) {
          constexpr std::size_t enough = 40;
          if (!fit.isSolved() || tile.size() < enough)
            return;
          const double free = static_cast<double>(tile.size() - 3);
          // the quantile of planes is that much below their mean
          const double square = fit.chi2 / (1 - 0.52 * std::sqrt(2 / free));
          const std::size_t bin = RangeNoise::binOf(
              1 / fit.plane.dot(tile[tile.size() / 2].ray.cast<double>()));
          squares[bin].push_back(square);
          commons.emplace_back(fit.chi2, fit.part_variance);
          bins.push_back(bin);
        });
      });
    });
  std::array<double, RangeNoise::bins> factors{};
  bool is_known = false;
  std::vector<double> all;
  for (std::size_t bin = 0; bin < RangeNoise::bins; ++bin) {
    all.insert(all.end(), squares[bin].begin(), squares[bin].end());
    if (squares[bin].size() < min_tiles)
      continue;
    factors[bin] = std::sqrt(quantileOf(squares[bin], planar));
    is_known = true;
  }
  if (!is_known) // small clouds: the same at all distances
    factors[0] = std::sqrt(quantileOf(all, planar));
  RangeNoise noise;
  noise.set(factors);
  std::vector<double> shares;
  for (std::size_t i = 0; i < commons.size(); ++i) {
    const double factor =
        noise.sigma(0.125 * std::pow(2, 0.5 * static_cast<double>(bins[i]) + 0.25), 1);
    if (commons[i].first < 1.2 * factor * factor)
      shares.push_back(commons[i].second / (factor * factor));
  }
  noise.common = std::sqrt(std::max(quantileOf(shares, 0.5), 0.0));
  return noise;
}

std::vector<PlanePiece>
piecesOf(const AdjustedView& view, const RangeNoise& noise, PieceCounts& counts)
{
  std::vector<PlanePiece> pieces;
  withCutter(view, noise, counts, [&](auto& cutter) { cutter.cut(pieces); });
  return pieces;
}

} // namespace pcl::acmap
