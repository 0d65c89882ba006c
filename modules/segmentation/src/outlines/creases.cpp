#include "outlines/creases.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::outlines {

namespace {

// Lengths in spacings of the points.
constexpr double dead_zone = 1;      // what noise brings over the line
constexpr double band = 3.5;         // beside the line, where a plane must be
constexpr double latest_begin = 2.5; // of the evidence beside the line
constexpr double snap_reach = 4;
constexpr double short_gap = 2, long_gap = 8;
constexpr double min_crease = 1, min_contact = 4;
constexpr double step_share = 0.5; // of a spacing, along a line
constexpr double min_sine = 0.17;

/** On which sides of a line a plane is. */
enum Sides : std::uint8_t { Neither = 0, Positive = 1, Negative = 2, Both = 3 };

int
signOf(Sides sides)
{
  return sides == Positive ? 1 : -1;
}

/** Is a plane on one side of a line at a place on the line?
 * \param[in] sine of the angle between the planes: at a flat one, noise reaches
 * further */
bool
isBeside(const PlaneRaster& raster,
         const Eigen::Vector2d& place,
         const Eigen::Vector2d& towards,
         double sine)
{
  constexpr double cells = 2; // a spacing
  constexpr double min_share = 0.35;
  const double scale = cells * std::min(1 / sine, 2.5);
  int all = 0, seen = 0;
  bool begins = false;
  for (double distance = 0.5; distance < band * scale; ++distance) {
    const bool is_seen = raster.seen.has(place + distance * towards);
    begins |= is_seen && distance <= latest_begin * scale;
    if (distance < dead_zone * scale)
      continue;
    ++all;
    seen += is_seen ? 1 : 0;
  }
  return begins && seen >= min_share * all;
}

Sides
sidesAt(const PlaneRaster& raster, const CreaseLine& line, double along, double sine)
{
  const Eigen::Vector2d place = line.at(along);
  const bool positive = isBeside(raster, place, line.normal, sine);
  const bool negative = isBeside(raster, place, -line.normal, sine);
  return static_cast<Sides>((positive ? Positive : Neither) |
                            (negative ? Negative : Neither));
}

CreaseLine
lineIn(const PlaneRaster& raster, const Crease& crease)
{
  CreaseLine line;
  line.origin = raster.placeOf(crease.point);
  line.cells_per_metre = 1 / raster.cell;
  line.direction = Eigen::Vector2d(crease.direction.dot(raster.axis_u),
                                   crease.direction.dot(raster.axis_v))
                       .normalized();
  line.normal = Eigen::Vector2d(-line.direction.y(), line.direction.x());
  return line;
}

/** The part of a line above a raster, metres; empty if from >= to. */
void
clip(const PlaneRaster& raster, const CreaseLine& line, double& from, double& to)
{
  const double size[2] = {static_cast<double>(raster.seen.width()),
                          static_cast<double>(raster.seen.height())};
  for (int axis = 0; axis < 2; ++axis) {
    const double speed = line.direction[axis] * line.cells_per_metre;
    const double begin = -line.origin[axis], end = size[axis] - line.origin[axis];
    if (std::abs(speed) < 1e-9 * line.cells_per_metre) {
      if (begin > 0 || end < 0)
        to = from;
      continue;
    }
    from = std::max(from, std::min(begin / speed, end / speed));
    to = std::min(to, std::max(begin / speed, end / speed));
  }
}

/** Steps along a line, and on which sides of it the two planes are. */
struct Walk {
  double begin = 0, step = 0;
  std::vector<std::array<Sides, 2>> sides;

  double
  at(std::size_t i) const
  {
    return begin + (static_cast<double>(i) + 0.5) * step;
  }
};

/** Steps [from, to) in which both planes are on the same sides. */
struct Run {
  std::size_t from, to;
  std::array<Sides, 2> sides;
};

bool
isCrease(const std::array<Sides, 2>& sides)
{
  return sides[0] != Neither && sides[1] != Neither &&
         !(sides[0] == Both && sides[1] == Both);
}

bool
isContact(const std::array<Sides, 2>& sides)
{
  return sides[0] == Both || sides[1] == Both;
}

/** Does no step between two runs contradict them? */
bool
isSilent(const Walk& walk, std::size_t from, std::size_t to, const Run& run)
{
  for (std::size_t i = from; i < to; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (walk.sides[i][k] != Neither && walk.sides[i][k] != run.sides[k])
        return false;
  return true;
}

/** Runs of the walk, with gaps closed and short ones dropped. */
std::vector<Run>
runsOf(const Walk& walk, double spacing)
{
  const auto steps = [&](double spacings) {
    return static_cast<std::size_t>(spacings * spacing / walk.step + 0.5);
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < walk.sides.size();) {
    std::size_t end = i + 1;
    while (end < walk.sides.size() && walk.sides[end] == walk.sides[i])
      ++end;
    if (isCrease(walk.sides[i])) {
      const Run run{i, end, walk.sides[i]};
      // a run of other sides that is shorter than a crease may be in between
      std::size_t same = runs.size();
      for (std::size_t k = runs.size(); k-- > 0 && same == runs.size();) {
        if (runs[k].sides == run.sides)
          same = k;
        else if (runs[k].to - runs[k].from >= steps(min_crease))
          break;
      }
      const bool is_continued =
          same < runs.size() && (i - runs[same].to <= steps(short_gap) ||
                                 (i - runs[same].to <= steps(long_gap) &&
                                  isSilent(walk, runs[same].to, i, run)));
      if (is_continued) {
        runs[same].to = end;
        runs.resize(same + 1);
      }
      else
        runs.push_back(run);
    }
    i = end;
  }
  runs.erase(std::remove_if(runs.begin(),
                            runs.end(),
                            [&](const Run& run) {
                              return run.to - run.from < steps(isContact(run.sides)
                                                                   ? min_contact
                                                                   : min_crease);
                            }),
             runs.end());
  return runs;
}

Walk
walkAlong(const Crease& crease, const std::vector<PlaneRaster>& rasters, double spacing)
{
  Walk walk;
  walk.step = step_share * spacing;
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (std::size_t k = 0; k < 2; ++k)
    clip(rasters[crease.planes[k]], crease.lines[k], from, to);
  if (!(from < to))
    return walk;
  walk.begin = from;
  const auto count = static_cast<std::size_t>((to - from) / walk.step);
  walk.sides.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      walk.sides[i][k] =
          sidesAt(rasters[crease.planes[k]], crease.lines[k], walk.at(i), crease.sine);
      if (walk.sides[i][k] == Neither)
        break; // the other one does not matter
    }
  return walk;
}

/** The crease of two planes, with its joint spans. */
Crease
creaseOf(std::size_t a,
         std::size_t b,
         double sine,
         double spacing,
         const std::vector<PlaneRaster>& rasters)
{
  Crease crease;
  crease.planes = {a, b};
  crease.sine = sine;
  const PlaneRaster &first = rasters[a], &second = rasters[b];
  crease.direction = first.normal.cross(second.normal).normalized();
  Eigen::Matrix3d rows;
  rows << first.normal.transpose(), second.normal.transpose(),
      crease.direction.transpose();
  // the point of the line that is nearest to a corner of the first raster
  crease.point = rows.partialPivLu().solve(Eigen::Vector3d(
      -first.offset, -second.offset, crease.direction.dot(first.origin)));
  crease.lines = {lineIn(first, crease), lineIn(second, crease)};
  const Walk walk = walkAlong(crease, rasters, spacing);
  for (const Run& run : runsOf(walk, spacing))
    for (std::size_t k = 0; k < 2; ++k)
      if (run.sides[k] != Both)
        crease.spans[k].push_back(
            {walk.begin + static_cast<double>(run.from) * walk.step,
             walk.begin + static_cast<double>(run.to) * walk.step,
             signOf(run.sides[k]),
             true,
             run.sides[1 - k] == Both});
  return crease;
}

/** Pairs of planes whose surfaces may touch. */
std::vector<std::array<std::size_t, 2>>
touchingPairs(double spacing, const std::vector<PlaneRaster>& rasters)
{
  const double margin = snap_reach / 2 * spacing;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const PlaneRaster& raster : rasters) {
    boxes.push_back(raster.box);
    boxes.back().min().array() -= margin;
    boxes.back().max().array() += margin;
  }
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a + 1; b < boxes.size(); ++b)
      if (rasters[a].seen.width() > 0 && rasters[b].seen.width() > 0 &&
          boxes[a].intersects(boxes[b]))
        pairs.push_back({a, b});
  return pairs;
}

/** Does a span, or its continuation by \a reach, contain a position? */
bool
reaches(const CreaseSpan& span, double along, double reach)
{
  return along > span.from - reach && along < span.to + reach;
}

/** \brief Ends of spans and their continuations, which depend on the other creases of the
 * planes. */
class SpanEnds {
public:
  SpanEnds(const KnownPlanes& known,
           const std::vector<PlaneRaster>& rasters,
           const Creases& all)
  : rasters_(rasters)
  , all_(all)
  , spacing_(known.spacing)
  {}

  /** Moves the ends of joint spans to corners nearby: there another crease of one of the
   * planes meets this one. */
  void
  snap(std::size_t number, Crease& crease) const
  {
    const std::vector<double> corners = cornersOf(number);
    for (std::size_t k = 0; k < 2; ++k) {
      for (CreaseSpan& span : crease.spans[k]) {
        snapEnd(corners, span.from);
        snapEnd(corners, span.to);
      }
      dropEmpty(crease.spans[k]);
    }
  }

  /** Continues the joint spans of each plane while it is on the same side alone. */
  void
  extend(std::size_t number, Crease& crease) const
  {
    const std::vector<double> corners = cornersOf(number);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<CreaseSpan> joint = crease.spans[k];
      for (std::size_t s = 0; s < joint.size(); ++s)
        for (const int way : {-1, 1}) {
          double end = way < 0 ? joint[s].from : joint[s].to;
          const double begin = end;
          const double limit =
              way < 0 ? (s > 0 ? joint[s - 1].to : -infinity)
                      : (s + 1 < joint.size() ? joint[s + 1].from : infinity);
          goOn(number, crease, k, joint[s].side, way, limit, end);
          if (std::abs(end - begin) < min_crease * spacing_)
            continue;
          snapEnd(corners, end);
          CreaseSpan span{std::min(begin, end), std::max(begin, end), joint[s].side};
          span.joint = false;
          if ((end - begin) * way > 0)
            crease.spans[k].push_back(span);
        }
      std::stable_sort(
          crease.spans[k].begin(),
          crease.spans[k].end(),
          [](const CreaseSpan& a, const CreaseSpan& b) { return a.from < b.from; });
    }
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /** Where joint creases of either plane with a third plane meet this one. */
  std::vector<double>
  cornersOf(std::size_t number) const
  {
    const Crease& crease = all_.creases[number];
    std::vector<double> corners;
    for (const std::size_t plane : crease.planes)
      for (const std::size_t other : all_.of_planes[plane]) {
        const Crease& second = all_.creases[other];
        const std::size_t third = second.planes[1 - second.sideOf(plane)];
        if (other == number || third == crease.planes[0] || third == crease.planes[1])
          continue;
        const double along = meetingOf(crease, rasters_[third]);
        if (!std::isfinite(along))
          continue;
        const Eigen::Vector3d corner = crease.point + along * crease.direction;
        const double there = (corner - second.point).dot(second.direction);
        for (const CreaseSpan& span : second.spans[second.sideOf(plane)])
          if (span.joint && reaches(span, there, snap_reach * spacing_)) {
            corners.push_back(along);
            break;
          }
      }
    return corners;
  }

  void
  snapEnd(const std::vector<double>& corners, double& end) const
  {
    double best = snap_reach * spacing_, found = end;
    for (const double corner : corners)
      if (std::abs(corner - end) < best) {
        best = std::abs(corner - end);
        found = corner;
      }
    end = found;
  }

  void
  dropEmpty(std::vector<CreaseSpan>& spans) const
  {
    spans.erase(std::remove_if(spans.begin(),
                               spans.end(),
                               [&](const CreaseSpan& span) {
                                 return span.to - span.from < 0.5 * spacing_;
                               }),
                spans.end());
  }

  void
  goOn(std::size_t number,
       const Crease& crease,
       std::size_t k,
       int side,
       int way,
       double limit,
       double& end) const
  {
    const std::size_t plane = crease.planes[k];
    const PlaneRaster& raster = rasters_[plane];
    double from = -infinity, to = infinity;
    clip(raster, crease.lines[k], from, to);
    const double step = way * step_share * spacing_;
    double last = end;
    for (double at = end + step / 2; at > from && at < to; at += step) {
      if ((limit - at) * way < 0 || std::abs(at - last) > short_gap * spacing_)
        break;
      const Sides sides = sidesAt(raster, crease.lines[k], at, crease.sine);
      if (sides == Both || (sides != Neither && signOf(sides) != side) ||
          isTaken(number, plane, crease.lines[k].at(at)))
        break;
      if (sides != Neither)
        last = at + step / 2;
    }
    end = last;
  }

  /** Has the plane another crease in nearly the same direction near a place? */
  bool
  isTaken(std::size_t number, std::size_t plane, const Eigen::Vector2d& place) const
  {
    constexpr double min_cosine = 0.94;
    const Crease& own = all_.creases[number];
    for (const std::size_t other : all_.of_planes[plane]) {
      const Crease& second = all_.creases[other];
      if (other == number || std::abs(second.direction.dot(own.direction)) < min_cosine)
        continue;
      const std::size_t k = second.sideOf(plane);
      const double distance =
          std::abs(second.lines[k].distance(place)) * rasters_[plane].cell;
      if (distance > band * spacing_)
        continue;
      for (const CreaseSpan& span : second.spans[k])
        if (span.joint && reaches(span, second.lines[k].along(place), 0))
          return true;
    }
    return false;
  }

  const std::vector<PlaneRaster>& rasters_;
  const Creases& all_;
  double spacing_;
};

} // namespace

double
meetingOf(const Crease& crease, const PlaneRaster& third)
{
  const double slope = third.normal.dot(crease.direction);
  if (std::abs(slope) < min_sine)
    return std::numeric_limits<double>::quiet_NaN();
  return -(third.normal.dot(crease.point) + third.offset) / slope;
}

Creases
creasesOf(const KnownPlanes& known, const std::vector<PlaneRaster>& rasters)
{
  const std::vector<std::array<std::size_t, 2>> pairs =
      touchingPairs(known.spacing, rasters);
  std::vector<Crease> candidates(pairs.size());
  oneapi::tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    const double sine = rasters[a].normal.cross(rasters[b].normal).norm();
    if (sine > min_sine)
      candidates[i] = creaseOf(a, b, sine, known.spacing, rasters);
  });
  Creases all;
  all.of_planes.resize(rasters.size());
  for (Crease& candidate : candidates)
    if (!candidate.spans[0].empty() || !candidate.spans[1].empty()) {
      for (const std::size_t plane : candidate.planes)
        all.of_planes[plane].push_back(all.creases.size());
      all.creases.push_back(std::move(candidate));
    }
  for (const auto change : {&SpanEnds::snap, &SpanEnds::extend}) {
    std::vector<Crease> changed = all.creases;
    const SpanEnds ends(known, rasters, all);
    for (std::size_t i = 0; i < changed.size(); ++i)
      (ends.*change)(i, changed[i]);
    all.creases = std::move(changed);
  }
  return all;
}

} // namespace pcl::acmap::outlines
