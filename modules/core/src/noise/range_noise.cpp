#include "noise/range_noise.h"

#include "noise/point_sample.h"

#include <pcl/core/voxel_windows.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap {

namespace {

/** A point with its voxel, used to group the points by voxel. */
struct Sample {
  VoxelKey voxel;
  std::uint32_t point;
};

std::vector<Sample>
samplesByVoxel(const PointView& points, const VoxelLattice& lattice)
{
  constexpr std::size_t enough = 1 << 14;
  const PointSample chosen(points.size(), enough);
  std::vector<Sample> samples;
  VoxelHit hit;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (chosen.holds(points[i]) && lattice.locate(points[i], hit))
      samples.push_back({voxelKey(hit.place), static_cast<std::uint32_t>(i)});
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.voxel != b.voxel ? a.voxel < b.voxel : a.point < b.point;
  });
  return samples;
}

class RangeBins {
public:
  void
  add(double distance, double deviation)
  {
    bins_[static_cast<int>(std::floor(2 * std::log2(distance)))].push_back(deviation);
  }

  std::vector<NoiseScale::Range>
  finish()
  {
    constexpr std::size_t enough = 100;
    constexpr double median_of_normal = 0.6745;
    std::vector<NoiseScale::Range> ranges;
    for (auto& [bin, values] : bins_) {
      if (values.size() < enough)
        continue;
      const auto middle =
          values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), middle, values.end());
      ranges.push_back(
          {std::exp2((bin + 0.5) / 2), *middle / median_of_normal, values.size()});
    }
    return ranges;
  }

private:
  std::map<int, std::vector<double>> bins_;
};

} // namespace

std::vector<NoiseScale::Range>
measureRangeNoise(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels)
{
  const VoxelWindows windows(voxels);
  const std::vector<Sample> samples = samplesByVoxel(points, voxels.lattice);
  RangeBins bins;
  VoxelWindows::Cursor cursor(windows, 1);
  std::size_t next = 0;
  for (std::size_t v = 0; v < windows.size() && next < samples.size(); ++v) {
    const VoxelKey voxel = voxelOf(voxels.cells[windows.firstCell(v)].key);
    while (next < samples.size() && samples[next].voxel < voxel)
      ++next;
    if (next == samples.size() || samples[next].voxel != voxel)
      continue;
    const PlaneFit fit = fitPlane(
        sumParts(voxels, cursor.moveTo(v), [](const WindowPart&) { return true; }));
    if (!fit.isPlanar())
      continue;
    const Eigen::Vector3d mean =
        voxels.lattice.center(placeOf(voxel)) + fit.mean * voxels.lattice.edge();
    for (; next < samples.size() && samples[next].voxel == voxel; ++next) {
      const Eigen::Vector3f* sensor = sensors[samples[next].point];
      if (!sensor)
        continue;
      const Eigen::Vector3d point = points[samples[next].point].cast<double>();
      const Eigen::Vector3d ray = point - sensor->cast<double>();
      const double cosine = std::abs(ray.normalized().dot(fit.normal));
      // rays at grazing incidence contain little information about the noise along them
      constexpr double min_cosine = 0.3;
      if (cosine > min_cosine)
        bins.add(ray.norm(), std::abs((point - mean).dot(fit.normal)) / cosine);
    }
  }
  return bins.finish();
}

} // namespace pcl::acmap
