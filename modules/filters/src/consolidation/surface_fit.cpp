#include "consolidation/surface_fit.h"

#include "consolidation/window_planes.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** Samples the noise of the window of a voxel, using only one octant of sensor
 * directions, so that the far side of a thin wall has no effect. */
void
sampleNoise(const VoxelMoments& voxels,
            std::size_t first_cell,
            const std::vector<WindowPart>& parts,
            std::vector<PlaneNoise>& samples)
{
  const unsigned octant = octantOf(voxels.cells[first_cell].key);
  std::vector<WindowPart> seen_alike;
  for (const WindowPart& part : parts)
    if (octantOf(voxels.cells[part.cell].key) == octant)
      seen_alike.push_back(part);
  const PlaneFit fit =
      widestPlane(voxels, seen_alike, [](const WindowPart&) { return true; });
  if (fit.isPlanar())
    samples.push_back(noiseOf(voxels,
                              seen_alike,
                              fit.normal.cast<float>(),
                              static_cast<float>(fit.thickness())));
}

double
pointsOf(const VoxelMoments& voxels, const std::vector<WindowPart>& parts)
{
  double count = 0;
  for (const WindowPart& part : parts)
    count += voxels.cells[part.cell].moments.count;
  return count;
}

NoiseProfile
fitWidest(const VoxelWindows& windows, LargeVector<SurfaceFit>& fits)
{
  fits.resize(windows.size());
  const VoxelMoments& voxels = windows.voxels();
  using Samples = std::vector<PlaneNoise>;
  Samples samples = parallelReduceChunks(
      windows.size(),
      Samples{},
      [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t voxels_a_sample = 16;
        Samples chunk;
        VoxelWindows::Cursor cursor(windows, 2);
        for (std::size_t v = begin; v < end; ++v) {
          const std::vector<WindowPart>& parts = cursor.moveTo(v);
          SurfaceFit& fit = fits[v];
          fit = toSurfaceFit(
              widestPlane(voxels, parts, [](const WindowPart&) { return true; }));
          fit.noise = noiseOf(voxels, parts, fit.normal, fit.thickness);
          fit.is_whole = fit.count == static_cast<float>(pointsOf(voxels, parts));
          if (v % voxels_a_sample == 0)
            sampleNoise(voxels, windows.firstCell(v), parts, chunk);
        }
        return chunk;
      },
      [](Samples& all, const Samples& next) {
        all.insert(all.end(), next.begin(), next.end());
      });
  return NoiseProfile(samples);
}

/** Result for a chunk of voxels. */
struct Refinement {
  LargeVector<std::pair<std::uint32_t, SurfaceFit>> second;
  std::size_t narrowed = 0;
};

void
refineVoxel(const VoxelWindows& windows,
            std::size_t voxel,
            const std::vector<WindowPart>& parts,
            const NoiseProfile& noise,
            SurfaceFit& fit,
            Refinement& refinement)
{
  const SidesOfVoxel sides = separateSides(windows.voxels(), parts, noise, fit);
  if (sides.found) {
    fit = sides.first;
    if (sides.has_second)
      refinement.second.emplace_back(static_cast<std::uint32_t>(voxel), sides.second);
  }
  else if (narrowPlane(windows.voxels(), parts, noise, fit))
    ++refinement.narrowed;
}

} // namespace

SurfaceFits
fitSurfaces(const VoxelWindows& windows, const Progress& progress, NoiseProfile& noise)
{
  SurfaceFits fits;
  progress.tell(0.6, "surfaces");
  noise = fitWidest(windows, fits.first);
  progress.tell(0.7, "creases");
  Refinement all = parallelReduceChunks(
      windows.size(),
      Refinement{},
      [&](std::size_t begin, std::size_t end) {
        Refinement chunk;
        VoxelWindows::Cursor cursor(windows, 2);
        for (std::size_t v = begin; v < end; ++v) {
          SurfaceFit& fit = fits.first[v];
          if (!fit.is_whole)
            widenWithinNoise(windows.voxels(), cursor.moveTo(v), noise, fit);
          if (fit.thickness > thick_factor * noise.expectedThickness(fit.noise))
            refineVoxel(windows, v, cursor.moveTo(v), noise, fit, chunk);
        }
        return chunk;
      },
      [](Refinement& sum, const Refinement& next) {
        sum.second.insert(sum.second.end(), next.second.begin(), next.second.end());
        sum.narrowed += next.narrowed;
      });
  fits.second = std::move(all.second);
  fits.narrowed = all.narrowed;
  return fits;
}

} // namespace pcl::acmap
