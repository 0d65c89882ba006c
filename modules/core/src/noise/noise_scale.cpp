#include "noise/best_split.h"
#include "noise/point_sample.h"

#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/surface_noise.h>
#include <pcl/core/impl/voxel_moments.h>
#include <pcl/core/impl/voxel_windows.h>
#include <pcl/core/impl/zero_points.h>
#include <pcl/core/noise_scale.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace pcl::acmap {

namespace {

/** Collects values in parallel, in the order of the points.
 * \param[in] take appends the values of a point: take (i, values) */
template <typename Value, typename Take>
std::vector<Value>
gather(std::size_t size, const Take& take)
{
  using Values = std::vector<Value>;
  return parallelReduceChunks(
      size,
      Values{},
      [&](std::size_t begin, std::size_t end) {
        Values values;
        for (std::size_t i = begin; i < end; ++i)
          take(i, values);
        return values;
      },
      [](Values& all, const Values& next) {
        all.insert(all.end(), next.begin(), next.end());
      });
}

std::vector<Eigen::Vector3f>
sampleOf(const PointView& points)
{
  constexpr std::size_t wanted = 1 << 12;
  const PointSample chosen(points.size(), wanted);
  return gather<Eigen::Vector3f>(points.size(), [&](std::size_t i, auto& sample) {
    if (points[i].allFinite() && chosen.holds(points[i]))
      sample.push_back(points[i]);
  });
}

double
extentOf(const std::vector<Eigen::Vector3f>& sample)
{
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (const Eigen::Vector3f& point : sample)
      values.push_back(point[axis]);
    const auto tenth = static_cast<std::ptrdiff_t>(values.size() / 10);
    std::nth_element(values.begin(), values.begin() + tenth, values.end());
    const double minimum = values[static_cast<std::size_t>(tenth)];
    std::nth_element(values.begin(), values.end() - 1 - tenth, values.end());
    extent = std::max(extent, *(values.end() - 1 - tenth) - minimum);
  }
  return extent;
}

/** \brief Estimates the edge in metres at which the occupied voxels of a cloud contain
 * the given number of points on average. It counts the voxels of a sample. Returns 0 if
 * the cloud has no extent. */
double
edgeForOccupancy(const PointView& points, double occupancy)
{
  const std::vector<Eigen::Vector3f> sample = sampleOf(points);
  if (sample.empty())
    return 0;
  double edge = extentOf(sample);
  if (!(edge > 0))
    return 0;
  const PointView view(sample.data(), sizeof(Eigen::Vector3f), sample.size());
  // If a voxel contains four points of the sample, the voxels are occupied as by a
  // surface.
  constexpr double filled = 4;
  double held = 0;
  for (int halving = 0; halving < 40; ++halving) {
    const std::size_t cells = sumVoxels(view, SensorView(), edge, 1).cells.size();
    held = static_cast<double>(sample.size()) /
           static_cast<double>(std::max<std::size_t>(cells, 1));
    if (held <= filled)
      break;
    edge /= 2;
  }
  const double all =
      held * static_cast<double>(points.size()) / static_cast<double>(sample.size());
  return edge * std::sqrt(occupancy / all);
}

/** Noise if the pixels are unknown: that of the quantisation, assuming that the step of
 * a sensor is about twice its own noise. */
NoiseScale::InverseDepth
noiseOfStep(double step)
{
  NoiseScale::InverseDepth noise;
  noise.step = step;
  noise.independent = step / std::sqrt(12.0);
  noise.correlated = step / 2;
  return noise;
}

/** Counts points in bins of a factor of sqrt (2), as for other clouds. */
std::map<int, std::size_t>
countRanges(const PointView& points, std::vector<double>& depths)
{
  std::map<int, std::size_t> bins;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite() || !(point.z() > 0))
      continue;
    const double depth = static_cast<double>(point.z());
    depths.push_back(depth);
    ++bins[static_cast<int>(std::floor(2 * std::log2(depth)))];
  }
  return bins;
}

/** Sets the noise of a view whose depth is quantised; does not change that of other
 * clouds.
 * \param[in] points metres, in the frame of the sensor
 * \param[in] width pixels per row, 0 if the points are not organized
 * \param[in,out] scale the noise of the cloud */
void
applyDepthSteps(const PointView& points, std::size_t width, NoiseScale& scale)
{
  const double step = measureDepthStep(points);
  if (step == 0)
    return;
  NoiseScale::InverseDepth noise = noiseOfStep(step);
  if (width > 0)
    if (const std::optional<DepthView> view = DepthView::recognize(points, width))
      noise = measureInverseDepthNoise(*view, step);
  std::vector<double> depths;
  const std::map<int, std::size_t> bins = countRanges(points, depths);
  const double middle = acmap::medianOf(depths);
  scale.inverse_depth = noise;
  scale.sigma = std::max(scale.sigma, noise.sigma() * middle * middle);
  constexpr std::size_t enough = 100;
  scale.ranges.clear();
  for (const auto& [bin, number] : bins) {
    const double distance = std::exp2((bin + 0.5) / 2);
    if (number >= enough)
      scale.ranges.push_back({distance, noise.sigma() * distance * distance, number});
  }
  scale.remarks.clear(); // quantisation steps look like shapes
  char text[96];
  std::snprintf(text,
                sizeof text,
                "the depth is quantised: steps of %.2g mm at 1 m, %.3g mm at 4 m",
                1000 * step,
                16000 * step);
  scale.remarks.emplace_back(text);
}

/** A point with its voxel, used to group the points by voxel. */
struct VoxelPoint {
  VoxelKey voxel;
  std::uint32_t point;
};

std::vector<VoxelPoint>
samplesByVoxel(const PointView& points, const VoxelLattice& lattice)
{
  constexpr std::size_t enough = 1 << 14;
  const PointSample chosen(points.size(), enough);
  auto samples = gather<VoxelPoint>(points.size(), [&](std::size_t i, auto& values) {
    VoxelHit hit;
    if (chosen.holds(points[i]) && lattice.locate(points[i], hit))
      values.push_back({voxelKey(hit.place), static_cast<std::uint32_t>(i)});
  });
  std::sort(
      samples.begin(), samples.end(), [](const VoxelPoint& a, const VoxelPoint& b) {
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
      ranges.push_back({std::exp2((bin + 0.5) / 2),
                        medianOf(values) / median_of_normal,
                        values.size()});
    }
    return ranges;
  }

private:
  std::map<int, std::vector<double>> bins_;
};

/** \brief Noise along the ray in bins of distance: the distances of the points to the
 * plane of their window, divided by the cosine of the angle of incidence. */
std::vector<NoiseScale::Range>
measureRangeNoise(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels)
{
  const VoxelWindows windows(voxels);
  const std::vector<VoxelPoint> samples = samplesByVoxel(points, voxels.lattice);
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

/** A window that is plane. */
struct PlaneWindow {
  Eigen::Vector3d place; ///< its middle, metres
  double thickness;      ///< edges of a voxel
  bool is_row;           ///< are its points along a line?
};

/** Results of the windows of one scale. Metres. */
struct ScaleLevel {
  double edge = 0;
  double thickness = 0;
  double thinner = 0, thicker = 0; ///< 95 % interval of the thickness
  double spacing = 0;
  double sparse_spacing = 0;
  double occupancy = 0;    ///< points per voxel
  double planar_share = 0; ///< share of the windows with a surface that are planar
  std::vector<PlaneWindow> planes;
};

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

/** An end of the 95 % interval of the middle of sorted values, by their order: neighbouring
 * windows share points, so that no more than some are counted.
 * \param[in] end -1: the lower, 1: the upper one */
double
orderAt(const std::vector<double>& sorted, double end)
{
  constexpr double most = 400;
  if (sorted.empty())
    return 0;
  const auto last = static_cast<double>(sorted.size() - 1);
  const double half = 1 / std::sqrt(std::min(last + 1, most));
  return sorted[static_cast<std::size_t>(
      std::lround(std::clamp(0.5 + end * half, 0.0, 1.0) * last))];
}

/** Does the plane pass through the middle voxel, so that the window contains the noise
 * on both sides? */
bool
passesThroughMiddle(const PlaneFit& fit)
{
  return std::abs(fit.mean.dot(fit.normal)) <= fit.normal.cwiseAbs().sum() / 2;
}

struct WindowFigures {
  std::vector<PlaneWindow> planes;
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
              VoxelKey middle,
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
  constexpr double narrow = 0.1;
  figures.planes.push_back({voxels.lattice.center(placeOf(middle)),
                            fit.thickness(),
                            fit.variances[1] < narrow * fit.variances[2]});
  figures.spacing.push_back(std::sqrt(coveredArea(parts, fit.normal) / fit.count));
}

/** Thicknesses in edges of a voxel. */
std::vector<double>
thicknessesOf(const std::vector<PlaneWindow>& planes)
{
  std::vector<double> thicknesses;
  for (const PlaneWindow& plane : planes)
    thicknesses.push_back(plane.thickness);
  return thicknesses;
}

/** Sets the thickness of a level to that of its planes. */
void
setThickness(ScaleLevel& level)
{
  std::vector<double> thicknesses = thicknessesOf(level.planes);
  level.thickness = midmean(thicknesses) * level.edge;
  level.thinner = std::min(level.thickness, orderAt(thicknesses, -1) * level.edge);
  level.thicker = std::max(level.thickness, orderAt(thicknesses, 1) * level.edge);
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
          measureWindow(voxels,
                        voxelOf(voxels.cells[windows.firstCell(v)].key),
                        cursor.moveTo(v),
                        figures);
        return figures;
      },
      [](WindowFigures& sum, const WindowFigures& next) {
        sum.planes.insert(sum.planes.end(), next.planes.begin(), next.planes.end());
        sum.spacing.insert(sum.spacing.end(), next.spacing.begin(), next.spacing.end());
        sum.area += next.area;
        sum.surfaces += next.surfaces;
      });
  ScaleLevel level;
  level.edge = voxels.lattice.edge();
  level.planes = std::move(all.planes);
  setThickness(level);
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
        static_cast<double>(level.planes.size()) / static_cast<double>(all.surfaces);
  return level;
}

/** Are the voxels large enough that windows contain the noise on both sides of the
 * planes? */
bool
holdsItsNoise(const ScaleLevel& level)
{
  constexpr std::size_t enough_planes = 8;
  return level.planes.size() >= enough_planes && level.edge >= 3 * level.thickness;
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

/** The window of this scale that is nearest to a place. */
const PlaneWindow&
nearestTo(const Eigen::Vector3d& place, const std::vector<PlaneWindow>& planes)
{
  return *std::min_element(
      planes.begin(), planes.end(), [&](const PlaneWindow& a, const PlaneWindow& b) {
        return (a.place - place).squaredNorm() < (b.place - place).squaredNorm();
      });
}

/** Logarithms of the thicknesses of the windows of a level that see more than a row of
 * points, metres; sorted. */
std::vector<double>
logThicknessesOf(const ScaleLevel& level)
{
  std::vector<double> logs;
  for (const PlaneWindow& plane : level.planes)
    if (!plane.is_row)
      logs.push_back(
          std::log(std::max(plane.thickness * level.edge, roundingOf(level))));
  std::sort(logs.begin(), logs.end());
  return logs;
}

bool
isThin(const PlaneWindow& plane, const ScaleLevel& level, double limit)
{
  return plane.thickness * level.edge <= limit;
}

/** Do thin windows of the finest scale lie where the thick ones of a coarse one are? Where
 * the noise is greater, there are none. */
bool
areMixed(const ScaleLevel& finest, const ScaleLevel& coarse, double limit)
{
  constexpr double enough = 0.25;
  std::size_t thick = 0, mixed = 0;
  for (const PlaneWindow& plane : coarse.planes)
    if (!isThin(plane, coarse, limit)) {
      ++thick;
      mixed += isThin(nearestTo(plane.place, finest.planes), finest, limit);
    }
  return static_cast<double>(mixed) >= enough * static_cast<double>(thick);
}

/** The largest thickness, metres, of windows of a coarse scale without steps of the surface,
 * as those of the windows of a facade, if others have steps: the windows are of two kinds, and
 * the thin ones are as thin as at the finest scale. */
std::optional<double>
limitOfSteps(const ScaleLevel& finest, const ScaleLevel& coarse)
{
  constexpr double growth = 1.3, thicker = 4, left = 0.2, fewest = 0.2;
  constexpr std::size_t enough_planes = 40;
  const std::vector<double> fine_logs = logThicknessesOf(finest);
  const std::vector<double> logs = logThicknessesOf(coarse);
  if (std::min(fine_logs.size(), logs.size()) < enough_planes)
    return std::nullopt;
  const Split split = bestSplit(logs);
  const double thin = std::exp(logs[split.first / 2]);
  const double thick = std::exp(logs[(split.first + logs.size()) / 2]);
  if (split.left > left || thick < thicker * thin ||
      static_cast<double>(split.first) < fewest * static_cast<double>(logs.size()))
    return std::nullopt;
  const auto fine_first = static_cast<std::size_t>(
      std::upper_bound(fine_logs.begin(), fine_logs.end(), logs[split.first - 1]) -
      fine_logs.begin());
  const double fine_thin = std::exp(fine_logs[fine_first / 2]);
  const double limit = std::exp(logs[split.first - 1]);
  if (fine_first == 0 || thin > growth * fine_thin || finest.edge < 3 * fine_thin ||
      !areMixed(finest, coarse, limit))
    return std::nullopt;
  return limit;
}

void
keepThin(double limit, ScaleLevel& level)
{
  const auto all = static_cast<double>(level.planes.size());
  level.planes.erase(std::remove_if(level.planes.begin(),
                                    level.planes.end(),
                                    [&](const PlaneWindow& plane) {
                                      return !isThin(plane, level, limit);
                                    }),
                     level.planes.end());
  level.planar_share *= static_cast<double>(level.planes.size()) / all;
  setThickness(level);
}

/** Leaves out the windows with steps, of the two coarsest scales.
 * \return are there any? */
bool
leaveOutSteps(std::vector<ScaleLevel>& levels)
{
  const std::optional<double> limit = limitOfSteps(levels.front(), levels.back());
  if (limit) {
    keepThin(*limit, *(levels.end() - 2));
    keepThin(*limit, levels.back());
  }
  return limit.has_value();
}

/** Has the scale passed from the surfaces to what they enclose? Few windows are planar
 * then, although many were at a finer scale; at still coarser scales, a storey of a
 * building would be one thick plane. */
bool
isBeyondSurfaces(const std::vector<ScaleLevel>& levels)
{
  constexpr double min_share = 0.25, min_remaining_share = 0.25;
  return std::any_of(levels.begin(), levels.end() - 1, [&](const ScaleLevel& finer) {
    return holdsItsNoise(finer) && finer.planar_share >= min_share &&
           levels.back().planar_share < min_remaining_share * finer.planar_share;
  });
}

/** Adds scales up to the first plateau.
 * \return the level of the plateau, -1 if there is none */
int
climbToPlateau(Pyramid& pyramid)
{
  constexpr int doublings = 6;
  for (int level = 0; level < doublings; ++level) {
    pyramid.add(coarserVoxels(pyramid.voxels.back()));
    if (leaveOutSteps(pyramid.levels) ||
        isPlateau(pyramid.levels[static_cast<std::size_t>(level)],
                  pyramid.levels.back()))
      return level;
    if (isBeyondSurfaces(pyramid.levels))
      break;
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
  const double share = thickness / fine.thickness;
  scale.interval = {share * fine.thinner, share * fine.thicker};
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

/** A great noise of few planes may be that of a building, whose storeys look like thick
 * planes from afar: where places that are asked alone contradict it, they decide. Smaller
 * ones may be waves, as stereo has them, which are wider than the places' windows. */
void
verify(const PointView& points, unsigned threads, NoiseScale& scale)
{
  constexpr double sure = 0.65, contradiction = 3;
  constexpr double of_extent = 0.02, of_sensors = 0.2; // metres: great noises
  constexpr double sparse = 0.1, of_lasers = 0.02;     // metres: edges look like noise
  if (scale.inverse_depth || (scale.spacing > 0 && scale.confidence >= sure))
    return;
  const bool may_be_edges = scale.spacing > sparse && scale.sigma > of_lasers;
  if (scale.spacing > 0 && !may_be_edges && scale.sigma < of_sensors &&
      scale.sigma < of_extent * cloudExtent(points).diagonal())
    return;
  const SurfaceNoise alone = measureSurfaceNoise(points, threads);
  const bool does_agree =
      scale.spacing > 0 && scale.sigma <= contradiction * alone.high;
  if (alone.is_determined ? does_agree : scale.sigma == 0)
    return;
  scale = {};
  scale.sigma = alone.sigma;
  if (alone.sigma > 0)
    scale.interval = {alone.low, alone.high};
  scale.spacing = scale.sparse_spacing = alone.spacing;
  scale.confidence =
      alone.is_determined
          ? static_cast<double>(alone.members) /
                static_cast<double>(std::max<std::size_t>(alone.places, 1))
          : 0;
  scale.is_determined = alone.is_determined;
  if (!alone.is_determined)
    scale.remarks.push_back(
        "the noise is not determined, and nothing is consolidated: " + alone.reason +
        "; a voxel size can be stated");
}

} // namespace

NoiseScale
measureNoiseScale(const PointView& points,
                  const SensorView& sensors,
                  unsigned threads,
                  std::size_t width)
{
  if (const std::optional<Indices> places = withoutZeros(points)) {
    std::vector<Eigen::Vector3f> kept;
    for (const index_t place : *places)
      kept.push_back(points[static_cast<std::size_t>(place)]);
    return measureNoiseScale(
        PointView(kept.data(), sizeof(Eigen::Vector3f), kept.size()), {}, threads);
  }
  return withThreads(threads, [&] {
    NoiseScale scale = measureInSpace(points, sensors, threads);
    if (scale.spacing > 0)
      applyDepthSteps(points, width, scale);
    verify(points, threads, scale);
    return scale;
  });
}

} // namespace pcl::acmap
