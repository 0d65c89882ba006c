#include "consolidation/candidates.h"
#include "consolidation/normal_signs.h"
#include "consolidation/sources.h"
#include "consolidation/thinning.h"

#include <pcl/core/parallel.h>
#include <pcl/filters/consolidation_kernel.h>

#include <cmath>

namespace pcl::acmap {

namespace {

/** Returns the requested voxel size or an automatic one; 0 if it cannot be determined.
 * The remarks of the noise scale are reported. */
double
chooseVoxel(const PointView& points,
            const ConsolidationSettings& settings,
            ConsolidationReport& report)
{
  if (settings.voxel_size > 0)
    return settings.voxel_size;
  const NoiseScale scale = measureNoiseScale(points, SensorView(), settings.threads);
  report.remarks.insert(
      report.remarks.end(), scale.remarks.begin(), scale.remarks.end());
  return automaticVoxel(scale);
}

void
describe(const VoxelMoments& voxels,
         const NoiseProfile& noise,
         const SurfaceFits& fits,
         ConsolidationReport& report)
{
  report.voxel_size = voxels.lattice.edge();
  report.sigma = noise.medianThickness() * report.voxel_size;
  report.two_sided_voxels = fits.second.size();
  report.narrowed_windows = fits.narrowed;
  std::vector<float> counts;
  for (const SurfaceFit& fit : fits.first)
    counts.push_back(fit.count);
  if (counts.empty())
    return;
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  report.residual = report.sigma / std::sqrt(std::max(*middle, 1.0f));
}

void
remarkOnPoints(const VoxelMoments& voxels, ConsolidationReport& report)
{
  report.invalid_points = voxels.invalid_points;
  report.distant_points = voxels.distant_points;
  if (voxels.cells.empty())
    report.remarks.emplace_back("nothing to consolidate: no point is finite");
  if (report.distant_points > 0)
    report.remarks.push_back(std::to_string(report.distant_points) +
                             " points lie farther from the others than 2^19 voxels "
                             "and were left out");
}

void
faceSensors(std::vector<Representative>& representatives,
            const SensorView& sensors,
            double edge,
            ConsolidationReport& report)
{
  report.sensors_fit = fitTheirSensors(representatives, sensors);
  if (report.sensors_fit)
    return;
  makeNormalsAgree(representatives, edge);
  report.remarks.emplace_back("where the sensors stood is unknown, or does not fit "
                              "the surface: the normals "
                              "agree with their neighbours' instead");
}

} // namespace

Consolidation
consolidatePoints(const PointView& points,
                  const SensorView& sensors,
                  const ColorView& colors,
                  const ConsolidationSettings& settings,
                  const Progress& progress,
                  ConsolidationReport& report)
{
  return withThreads(settings.threads, [&] {
    report = {};
    report.points = points.size();
    StepTimer timer(report);
    progress.tell(0.0, "noise scale");
    Consolidation result;
    const double edge = chooseVoxel(points, settings, report);
    timer.finish("noise scale");
    if (!(edge > 0)) {
      report.remarks.emplace_back(
          "no voxel size can be told from these points: set one");
      return result;
    }
    progress.tell(0.2, "voxels");
    const VoxelMoments voxels =
        sumVoxels(points, sensors, edge, settings.threads, colors);
    const VoxelWindows windows(voxels);
    report.voxels = windows.size();
    remarkOnPoints(voxels, report);
    timer.finish("voxels");

    progress.tell(0.6, "surfaces");
    NoiseProfile noise;
    const SurfaceFits fits = fitSurfaces(windows, noise);
    describe(voxels, noise, fits, report);
    timer.finish("surfaces");

    progress.tell(0.8, "representatives");
    const std::vector<Candidate> candidates = makeCandidates(windows, fits, sensors);
    const Thinning thinning = thinOut(candidates, edge);
    for (const std::uint32_t kept : thinning.kept) {
      result.representatives.push_back(candidates[kept].representative);
      if (std::isnan(candidates[kept].representative.normal.x()))
        ++report.without_normal;
    }
    report.representatives = result.representatives.size();
    faceSensors(result.representatives, sensors, edge, report);
    const std::vector<std::int32_t> of_cell =
        representativesOfCells(windows, candidates, thinning);
    setMeanColors(voxels, of_cell, result.representatives);
    timer.finish("representatives");
    if (settings.keep_sources) {
      progress.tell(0.9, "sources");
      result.representative_of = representativesOf(points, sensors, voxels, of_cell);
      timer.finish("sources");
    }
    progress.tell(1.0, "done");
    return result;
  });
}

} // namespace pcl::acmap
