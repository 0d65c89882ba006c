#include "entropy_grid.h"

#include "wall_direction.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap {
namespace {

constexpr std::int64_t block = BinArray::block;

std::int64_t
radiusOf(const MapEntropySettings& settings)
{
  return static_cast<std::int64_t>(
      std::ceil(3 * (settings.smoothing / settings.bin_size)));
}

/** What the grid has around the range: one bin more than the Gaussian reaches, as
 * rounding may move a cell there. */
std::int64_t
marginOf(const MapEntropySettings& settings)
{
  return radiusOf(settings) + 1;
}

std::int64_t
wholeBlocks(std::int64_t bins)
{
  return (bins + block - 1) / block * block;
}

std::size_t
sizeOf(std::int64_t bins)
{
  return static_cast<std::size_t>(bins);
}

std::vector<double>
gaussian(const MapEntropySettings& settings)
{
  const double sigma = settings.smoothing / settings.bin_size;
  std::vector<double> kernel(sizeOf(radiusOf(settings)) + 1, 1);
  double sum = 1;
  for (std::size_t i = 1; i < kernel.size(); ++i) {
    const double at = static_cast<double>(i) / sigma;
    kernel[i] = std::exp(-0.5 * at * at);
    sum += 2 * kernel[i];
  }
  for (double& weight : kernel)
    weight /= sum;
  return kernel;
}

std::vector<double>
convolve(const std::vector<double>& values, const std::vector<double>& kernel)
{
  std::vector<double> sums(values.size(), 0);
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size()) - 1;
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  for (std::ptrdiff_t i = -radius; i <= radius; ++i) {
    const double weight = kernel[static_cast<std::size_t>(std::abs(i))];
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, -i);
         j < std::min(size, size - i);
         ++j)
      sums[static_cast<std::size_t>(j)] +=
          weight * values[static_cast<std::size_t>(j + i)];
  }
  return sums;
}

double
log2Of(double value)
{
  double values[block] = {value};
  entropyBins().takeLogarithms(values, block);
  return values[0];
}

/** H of bins that sum up to \a weight, of the sum of q log2 q. */
double
entropyOf(double sum, double weight)
{
  return std::max(0.0, log2Of(weight) - sum / weight);
}

std::int64_t
lengthOf(const FilledRun& run)
{
  return std::int64_t{run.end - run.begin} * block;
}

constexpr std::size_t chunk_length = 64;

std::size_t
chunksOf(const std::vector<FilledRun>& runs)
{
  return (runs.size() + chunk_length - 1) / chunk_length;
}

/** Calls body (chunk, first, last) for chunks of fixed length, in any order. */
template <typename Body>
void
forChunks(const std::vector<FilledRun>& runs, const Body& body)
{
  oneapi::tbb::parallel_for(std::size_t{0}, chunksOf(runs), [&](std::size_t chunk) {
    const std::size_t first = chunk * chunk_length;
    const std::size_t last = std::min(first + chunk_length, runs.size());
    body(chunk, runs.data() + first, runs.data() + last);
  });
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

EntropyGrid::EntropyGrid(const MapEntropySettings& settings)
: settings_(settings)
, kernel_(gaussian(settings))
, radius_(radiusOf(settings))
, layers_(layersOf(settings))
{}

double
EntropyGrid::binsOf(const BinRange& range, const MapEntropySettings& settings)
{
  const double margins = 2 * static_cast<double>(marginOf(settings)) + 1;
  return (static_cast<double>(range.most_x - range.least_x) + margins) *
         (static_cast<double>(range.most_z - range.least_z) + margins) *
         layersOf(settings);
}

void
EntropyGrid::Field::reserve(std::int64_t bins, std::int64_t room)
{
  constexpr std::size_t line = 64; // bytes
  values_.resize(
      std::max(values_.size(), sizeOf(bins + 2 * room) + line / sizeof(double)), 0);
  const auto first = reinterpret_cast<std::uintptr_t>(values_.data() + room);
  room_ = room + static_cast<std::int64_t>((line - first % line) / sizeof(double));
}

void
EntropyGrid::begin(const BinRange& range)
{
  clear();
  const std::int64_t margin = marginOf(settings_);
  first_x_ = range.least_x - margin;
  first_z_ = range.least_z - margin;
  width_ = range.most_x + margin - first_x_ + 1;
  depth_ = wholeBlocks(range.most_z + margin - first_z_ + 1);
  const std::int64_t bins = width_ * depth_ * layers_;
  bins_.reserve(bins, wholeBlocks(radius_) + block);
  half_smoothed_.reserve(radius_ > 0 ? bins : 0, wholeBlocks(radius_) + block);
  empty_row_.assign(sizeOf(depth_), 0);
  marks_.blocks = depth_ / block;
  marks_.rows = width_;
  marks_.marks.assign(sizeOf(bins / block), 0);
  array_ = {bins_.begin(), depth_, width_ * depth_, marks_.marks.data()};
}

void
EntropyGrid::clear()
{
  const auto clear_runs = [&](const std::vector<FilledRun>& runs, Field& field) {
    for (const FilledRun& run : runs)
      std::fill_n(field.begin() + firstOf(run), lengthOf(run), 0.0);
  };
  clear_runs(spread_, bins_);
  clear_runs(widened_, half_smoothed_);
  filled_.clear();
  widened_.clear();
  spread_.clear();
}

void
EntropyGrid::smoothAcross(Field& from, const std::vector<FilledRun>& runs, Field& to)
{
  forChunks(runs, [&](std::size_t, const FilledRun* first, const FilledRun* last) {
    std::vector<const double*> rows(2 * sizeOf(radius_) + 1);
    for (const FilledRun* run = first; run < last; ++run) {
      const std::int64_t layer = run->row / width_ * width_;
      for (std::int64_t i = -radius_; i <= radius_; ++i)
        rows[sizeOf(i + radius_)] =
            run->row + i >= layer && run->row + i < layer + width_
                ? from.begin() + firstOf(*run) + i * depth_
                : empty_row_.data();
      entropyBins().smoothAcross(rows.data(),
                                 {kernel_.data(), radius_},
                                 lengthOf(*run),
                                 to.begin() + firstOf(*run));
    }
  });
}

void
EntropyGrid::smoothAlong(Field& from,
                         const FilledRun* first,
                         const FilledRun* last,
                         Field& to)
{
  // Over the end of a row lies the margin of the next: empty, or of no use to cells.
  for (const FilledRun* run = first; run < last; ++run)
    entropyBins().smoothAlong(from.begin() + firstOf(*run),
                              {kernel_.data(), radius_},
                              lengthOf(*run),
                              to.begin() + firstOf(*run));
}

void
EntropyGrid::project()
{
  on_x_.assign(sizeOf(wholeBlocks(width_)), 0);
  on_z_.assign(sizeOf(depth_), 0);
  for (const FilledRun& run : filled_)
    on_x_[sizeOf(run.row % width_)] += entropyBins().sumUp(
        bins_.begin() + firstOf(run), lengthOf(run), &on_z_[sizeOf(run.begin * block)]);
  on_x_ = convolve(on_x_, kernel_);
  on_z_ = convolve(on_z_, kernel_);
}

double
EntropyGrid::takeLogarithms()
{
  std::vector<double> sums(chunksOf(spread_));
  forChunks(spread_,
            [&](std::size_t chunk, const FilledRun* first, const FilledRun* last) {
              if (radius_ > 0)
                smoothAlong(half_smoothed_, first, last, bins_);
              for (const FilledRun* run = first; run < last; ++run)
                sums[chunk] += entropyBins().takeLogarithms(
                    bins_.begin() + firstOf(*run), lengthOf(*run));
            });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void
EntropyGrid::takeSensitivities()
{
  // dH / dQ = -log2 Q - 1 / ln 2, whose constant cancels as the shares always sum to 1,
  // and so does the weight's. Where Q = 0 the splines' derivatives are 0 too.
  const double mu = settings_.projection_weight;
  for (const FilledRun& run : spread_) {
    double* bins = bins_.begin() + firstOf(run);
    const double* on_z = &on_z_[sizeOf(run.begin * block)];
    const double on_x = on_x_[sizeOf(run.row % width_)];
    for (std::int64_t j = 0; j < lengthOf(run); ++j)
      bins[j] = -bins[j] - mu * (on_x + on_z[j]);
  }
  if (radius_ == 0)
    return;
  forChunks(widened_, [&](std::size_t, const FilledRun* first, const FilledRun* last) {
    smoothAlong(bins_, first, last, half_smoothed_);
  });
  smoothAcross(half_smoothed_, filled_, bins_);
}

MapEntropyTerms
EntropyGrid::finish(double weight, bool sensitivities)
{
  findRuns(marks_, 0, 2, filled_); // a mark stands for three rows
  project();
  if (radius_ > 0) {
    findRuns(marks_, radius_, radius_ + 2, widened_);
    widenRuns(widened_,
              static_cast<std::int32_t>(wholeBlocks(radius_) / block),
              static_cast<std::int32_t>(marks_.blocks),
              spread_);
    smoothAcross(bins_, widened_, half_smoothed_);
  }
  else
    spread_ = filled_;
  const EntropyBins& loops = entropyBins();
  MapEntropyTerms terms;
  terms.joint = entropyOf(takeLogarithms(), weight);
  terms.along_x =
      entropyOf(loops.takeLogarithms(on_x_.data(), wholeBlocks(width_)), weight);
  terms.along_z = entropyOf(loops.takeLogarithms(on_z_.data(), depth_), weight);
  terms.total =
      terms.joint + settings_.projection_weight * (terms.along_x + terms.along_z);
  if (sensitivities)
    takeSensitivities();
  return terms;
}

void
EntropyGrid::tell(MapEntropyReport& report) const
{
  report.bins_x = sizeOf(width_);
  report.bins_z = sizeOf(depth_);
  report.layers = sizeOf(layers_);
}

} // namespace pcl::acmap
