#include "texturing/canvas_painting.h"

#include <pcl/core/impl/map_pictures.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl::acmap::texturing {
namespace {

/** Brightness ratios of two views. */
struct Overlap {
  double count = 0;
  double sum = 0; ///< of log (brightness in the first view / in the second view)
};

using ViewPair = std::pair<std::int32_t, std::int32_t>;
using Overlaps = std::map<ViewPair, Overlap>;

bool
tells(const Sample& sample)
{
  constexpr int dark = 12, bright = 245;
  const auto [minimum, maximum] =
      std::minmax_element(sample.color.begin(), sample.color.end());
  return sample.weight > 0 && *maximum > dark && *maximum<bright&& * minimum> 0;
}

/** Sums the ratios of all pairs of samples of a texel. */
class OverlapSums {
public:
  OverlapSums()
  {
    for (std::size_t sum = 1; sum < logs_.size(); ++sum)
      logs_[sum] = std::log(static_cast<double>(sum));
  }

  void
  add(const Canvas::Samples& samples)
  {
    std::array<bool, Canvas::max_samples> is_told;
    std::transform(samples.begin(), samples.end(), is_told.begin(), tells);
    Found* found = found_.data();
    for (std::size_t a = 0; a < samples.size(); ++a)
      for (std::size_t b = a + 1; b < samples.size(); ++b, ++found)
        if (is_told[a] && is_told[b]) {
          if (samples[a].view < samples[b].view)
            add(samples[a], samples[b], *found);
          else
            add(samples[b], samples[a], *found);
        }
  }

  const Overlaps&
  overlaps() const
  {
    return overlaps_;
  }

private:
  /** A pair of views and its overlap. Neighbouring texels mostly have the same. */
  struct Found {
    ViewPair pair{-1, -1};
    Overlap* overlap = nullptr;
  };

  double
  logOf(const Sample& sample) const
  {
    return logs_[std::size_t{sample.color[0]} + sample.color[1] + sample.color[2]];
  }

  void
  add(const Sample& first, const Sample& second, Found& found)
  {
    constexpr double max_ratio =
        0.7; // a factor of two; larger ratios have other causes
    const double ratio = logOf(first) - logOf(second);
    if (std::abs(ratio) > max_ratio)
      return;
    const ViewPair pair{first.view, second.view};
    if (found.pair != pair)
      found = {pair, &overlaps_[pair]};
    ++found.overlap->count;
    found.overlap->sum += ratio;
  }

  std::array<double, 3 * 255 + 1> logs_{}; ///< of the sum of three colours
  std::array<Found, Canvas::max_samples*(Canvas::max_samples - 1) / 2> found_;
  Overlaps overlaps_;
};

/** The smallest level that at most a share of the counted texels exceed. */
std::size_t
levelAbove(const std::array<std::size_t, 256>& counts, double share)
{
  std::size_t all = 0;
  for (const std::size_t count : counts)
    all += count;
  std::size_t brighter = 0, level = counts.size() - 1;
  while (level > 0 && static_cast<double>(brighter + counts[level]) <=
                          share * static_cast<double>(all))
    brighter += counts[level--];
  return level;
}

} // namespace

double
displayExposure(const CompactMap& map)
{
  constexpr double bright_share = 0.05, bright_level = 0.85 * 255;
  constexpr double clipped_share = 0.01, maximum = 16;
  std::array<std::size_t, 256> luminances{}, maxima{};
  for (const TexturePicture* const picture : picturesOf(map))
    for (std::size_t i = 0; i < picture->kinds.size(); ++i) {
      if (picture->kinds[i] == TexelKind::None)
        continue;
      const std::uint8_t* const c = &picture->colors.values[3 * i];
      // of Rec. 709, in units of 1/10000, so that it is exact
      ++luminances[(2126U * c[0] + 7152U * c[1] + 722U * c[2]) / 10000U];
      ++maxima[std::max({c[0], c[1], c[2]})];
    }
  const auto luminance = static_cast<double>(levelAbove(luminances, bright_share));
  const auto limit = static_cast<double>(levelAbove(maxima, clipped_share));
  const double exposure =
      std::min(bright_level / std::max(luminance, 1.0), 255 / std::max(limit, 1.0));
  return std::clamp(exposure, 1.0, maximum);
}

std::vector<double>
exposureGains(const std::vector<Canvas>& canvases, std::size_t views)
{
  OverlapSums sums;
  for (const Canvas& canvas : canvases)
    for (const auto& samples : canvas.samples)
      sums.add(samples);

  // log g_first - log g_second = - mean log ratio, weighted by the root of the texel
  // count
  const auto size = static_cast<Eigen::Index>(views);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  constexpr double prior = 1; // weight of a gain of 1
  for (Eigen::Index view = 0; view < size; ++view)
    entries.emplace_back(view, view, prior);
  for (const auto& [pair, overlap] : sums.overlaps()) {
    const double weight = std::sqrt(overlap.count);
    const double ratio = weight * overlap.sum / overlap.count;
    entries.emplace_back(pair.first, pair.first, weight);
    entries.emplace_back(pair.second, pair.second, weight);
    entries.emplace_back(pair.first, pair.second, -weight);
    entries.emplace_back(pair.second, pair.first, -weight);
    right[pair.first] -= ratio;
    right[pair.second] += ratio;
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd logs =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  std::vector<double> gains;
  for (Eigen::Index view = 0; view < size; ++view)
    gains.push_back(std::isfinite(logs[view]) ? std::exp(logs[view]) : 1.0);
  return gains;
}

} // namespace pcl::acmap::texturing
