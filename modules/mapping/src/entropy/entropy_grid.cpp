#include "entropy_grid.h"

#include "wall_direction.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

std::vector<double>
gaussian(double sigma)
{
  const auto radius = static_cast<std::size_t>(std::ceil(3 * sigma));
  std::vector<double> kernel(radius + 1, 1);
  double sum = 1;
  for (std::size_t i = 1; i <= radius; ++i) {
    const double at = static_cast<double>(i) / sigma;
    kernel[i] = std::exp(-0.5 * at * at);
    sum += 2 * kernel[i];
  }
  for (double& weight : kernel)
    weight /= sum;
  return kernel;
}

std::int64_t
marginOf(const MapEntropySettings& settings)
{
  return static_cast<std::int64_t>(
      std::ceil(3 * settings.smoothing / settings.bin_size));
}

double
minusEntropySum(const double* first, std::size_t size)
{
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i)
    if (first[i] > 0)
      sum += first[i] * std::log2(first[i]);
  return sum;
}

/** H of bins that sum up to \a points, of the sum of q log2 q. */
double
entropyOf(double sum, double points)
{
  return std::max(0.0, std::log2(points) - sum / points);
}

} // namespace

void
BinRange::add(std::int64_t x, std::int64_t z)
{
  least_x = std::min(least_x, x);
  most_x = std::max(most_x, x);
  least_z = std::min(least_z, z);
  most_z = std::max(most_z, z);
}

void
BinRange::add(const BinRange& other)
{
  if (other.isEmpty())
    return;
  add(other.least_x, other.least_z);
  add(other.most_x, other.most_z);
}

int
layersOf(const MapEntropySettings& settings)
{
  return settings.direction_aware ? wall_directions + 1 : 1;
}

EntropyGrid::EntropyGrid(const BinRange& range, const MapEntropySettings& settings)
: settings_(settings)
, kernel_(gaussian(settings.smoothing / settings.bin_size))
{
  const std::int64_t margin = marginOf(settings);
  first_x_ = range.least_x - margin;
  first_z_ = range.least_z - margin;
  width_ = static_cast<std::size_t>(range.most_x + margin - first_x_ + 1);
  depth_ = static_cast<std::size_t>(range.most_z + margin - first_z_ + 1);
  layers_ = static_cast<std::size_t>(layersOf(settings));
}

double
EntropyGrid::binsOf(const BinRange& range, const MapEntropySettings& settings)
{
  const double margins = 2 * static_cast<double>(marginOf(settings)) + 1;
  return (static_cast<double>(range.most_x - range.least_x) + margins) *
         (static_cast<double>(range.most_z - range.least_z) + margins) *
         layersOf(settings);
}

void
EntropyGrid::allocate()
{
  bins_.assign(width_ * depth_ * layers_, 0);
}

void
EntropyGrid::convolveRow(std::size_t row, std::vector<double>& scratch)
{
  // Across rows (x) into the scratch, then along it (z) into the spare bins.
  const std::size_t x = row % width_;
  const double* middle = &bins_[row * depth_];
  const std::size_t radius = kernel_.size() - 1;
  scratch.assign(depth_ + 2 * radius, 0);
  double* sums = scratch.data() + radius;
  for (std::size_t j = 0; j < depth_; ++j)
    sums[j] = kernel_[0] * middle[j];
  for (std::size_t i = 1; i <= radius; ++i) {
    const double* before = i <= x ? middle - i * depth_ : nullptr;
    const double* after = x + i < width_ ? middle + i * depth_ : nullptr;
    for (std::size_t j = 0; before && j < depth_; ++j)
      sums[j] += kernel_[i] * before[j];
    for (std::size_t j = 0; after && j < depth_; ++j)
      sums[j] += kernel_[i] * after[j];
  }
  double* out = &spare_[row * depth_];
  for (std::size_t j = 0; j < depth_; ++j)
    out[j] = kernel_[0] * sums[j];
  for (std::size_t i = 1; i <= radius; ++i) {
    const double* before = sums - i;
    const double* after = sums + i;
    for (std::size_t j = 0; j < depth_; ++j)
      out[j] += kernel_[i] * (before[j] + after[j]);
  }
}

void
EntropyGrid::smooth()
{
  if (kernel_.size() == 1)
    return;
  spare_.resize(bins_.size());
  oneapi::tbb::parallel_for(
      oneapi::tbb::blocked_range<std::size_t>(0, width_ * layers_, 16),
      [&](const oneapi::tbb::blocked_range<std::size_t>& rows) {
        std::vector<double> scratch;
        for (std::size_t row = rows.begin(); row < rows.end(); ++row)
          convolveRow(row, scratch);
      });
  bins_.swap(spare_);
}

MapEntropyTerms
EntropyGrid::terms(double points)
{
  const std::size_t rows = width_ * layers_;
  std::vector<double> sums(rows), masses(rows);
  oneapi::tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    const double* first = &bins_[row * depth_];
    sums[row] = minusEntropySum(first, depth_);
    for (std::size_t j = 0; j < depth_; ++j)
      masses[row] += first[j];
  });
  on_x_.assign(width_, 0);
  on_z_.assign(depth_, 0);
  double sum = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    sum += sums[row];
    on_x_[row % width_] += masses[row];
    for (std::size_t j = 0; j < depth_; ++j)
      on_z_[j] += bins_[row * depth_ + j];
  }
  MapEntropyTerms terms;
  terms.points = static_cast<std::size_t>(points);
  terms.joint = entropyOf(sum, points);
  terms.along_x = entropyOf(minusEntropySum(on_x_.data(), width_), points);
  terms.along_z = entropyOf(minusEntropySum(on_z_.data(), depth_), points);
  terms.total =
      terms.joint + settings_.projection_weight * (terms.along_x + terms.along_z);
  return terms;
}

void
EntropyGrid::toSensitivities(double points)
{
  // dH / dQ = -log2 Q - 1 / ln 2, whose constant cancels as the shares always sum to 1.
  // Where Q = 0 the splines' derivatives are 0 too.
  const auto surprise = [points](double q) {
    return q > 0 ? -std::log2(q / points) : 0;
  };
  const double weight = settings_.projection_weight;
  std::vector<double> of_z(depth_);
  for (std::size_t j = 0; j < depth_; ++j)
    of_z[j] = weight * surprise(on_z_[j]);
  oneapi::tbb::parallel_for(std::size_t{0}, width_ * layers_, [&](std::size_t row) {
    const double of_x = weight * surprise(on_x_[row % width_]);
    double* bins = &bins_[row * depth_];
    for (std::size_t j = 0; j < depth_; ++j)
      bins[j] = surprise(bins[j]) + of_x + of_z[j];
  });
  smooth();
}

void
EntropyGrid::tell(MapEntropyReport& report) const
{
  report.bins_x = width_;
  report.bins_z = depth_;
  report.layers = layers_;
}

} // namespace pcl::acmap
