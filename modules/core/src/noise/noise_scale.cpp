#include "noise/base_edge.h"
#include "noise/depth_step_noise.h"
#include "noise/range_noise.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/parallel.h>
#include <pcl/core/voxel_windows.h>

#include <cmath>

namespace pcl::acmap {

namespace {

/** Results of the windows of one scale. Metres. */
struct ScaleLevel {
  double edge = 0;
  double thickness = 0;
  double spacing = 0;
  double sparse_spacing = 0;
  double occupancy = 0;    ///< points per voxel
  double planar_share = 0; ///< share of the windows with a surface that are planar
  std::size_t planes = 0;
};

double
quantileOf(std::vector<double>& values, double share)
{
  if (values.empty())
    return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(
                                          share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** Mean of the middle half of the values: as robust as the median, and stable if a view
 * has walls with two levels of noise. */
double
midmean(std::vector<double>& values)
{
  if (values.empty())
    return 0;
  std::sort(values.begin(), values.end());
  const std::size_t quarter = values.size() / 4;
  double sum = 0;
  for (std::size_t i = quarter; i < values.size() - quarter; ++i)
    sum += values[i];
  return sum / static_cast<double>(values.size() - 2 * quarter);
}

/** Does the plane pass through the middle voxel, so that the window contains the noise
 * on both sides? */
bool
passesThroughMiddle(const PlaneFit& fit)
{
  return std::abs(fit.mean.dot(fit.normal)) <= fit.normal.cwiseAbs().sum() / 2;
}

struct WindowFigures {
  std::vector<double> thickness;
  std::vector<double> spacing;
  double area = 0; // voxel faces
  std::size_t surfaces = 0;
};

/** Area of a plane in the inner window in voxel faces: the number of columns that
 * contain a point, along the axis closest to the normal, corrected by the slope of the
 * plane. */
double
coveredArea(const std::vector<WindowPart>& parts, const Eigen::Vector3d& normal)
{
  int axis = 0;
  const double steepest = normal.cwiseAbs().maxCoeff(&axis);
  std::array<bool, 9> held{};
  for (const WindowPart& part : parts) {
    const std::array<int, 3> place = {part.dx, part.dy, part.dz};
    held[static_cast<std::size_t>(3 * (place[(axis + 1) % 3] + 1) +
                                  place[(axis + 2) % 3] + 1)] = true;
  }
  return static_cast<double>(std::count(held.begin(), held.end(), true)) / steepest;
}

void
measureWindow(const VoxelMoments& voxels,
              const std::vector<WindowPart>& parts,
              WindowFigures& figures)
{
  constexpr double enough_points = 5;
  const Moments sum = sumParts(voxels, parts, [](const WindowPart&) { return true; });
  if (sum.count < enough_points)
    return;
  const PlaneFit fit = fitPlane(sum);
  if (!passesThroughMiddle(fit))
    return;
  ++figures.surfaces;
  // inverse of the number of voxels per unit of area of the plane
  figures.area += 1 / fit.normal.cwiseAbs().sum();
  if (!fit.isPlanar())
    return;
  figures.thickness.push_back(fit.thickness());
  figures.spacing.push_back(std::sqrt(coveredArea(parts, fit.normal) / fit.count));
}

ScaleLevel
measureLevel(const VoxelMoments& voxels)
{
  const VoxelWindows windows(voxels);
  constexpr std::size_t enough_windows = 1 << 11;
  const std::size_t step = windows.size() / enough_windows + 1;
  WindowFigures all = parallelReduceChunks(
      windows.size(),
      WindowFigures{},
      [&](std::size_t begin, std::size_t end) {
        WindowFigures figures;
        VoxelWindows::Cursor cursor(windows, 1);
        for (std::size_t v = (begin + step - 1) / step * step; v < end; v += step)
          measureWindow(voxels, cursor.moveTo(v), figures);
        return figures;
      },
      [](WindowFigures& sum, const WindowFigures& next) {
        sum.thickness.insert(
            sum.thickness.end(), next.thickness.begin(), next.thickness.end());
        sum.spacing.insert(sum.spacing.end(), next.spacing.begin(), next.spacing.end());
        sum.area += next.area;
        sum.surfaces += next.surfaces;
      });
  ScaleLevel level;
  level.edge = voxels.lattice.edge();
  level.planes = all.thickness.size();
  level.thickness = midmean(all.thickness) * level.edge;
  level.sparse_spacing = quantileOf(all.spacing, 0.75) * level.edge;
  double points = 0;
  for (const VoxelCell& cell : voxels.cells)
    points += cell.moments.count;
  level.spacing =
      std::sqrt(all.area * static_cast<double>(step) / std::max(points, 1.0)) *
      level.edge;
  level.occupancy =
      points / static_cast<double>(std::max<std::size_t>(windows.size(), 1));
  if (all.surfaces > 0)
    level.planar_share =
        static_cast<double>(level.planes) / static_cast<double>(all.surfaces);
  return level;
}

/** Are the voxels large enough that windows contain the noise on both sides of the
 * planes? */
bool
holdsItsNoise(const ScaleLevel& level)
{
  constexpr std::size_t enough_planes = 8;
  return level.planes >= enough_planes && level.edge >= 3 * level.thickness;
}

bool
isMostlyPlanar(const ScaleLevel& level)
{
  return level.planar_share >= 0.5;
}

/** Solves thickness^2 = sigma^2 + (c edge^2)^2 at both scales, where c is the
 * curvature. */
double
thicknessWithoutCurvature(const ScaleLevel& fine, const ScaleLevel& coarse)
{
  const double fine_square = fine.thickness * fine.thickness;
  const double coarse_square = coarse.thickness * coarse.thickness;
  const double square = (16 * fine_square - std::max(coarse_square, fine_square)) / 15;
  return std::sqrt(std::max(square, 0.0));
}

/** The scales from fine to coarse with their voxels. */
struct Pyramid {
  std::vector<VoxelMoments> voxels;
  std::vector<ScaleLevel> levels;

  void
  add(VoxelMoments next)
  {
    levels.push_back(measureLevel(next));
    voxels.push_back(std::move(next));
  }
};

/** Effect of the rounding of the voxel sums on the thickness of a flat surface, metres.
 */
double
roundingOf(const ScaleLevel& level)
{
  return 4 * level.edge / (1 << VoxelLattice::offset_bits);
}

/** Noise has the same thickness at the next scale. Curved surfaces have four times the
 * thickness or are no longer planar, and errors that stereo matching spreads over
 * neighbouring pixels are in between. */
bool
isPlateau(const ScaleLevel& fine, const ScaleLevel& coarse)
{
  constexpr double largest_growth = 1.8;
  constexpr double min_share = 0.75;
  return holdsItsNoise(fine) && isMostlyPlanar(fine) &&
         coarse.thickness <=
             std::max(largest_growth * fine.thickness, roundingOf(coarse)) &&
         coarse.planar_share >= min_share * fine.planar_share;
}

/** Adds scales up to the first plateau.
 * \return the level of the plateau, -1 if there is none */
int
climbToPlateau(Pyramid& pyramid)
{
  constexpr int doublings = 6;
  for (int level = 0; level < doublings; ++level) {
    pyramid.add(coarserVoxels(pyramid.voxels.back()));
    if (isPlateau(pyramid.levels[static_cast<std::size_t>(level)],
                  pyramid.levels.back()))
      return level;
  }
  return -1;
}

/** Best level without a plateau: the first mostly planar level, or the one with the
 * largest share of planes; -1 if no level is suitable. */
int
bestLevel(const std::vector<ScaleLevel>& levels)
{
  int best = -1;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    if (!holdsItsNoise(levels[k]))
      continue;
    if (isMostlyPlanar(levels[k]))
      return static_cast<int>(k);
    if (best < 0 ||
        levels[k].planar_share > levels[static_cast<std::size_t>(best)].planar_share)
      best = static_cast<int>(k);
  }
  return best;
}

void
setSpacing(const ScaleLevel& fine, const ScaleLevel& coarse, NoiseScale& scale)
{
  // voxels with few points miss sparse regions
  const ScaleLevel& filled = fine.occupancy < 6 ? coarse : fine;
  scale.spacing = filled.spacing;
  scale.sparse_spacing = filled.sparse_spacing;
}

void
setSigma(const ScaleLevel& fine, const ScaleLevel& coarse, NoiseScale& scale)
{
  const double thickness = thicknessWithoutCurvature(fine, coarse);
  scale.confidence = fine.planar_share;
  if (thickness <= std::max(fine.spacing / 50, roundingOf(fine))) {
    scale.remarks.emplace_back("no noise: the points lie on their surface");
    return;
  }
  scale.confidence *= thickness / fine.thickness;
  scale.sigma = thickness;
}

/** Sets the result for a cloud with few planes, or whose thickness grows at every
 * scale. */
void
concludeWithoutPlateau(const std::vector<ScaleLevel>& levels, NoiseScale& scale)
{
  const int best = bestLevel(levels);
  if (best < 0) {
    scale.remarks.emplace_back("no noise scale: no place is plane");
    return;
  }
  const ScaleLevel& fine = levels[static_cast<std::size_t>(best)];
  const ScaleLevel& coarse = levels[static_cast<std::size_t>(best) + 1];
  setSpacing(fine, coarse, scale);
  // between 1.8 of a plateau and 4 of a smooth surface
  constexpr double growth_of_shapes = 2.2;
  if (isMostlyPlanar(fine) && !(coarse.thickness < growth_of_shapes * fine.thickness)) {
    scale.confidence = fine.planar_share;
    scale.remarks.emplace_back("no noise: the points lie on a curved surface");
    return;
  }
  setSigma(fine, coarse, scale);
  scale.remarks.emplace_back(
      "doubtful noise scale: no scale has the noise of the next");
}

/** Number of points per voxel at the finest scale: small for small clouds, and limited
 * so that the number of voxels of a large cloud stays moderate. */
double
occupancyFor(std::size_t points)
{
  return std::clamp(static_cast<double>(points) / (1 << 14), 3.0, 64.0);
}

NoiseScale
measureInSpace(const PointView& points, const SensorView& sensors, unsigned threads)
{
  NoiseScale scale;
  const double edge = edgeForOccupancy(points, occupancyFor(points.size()));
  if (!(edge > 0)) {
    scale.remarks.emplace_back("no noise scale: the points have no extent");
    return scale;
  }
  Pyramid pyramid;
  pyramid.add(sumVoxels(points, sensors, edge, threads));
  const int plateau = climbToPlateau(pyramid);
  if (plateau < 0) {
    concludeWithoutPlateau(pyramid.levels, scale);
    return scale;
  }
  const auto fine = static_cast<std::size_t>(plateau);
  setSpacing(pyramid.levels[fine], pyramid.levels[fine + 1], scale);
  setSigma(pyramid.levels[fine], pyramid.levels[fine + 1], scale);
  if (sensors.isKnown() && scale.hasNoise()) {
    const bool is_wide = pyramid.levels[fine].edge > 8 * scale.sigma;
    scale.ranges =
        measureRangeNoise(points, sensors, pyramid.voxels[is_wide ? fine : fine + 1]);
  }
  return scale;
}

} // namespace

NoiseScale
measureNoiseScale(const PointView& points,
                  const SensorView& sensors,
                  unsigned threads,
                  std::size_t width)
{
  return withThreads(threads, [&] {
    NoiseScale scale = measureInSpace(points, sensors, threads);
    if (scale.spacing > 0)
      applyDepthSteps(points, width, scale);
    return scale;
  });
}

} // namespace pcl::acmap
