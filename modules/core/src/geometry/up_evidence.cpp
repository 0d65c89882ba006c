#include <pcl/core/impl/disjoint_sets.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/up_direction.h>
#include <pcl/core/impl/voxel_windows.h>
#include <pcl/core/up_evidence.h>

#include <Eigen/Geometry>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;

constexpr double degrees = 3.14159265358979323846 / 180;

/** A voxel of the surface. Metres. */
struct Cell {
  VoxelPlace place;
  Vector3d mean;
  Vector3d normal; ///< zero where the surface is not plane
  double area;

  bool
  isPlane() const
  {
    return !normal.isZero(0);
  }
};

struct Surface {
  double edge = 0;
  std::vector<Cell> cells;
};

/** A plane occupies more voxels, the more it is inclined to their faces. */
double
areaIn(const Vector3d& normal, double edge)
{
  constexpr double of_no_plane = 1.5;
  return edge * edge / (normal.isZero(0) ? of_no_plane : normal.lpNorm<1>());
}

Surface
surfaceOf(const PointView& points, double edge, unsigned threads)
{
  const VoxelMoments voxels = sumVoxels(points, {}, edge, threads);
  const VoxelWindows windows(voxels);
  Surface surface{edge, std::vector<Cell>(windows.size())};
  parallelForChunks(windows.size(), [&](std::size_t begin, std::size_t end) {
    VoxelWindows::Cursor cursor(windows, 1);
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<WindowPart>& parts = cursor.moveTo(i);
      const PlaneFit fit =
          fitPlane(sumParts(voxels, parts, [](const auto&) { return true; }));
      const Moments middle =
          sumParts(voxels, parts, [](const auto& part) { return part.isMiddle(); });
      const VoxelPlace place = placeOf(voxels.cells[windows.firstCell(i)].key);
      const bool is_plane = fit.isPlanar() && fit.variances[1] > 0.1 * fit.variances[2];
      const Vector3d normal = is_plane ? fit.normal : Vector3d(Vector3d::Zero());
      surface.cells[i] = {place,
                          voxels.lattice.center(place) + edge * middle.mean(),
                          normal,
                          areaIn(normal, edge)};
    }
  });
  return surface;
}

/** Normals in cells of about 4 degrees, regardless of their sign. */
std::vector<FacingArea>
facingsOf(const Surface& surface)
{
  std::map<std::array<int, 3>, Vector3d> sums;
  for (const Cell& cell : surface.cells) {
    if (!cell.isPlane())
      continue;
    int axis = 0;
    cell.normal.cwiseAbs().maxCoeff(&axis);
    const Vector3d normal = std::copysign(1.0, cell.normal[axis]) * cell.normal;
    constexpr double steps = 15;
    std::array<int, 3> key{};
    for (std::size_t k = 0; k < 3; ++k)
      key[k] = static_cast<int>(std::lround(steps * normal[static_cast<int>(k)]));
    sums.try_emplace(key, Vector3d::Zero()).first->second += cell.area * normal;
  }
  std::vector<FacingArea> facings;
  for (const auto& [key, sum] : sums)
    facings.push_back({sum.normalized(), sum.norm()});
  return facings;
}

/** The surfaces that are horizontal for an up direction, by their heights. */
class Levels {
public:
  Levels(const Surface& surface, const Vector3d& up)
  : surface_(surface)
  , up_(up)
  , tolerance_(std::max(0.15, 2 * surface.edge))
  {
    findComponents();
    findLevels();
  }

  bool
  isEmpty() const
  {
    return heights_.empty();
  }

  double
  low() const
  {
    return heights_.front();
  }

  double
  high() const
  {
    return heights_.back();
  }

  double
  tolerance() const
  {
    return tolerance_;
  }

  /** Is the surface of a voxel a part of the level at this height? */
  bool
  isOf(std::size_t cell, double height) const
  {
    const int component = components_[cell];
    return component >= 0 &&
           std::abs(means_[static_cast<std::size_t>(component)] - height) <= tolerance_;
  }

private:
  bool
  isHorizontal(const Cell& cell) const
  {
    return cell.isPlane() && std::abs(cell.normal.dot(up_)) > std::cos(20 * degrees);
  }

  /** Connects neighbouring horizontal voxels: a ramp or a slope is one component. */
  void
  findComponents()
  {
    const std::vector<Cell>& cells = surface_.cells;
    std::unordered_map<VoxelKey, int> index;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (isHorizontal(cells[i]))
        index.emplace(voxelKey(cells[i].place), static_cast<int>(i));
    DisjointSets<int> sets(static_cast<int>(cells.size()));
    for (const auto& [key, i] : index) {
      const VoxelPlace place = placeOf(key);
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dz = -1; dz <= 1; ++dz)
            if (const auto other =
                    index.find(voxelKey({place[0] + dx, place[1] + dy, place[2] + dz}));
                other != index.end())
              sets.unite(i, other->second);
    }
    components_.assign(cells.size(), -1);
    std::unordered_map<int, int> numbers;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!isHorizontal(cells[i]))
        continue;
      const auto [found, is_new] = numbers.emplace(sets.find(static_cast<int>(i)),
                                                   static_cast<int>(areas_.size()));
      if (is_new) {
        areas_.push_back(0);
        means_.push_back(0);
      }
      const auto component = static_cast<std::size_t>(found->second);
      components_[i] = found->second;
      areas_[component] += cells[i].area;
      means_[component] += cells[i].area * cells[i].mean.dot(up_);
    }
    for (std::size_t c = 0; c < areas_.size(); ++c)
      means_[c] /= areas_[c];
  }

  /** Heights of wide levels, ascending. */
  void
  findLevels()
  {
    constexpr double wide = 0.3; // of the area of the widest one
    std::vector<std::size_t> order(areas_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(means_[a], a) < std::pair(means_[b], b);
    });
    std::vector<std::pair<double, double>>
        levels; // height and area about each component
    double area = 0, sum = 0, widest = 0;
    std::size_t first = 0, last = 0; // of the components about it
    for (const std::size_t c : order) {
      for (; last < order.size() && means_[order[last]] <= means_[c] + tolerance_ / 2;
           ++last) {
        area += areas_[order[last]];
        sum += areas_[order[last]] * means_[order[last]];
      }
      for (; means_[order[first]] < means_[c] - tolerance_ / 2; ++first) {
        area -= areas_[order[first]];
        sum -= areas_[order[first]] * means_[order[first]];
      }
      levels.emplace_back(sum / area, area);
      widest = std::max(widest, area);
    }
    for (const auto& [height, about] : levels)
      if (about >= wide * widest)
        heights_.push_back(height);
    std::sort(heights_.begin(), heights_.end());
  }

  const Surface& surface_;
  const Vector3d up_;
  const double tolerance_;
  std::vector<int> components_; ///< of each voxel, -1: not horizontal
  std::vector<double> areas_, means_;
  std::vector<double> heights_;
};

double
explainedBy(const std::vector<FacingArea>& facings, const Vector3d& up)
{
  double area = 0, explained = 0;
  for (const FacingArea& facing : facings) {
    const double cosine = std::abs(facing.normal.dot(up));
    area += facing.area;
    if (cosine > std::cos(10 * degrees) || cosine < std::sin(10 * degrees))
      explained += facing.area;
  }
  return area > 0 ? explained / area : 0;
}

constexpr double height_of_furniture = 1.3; // metres

/** Share of the plan in which the lowest level is seen, or something stands on it. */
double
coverageOf(const Surface& surface, const Levels& levels, const Vector3d& up)
{
  const double level = levels.low();
  const Vector3d u = up.unitOrthogonal(), v = up.cross(u);
  const double side = std::max(0.1, 2 * surface.edge);
  std::map<std::pair<long, long>, bool> plan;
  for (std::size_t i = 0; i < surface.cells.size(); ++i) {
    const Vector3d& mean = surface.cells[i].mean;
    bool& is_covered =
        plan[{std::lround(mean.dot(u) / side), std::lround(mean.dot(v) / side)}];
    const double height = mean.dot(up) - level;
    is_covered |= levels.isOf(i, level) ||
                  (height > levels.tolerance() && height < height_of_furniture);
  }
  std::size_t covered = 0;
  for (const auto& [place, is_covered] : plan)
    covered += is_covered;
  return static_cast<double>(covered) / static_cast<double>(plan.size());
}

/** Between the lowest and the highest 2 % of the surface. */
double
reachAlong(const Surface& surface, const Vector3d& up)
{
  std::vector<double> heights;
  for (const Cell& cell : surface.cells)
    heights.push_back(cell.mean.dot(up));
  const double low = quantileOf(heights, 0.02);
  return quantileOf(heights, 0.98) - low;
}

double
leadOf(double one, double other)
{
  return one + other > 0 ? (one - other) / (one + other) : 0;
}

/** An axis of the frame, turned to the direction of the building next to it. */
struct Candidate {
  Vector3d up = Vector3d::Zero(); ///< towards which most of the surface lies
  double off = 0;                 ///< radians, from the axis of the frame
  double explained = 0;           ///< share of the surface that it explains
  double coverage = 0; ///< of the plan by the lowest level, of two by the better one
  /** Difference of the surface above the only level and that below, over their sum; 0 where
   * there are a floor and a ceiling, which look alike. */
  double lead = 0;
  double height = 0; ///< from floor to ceiling, metres; 0 without one
  double reach = 0;  ///< of most of the surface along it, metres

  /** Logarithm of the odds that it is vertical: rooms are lower than they are wide. */
  double
  evidence() const
  {
    constexpr double of_explained = 4, of_coverage = 10, of_height = 1.5,
                     of_reach = 0.5;
    constexpr double usual_height = 2.8; // metres
    const double excess =
        height > 0 ? std::abs(std::log(height / usual_height))
                   : of_reach * std::log(std::max(1.0, reach / usual_height));
    if (coverage == 0)
      return -std::numeric_limits<double>::infinity();
    return of_explained * explained + of_coverage * coverage - of_height * excess;
  }
};

Candidate
candidateAlong(const Surface& surface,
               const std::vector<FacingArea>& facings,
               const Vector3d& axis)
{
  Candidate candidate;
  const UpEstimate found = estimateUp(facings, axis, 2 * up_tolerance);
  candidate.up = found.share >= min_up_share
                     ? refineUp(facings, found.up, 2 * up_tolerance)
                     : axis;
  candidate.off = std::acos(std::min(1.0, candidate.up.dot(axis)));
  const Levels levels(surface, candidate.up);
  if (levels.isEmpty())
    return candidate;
  candidate.explained = explainedBy(facings, candidate.up);
  candidate.reach = reachAlong(surface, candidate.up);
  constexpr double lowest_room = 1.5; // metres
  if (levels.high() - levels.low() > lowest_room)
    candidate.height = levels.high() - levels.low();
  else {
    double above = 0, below = 0;
    for (const Cell& cell : surface.cells) {
      const double height = cell.mean.dot(candidate.up);
      above += height > levels.high() + levels.tolerance() ? cell.area : 0;
      below += height < levels.low() - levels.tolerance() ? cell.area : 0;
    }
    candidate.lead = leadOf(above, below);
    if (candidate.lead < 0) {
      candidate.up = -candidate.up;
      candidate.lead = -candidate.lead;
    }
  }
  const auto coverage = [&](const Vector3d& up) {
    return coverageOf(surface, Levels(surface, up), up);
  };
  candidate.coverage = coverage(candidate.up);
  if (candidate.height > 0)
    candidate.coverage = std::max(candidate.coverage, coverage(-candidate.up));
  return candidate;
}

/** The axis about which the building is turned in its frame, while both agree along it: who
 * levels a frame does not turn it to the walls. -1 if there is none. */
int
levelledAxis(const std::array<Candidate, 3>& candidates)
{
  constexpr double level = 1.2 * degrees, turned = 2 * degrees, times = 3.5;
  constexpr double mostly = 0.5, least_slope = 24 * degrees; // of stairs and roofs
  for (int axis = 0; axis < 3; ++axis) {
    const auto other = [&](int step) -> const Candidate& {
      return candidates[static_cast<std::size_t>((axis + step) % 3)];
    };
    const double turn = std::min(other(1).off, other(2).off);
    // a slope beside a wall is turned, too, about the normal of the wall
    const bool may_be_slope =
        turn > least_slope && std::min(other(1).explained, other(2).explained) < mostly;
    if (other(0).off < level && turn > std::max(turned, times * other(0).off) &&
        !may_be_slope)
      return axis;
  }
  return -1;
}

/** Probability of each candidate. */
std::array<double, 3>
probabilitiesOf(const std::array<Candidate, 3>& candidates)
{
  double best = -std::numeric_limits<double>::infinity(), sum = 0;
  for (const Candidate& candidate : candidates)
    best = std::max(best, candidate.evidence());
  std::array<double, 3> probabilities{};
  if (!std::isfinite(best))
    return probabilities;
  for (std::size_t k = 0; k < 3; ++k)
    sum += probabilities[k] = std::exp(candidates[k].evidence() - best);
  for (double& probability : probabilities)
    probability /= sum;
  return probabilities;
}

/** Where the points are, seen from the origin of their frame. */
struct Look {
  int axis = -1;         ///< about which nearly all of them are; -1: all around
  bool is_ahead = false; ///< along it, not against it
  double range = 0;      ///< median, metres
};

Look
lookAt(const PointView& points)
{
  constexpr double nearly_all = 0.99, cosine = 0.42; // of 65 degrees
  std::vector<double> ranges;
  std::array<std::size_t, 3> ahead{}, behind{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite() || point.isZero(0))
      continue;
    const auto range = static_cast<double>(point.norm());
    ranges.push_back(range);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<double>(point[static_cast<int>(axis)]);
      ahead[axis] += along > cosine * range;
      behind[axis] += along < -cosine * range;
    }
  }
  Look look;
  const auto are = [&](std::size_t count) {
    return static_cast<double>(count) >=
           nearly_all * static_cast<double>(ranges.size());
  };
  for (const int axis : {0, 1, 2}) // a camera's, the last one, first of all
    if (const auto k = static_cast<std::size_t>(axis); are(ahead[k]) || are(behind[k]))
      look = {axis, are(ahead[k])};
  look.range = ranges.empty() ? 0 : quantileOf(ranges, 0.5);
  return look;
}

/** Is it the view of a camera? From the origin of a site's frame, all of a building may be to
 * one side, too, but beyond the reach of depth cameras, or behind itself. */
bool
isOfCamera(const Look& look, const SensorEvidence& sensor)
{
  constexpr double reach = 8; // metres, median
  return look.axis == 2 &&
         (sensor.isKnown() ||
          (sensor.outcome == SensorOutcome::Undetermined && look.range < reach));
}

std::vector<Eigen::Vector3f>
everyNth(const PointView& points, std::size_t step)
{
  std::vector<Eigen::Vector3f> some;
  some.reserve(points.size() / step + 1);
  for (std::size_t i = 0; i < points.size(); i += step)
    some.push_back(points[i]);
  return some;
}

/** The direction of the building that is along an axis of the frame within half a degrees is
 * that axis. */
Vector3d
snapped(const Vector3d& direction)
{
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const Vector3d along = std::copysign(1.0, direction[axis]) * Vector3d::Unit(axis);
  return isLevel(direction, along) ? along : direction;
}

/** What is known of the frame of the points. */
struct Frame {
  bool is_usual_known = false; ///< Is it known which direction is up in such files?
  bool is_sensors = false;     ///< Is it that of the one sensor?
  bool is_view = false;        ///< and is that a camera?
  int faced_axis = -1;         ///< along which the sensor looks, -1: all around
};

/** May the building be turned in its frame because who made the frame has levelled it? That of
 * a sensor is turned as the sensor is held: level are cameras that pan, about y or z, and
 * scanners, about z. */
bool
mayBeLevelled(int axis, const Frame& frame)
{
  return frame.is_view ? axis > 0 : !frame.is_sensors || axis == 2;
}

/** A level without a ceiling, above which there is little. */
bool
mayBeWall(const Candidate& candidate)
{
  constexpr double mostly = 0.5;
  return candidate.height == 0 && candidate.lead < mostly;
}

/** A level without a ceiling that is no larger than walls are: stairs and shelves stand on a wall
 * as furniture stands on a floor. */
bool
isAsLargeAsWalls(const std::array<Candidate, 3>& candidates, std::size_t axis)
{
  constexpr double largest = 25; // metres
  return candidates[axis].height == 0 &&
         std::min(candidates[(axis + 1) % 3].reach, candidates[(axis + 2) % 3].reach) <
             largest;
}

/** Which axis is vertical, and which of its senses is up.
 * \param[in,out] evidence with what is assumed if nothing shows it */
void
conclude(const std::array<Candidate, 3>& candidates,
         const Frame& frame,
         UpEvidence& evidence)
{
  constexpr double sure = 0.9, unlikely = 0.1, sure_of_frame = 0.97;
  constexpr double one_sided = 0.97, mostly = 0.5, partly_seen = 0.1;
  const std::array<double, 3> probabilities = probabilitiesOf(candidates);
  const auto best =
      static_cast<int>(std::max_element(probabilities.begin(), probabilities.end()) -
                       probabilities.begin());
  const int levelled = levelledAxis(candidates);
  const bool is_levelled =
      levelled >= 0 && mayBeLevelled(levelled, frame) &&
      probabilities[static_cast<std::size_t>(levelled)] >= unlikely;
  const auto axis = static_cast<std::size_t>(is_levelled ? levelled : best);
  const double needed = levelled < 0 ? sure : sure_of_frame;
  // a wall that a sensor faces covers its picture as a floor covers a plan
  const bool is_faced = static_cast<int>(axis) == frame.faced_axis;
  const Candidate& vertical = candidates[axis];
  const bool is_unusual = !is_levelled && frame.is_usual_known &&
                          std::abs(vertical.up.dot(evidence.value)) < mostly;
  const bool is_seen = vertical.lead >= one_sided && vertical.coverage >= partly_seen;
  if (is_faced ||
      (!is_levelled && (mayBeWall(vertical) || isAsLargeAsWalls(candidates, axis))) ||
      (is_unusual && !is_seen) || (!is_levelled && !(probabilities[axis] >= needed))) {
    evidence.evidence = "floors, ceilings and walls do not tell which axis is vertical";
    if (!frame.is_usual_known && evidence.value == Vector3d::UnitZ() &&
        candidates[2].coverage == 0 && candidates[1].coverage > 0 &&
        !mayBeWall(candidates[1]))
      evidence.value = Vector3d::UnitY();
    return;
  }
  const Vector3d direction = snapped(vertical.up);
  evidence.evidence = is_levelled ? "levelled frame" : "floor and walls";
  if (!is_seen) {
    evidence.value =
        direction.dot(evidence.value) < 0 ? Vector3d(-direction) : direction;
    evidence.evidence += ", but floor and ceiling look alike";
    return;
  }
  evidence.outcome = UpOutcome::Found;
  evidence.value = direction;
  evidence.confidence =
      is_levelled ? std::max(sure_of_frame, probabilities[axis]) : probabilities[axis];
  evidence.evidence += ", everything above the floor";
}

} // namespace

UpEvidence
findUp(const PointView& points,
       double spacing,
       double sigma,
       const std::optional<Eigen::Vector3f>& usual,
       unsigned threads,
       const SensorEvidence& sensor)
{
  UpEvidence evidence;
  constexpr std::size_t enough = 1 << 19;
  const std::size_t step = points.size() / enough + 1; // of the points that are asked
  const std::vector<Eigen::Vector3f> asked = everyNth(points, step);
  const PointView sample(asked.data(), sizeof(Eigen::Vector3f), asked.size());
  const bool is_look_asked = !usual || sensor.isKnown();
  const Look look = is_look_asked ? lookAt(sample) : Look();
  Frame frame;
  frame.is_usual_known = usual.has_value();
  frame.is_sensors = sensor.isKnown();
  frame.is_view = !usual && isOfCamera(look, sensor);
  frame.faced_axis = frame.is_view || frame.is_sensors ? look.axis : -1;
  if (usual)
    evidence.value = usual->cast<double>().normalized();
  else if (frame.is_view)
    evidence.value = look.is_ahead ? Vector3d(-Vector3d::UnitY()) : Vector3d::UnitY();
  const double extent = cloudExtent(sample).diagonal();
  const double edge = std::max(
      {3 * spacing * std::sqrt(static_cast<double>(step)), 4 * sigma, extent / 300});
  if (!(edge > 0) || !std::isfinite(edge)) {
    evidence.evidence = "the points have no extent";
    return evidence;
  }
  std::array<Candidate, 3> candidates;
  withThreads(threads, [&] {
    const Surface surface = surfaceOf(sample, edge, threads);
    const std::vector<FacingArea> facings = facingsOf(surface);
    oneapi::tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t k) {
      candidates[k] = candidateAlong(
          surface, facings, Vector3d::Unit(static_cast<Eigen::Index>(k)));
    });
  });
  conclude(candidates, frame, evidence);
  return evidence;
}

} // namespace pcl::acmap
