#include "entropy_grid.h"

#include "wall_direction.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
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

std::int64_t
wholeBlocks(std::int64_t bins)
{
  return (bins + block - 1) / block * block;
}

/** Margin of the grid around the range: one bin more than the radius of smoothing,
 * because a cell may be moved there by rounding. */
struct Margin {
  std::int64_t x, z;

  explicit Margin(const MapEntropySettings& settings)
  : x(radiusOf(settings) + 1)
  , z(wholeBlocks(radiusOf(settings)) + 1)
  {}
};

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
  entropyBins().takeExactLogarithms(values, block);
  return values[0];
}

/** Entropy H of bins with the sum \a weight, given the sum of q log2 q. */
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

/** Copies blocks without writing beyond them, as other runs may follow closely. */
void
copyBlocks(const float* from, std::int64_t size, float* to)
{
  for (std::int64_t j = 0; j < size; j += block)
    std::memcpy(to + j, from + j, sizeof(float) * block);
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
  min_x = std::min(min_x, x);
  max_x = std::max(max_x, x);
  min_z = std::min(min_z, z);
  max_z = std::max(max_z, z);
}

void
BinRange::add(const BinRange& other)
{
  if (other.isEmpty())
    return;
  add(other.min_x, other.min_z);
  add(other.max_x, other.max_z);
}

int
layersOf(const MapEntropySettings& settings)
{
  return settings.direction_aware ? wall_directions + 1 : 1;
}

EntropyGrid::EntropyGrid(const MapEntropySettings& settings)
: settings_(settings)
, kernel_(gaussian(settings))
, float_kernel_(kernel_.begin(), kernel_.end())
, radius_(radiusOf(settings))
, layers_(layersOf(settings))
, aside_(wholeBlocks(radius_))
{
  double sum = -static_cast<double>(float_kernel_[0]);
  for (const float weight : float_kernel_)
    sum += 2 * static_cast<double>(weight);
  smoothed_weight_ = sum * sum;
}

double
EntropyGrid::binsOf(const BinRange& range, const MapEntropySettings& settings)
{
  const Margin margin(settings);
  return static_cast<double>(range.max_x - range.min_x + 2 * margin.x + 1) *
         static_cast<double>(range.max_z - range.min_z + 2 * margin.z + 1) *
         layersOf(settings);
}

double
unitFor(double weight)
{
  constexpr int bits_of_map = 14;
  return weight > 0 ? std::ldexp(1.0, bits_of_map - std::ilogb(weight)) : 1;
}

void
EntropyGrid::Field::reserve(std::int64_t bins, std::int64_t room)
{
  values_.resize(std::max(values_.size(), sizeOf(bins + 2 * room)), 0);
  room_ = room;
}

void
EntropyGrid::begin(const BinRange& range)
{
  for (const FilledRun& run : filled_)
    std::fill_n(bins_.begin() + firstOf(run), lengthOf(run), 0.0F);
  filled_.clear();
  const Margin margin(settings_);
  first_x_ = range.min_x - margin.x;
  first_z_ = range.min_z - margin.z;
  width_ = range.max_x + margin.x - first_x_ + 1;
  depth_ = wholeBlocks(range.max_z + margin.z - first_z_ + 1);
  const std::int64_t bins = width_ * depth_ * layers_;
  bins_.reserve(bins, radius_ * depth_ + block);
  logarithms_.reserve(bins, block);
  marks_.blocks = depth_ / block;
  marks_.rows = width_;
  marks_.marks.assign(sizeOf(bins / block), 0);
  array_ = {bins_.begin(), depth_, width_ * depth_, marks_.marks.data()};
}

/** Consecutive runs in one array. */
class EntropyGrid::Strips {
public:
  /** \param[in] room number of zeros before the first and after the last run */
  Strips(const FilledRun* first,
         const FilledRun* last,
         std::int64_t aside,
         std::int64_t room)
  : size_(std::accumulate(first,
                          last,
                          std::int64_t{0},
                          [=](std::int64_t sum, const FilledRun& run) {
                            return sum + lengthOf(run) + 2 * aside;
                          }))
  , room_(room)
  , values_(sizeOf(size_ + 2 * room), 0)
  {}

  float*
  begin()
  {
    return values_.data() + room_;
  }

  std::int64_t
  size() const
  {
    return size_;
  }

private:
  std::int64_t size_, room_;
  std::vector<float> values_;
};

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
  const SmoothingKernel kernel{float_kernel_.data(), radius_};
  std::vector<double> sums(chunksOf(spread_));
  forChunks(spread_,
            [&](std::size_t chunk, const FilledRun* first, const FilledRun* last) {
              // Each run ends with zeros, which smoothing along x does not write.
              Strips smoothed(first, last, 0, aside_);
              float* strip = smoothed.begin();
              for (const FilledRun* run = first; run < last; strip += lengthOf(*run++))
                entropyBins().smoothAcross(bins_.begin() + firstOf(*run) + aside_,
                                           depth_,
                                           kernel,
                                           lengthOf(*run) - 2 * aside_,
                                           strip + aside_);
              Strips logarithms(first, last, 0, 0);
              sums[chunk] = entropyBins().takeLogarithms(
                  smoothed.begin(), kernel, smoothed.size(), logarithms.begin());
              strip = logarithms.begin();
              for (const FilledRun* run = first; run < last; strip += lengthOf(*run++))
                copyBlocks(strip, lengthOf(*run), logarithms_.begin() + firstOf(*run));
            });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void
EntropyGrid::takeSensitivities()
{
  // dH / dQ = -log2 Q - 1 / ln 2. The constant cancels because the shares always sum to
  // 1, and so does that of the weight. Where Q = 0, the derivatives of the splines are
  // also 0.
  const SmoothingKernel kernel{float_kernel_.data(), radius_};
  const std::vector<float> on_x = sensitivitiesOf(on_x_);
  const std::vector<float> on_z = sensitivitiesOf(on_z_);
  forChunks(filled_, [&](std::size_t, const FilledRun* first, const FilledRun* last) {
    Strips smoothed(first, last, aside_, 0);
    float* strip = smoothed.begin();
    for (const FilledRun* run = first; run < last; ++run) {
      const std::int64_t length = lengthOf(*run) + 2 * aside_;
      entropyBins().smoothAcross(
          logarithms_.begin() + firstOf(*run) - aside_, depth_, kernel, length, strip);
      strip += length;
    }
    strip = smoothed.begin();
    for (const FilledRun* run = first; run < last; ++run) {
      entropyBins().takeFromLevels(
          strip + aside_,
          kernel,
          {on_x[sizeOf(run->row % width_)], &on_z[sizeOf(run->begin * block)]},
          lengthOf(*run),
          bins_.begin() + firstOf(*run));
      strip += lengthOf(*run) + 2 * aside_;
    }
  });
}

std::vector<float>
EntropyGrid::sensitivitiesOf(const std::vector<double>& logarithms) const
{
  const std::vector<double> smoothed = convolve(logarithms, kernel_);
  std::vector<float> sensitivities(smoothed.size());
  std::transform(
      smoothed.begin(), smoothed.end(), sensitivities.begin(), [&](double logarithm) {
        return static_cast<float>(-settings_.projection_weight * logarithm);
      });
  return sensitivities;
}

MapEntropyTerms
EntropyGrid::finish(double weight, bool sensitivities)
{
  const BlockBits bits(marks_); // a mark represents three rows
  bits.findRuns(0, 2, 0, filled_);
  bits.findRuns(radius_, radius_ + 2, aside_ / block, spread_);
  project();
  const EntropyBins& loops = entropyBins();
  MapEntropyTerms terms;
  terms.joint = entropyOf(takeLogarithms(), weight * smoothed_weight_);
  terms.along_x =
      entropyOf(loops.takeExactLogarithms(on_x_.data(), wholeBlocks(width_)), weight);
  terms.along_z = entropyOf(loops.takeExactLogarithms(on_z_.data(), depth_), weight);
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
