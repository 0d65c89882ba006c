#include "entropy_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::bench {
namespace {

/** x' = c x + s z + x0 and z' = c z - s x + z0, in bins. */
struct PassMotion {
  float c, s, x0, z0;
  std::int32_t row;
};

constexpr std::size_t chunk = 1024;

inline __attribute__((always_inline)) void
findBins(const float* x,
         const float* z,
         std::size_t size,
         const PassMotion& motion,
         std::int32_t* bins)
{
  for (std::size_t i = 0; i < size; ++i) {
    const auto u =
        static_cast<std::int32_t>(motion.c * x[i] + motion.s * z[i] + motion.x0);
    const auto v =
        static_cast<std::int32_t>(motion.c * z[i] - motion.s * x[i] + motion.z0);
    bins[i] = u * motion.row + v;
  }
}

void
plainBins(const float* x,
          const float* z,
          std::size_t size,
          const PassMotion& motion,
          std::int32_t* bins)
{
  findBins(x, z, size, motion, bins);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void
wideBins(const float* x,
         const float* z,
         std::size_t size,
         const PassMotion& motion,
         std::int32_t* bins)
{
  findBins(x, z, size, motion, bins);
}
#endif

auto*
chooseVariant()
{
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
    return wideBins;
#endif
  return plainBins;
}

PassMotion
motionOf(const PlanarPose& pose, double bin_size)
{
  return {static_cast<float>(std::cos(pose.theta)),
          static_cast<float>(std::sin(pose.theta)),
          static_cast<float>(pose.x / bin_size),
          static_cast<float>(pose.z / bin_size),
          0};
}

} // namespace

EntropyPass::EntropyPass(const EntropyMap& map, double bin_size)
: bin_size_(bin_size)
{
  Eigen::Array2f minimum = Eigen::Array2f::Constant(std::numeric_limits<float>::max());
  Eigen::Array2f maximum = -minimum;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    Observation& observation = observations_.emplace_back();
    observation.pose = map.poses[i];
    const PassMotion motion = motionOf(map.poses[i], bin_size);
    for (const Eigen::Vector3f& point : map.points[i]) {
      const float x = point[0] / static_cast<float>(bin_size);
      const float z = point[2] / static_cast<float>(bin_size);
      observation.x.push_back(x);
      observation.z.push_back(z);
      const Eigen::Array2f place(motion.c * x + motion.s * z + motion.x0,
                                 motion.c * z - motion.s * x + motion.z0);
      minimum = minimum.min(place);
      maximum = maximum.max(place);
    }
  }
  x0_ = std::floor(minimum[0]) - 1;
  z0_ = std::floor(minimum[1]) - 1;
  row_ = static_cast<std::int32_t>(maximum[1] - z0_) + 2;
  counts_.resize(static_cast<std::size_t>(row_) *
                 (static_cast<std::size_t>(maximum[0] - x0_) + 2));
}

template <typename Visit>
void
EntropyPass::forEachChunk(const Visit& visit)
{
  static auto* const find_bins = chooseVariant();
  std::int32_t bins[chunk];
  for (const Observation& observation : observations_) {
    PassMotion motion = motionOf(observation.pose, bin_size_);
    motion.x0 -= x0_;
    motion.z0 -= z0_;
    motion.row = row_;
    for (std::size_t first = 0; first < observation.x.size(); first += chunk) {
      const std::size_t size = std::min(chunk, observation.x.size() - first);
      find_bins(&observation.x[first], &observation.z[first], size, motion, bins);
      visit(bins, size);
    }
  }
}

std::int64_t
EntropyPass::find()
{
  std::int64_t sum = 0;
  forEachChunk(
      [&](const std::int32_t* bins, std::size_t size) { sum += bins[size / 2]; });
  return sum;
}

std::int64_t
EntropyPass::count()
{
  std::fill(counts_.begin(), counts_.end(), 0);
  forEachChunk([&](const std::int32_t* bins, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      ++counts_[static_cast<std::size_t>(bins[i])];
  });
  return counts_[counts_.size() / 2];
}

} // namespace pcl::acmap::bench
