#include <pcl/texture/floor_plan.h>

#include "plan/opening_faces.h"
#include "plan/plan_contents.h"
#include "plan/room_outline.h"
#include "plan/unseen_borders.h"

#include <pcl/core/impl/planar_geometry.h>
#include <pcl/core/map_up.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace pcl {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

using acmap::level_cosine;
using acmap::upright_cosine;

using acmap::areFaces;
using acmap::frontOf;
using acmap::isInside;
using acmap::thickest_wall;

// metres; below a sill of this height, an opening is a door
constexpr double widest_door = 2.4, widest_opening = 4, widest_window = 6,
                 lowest_sill = 0.07;

/** \brief Part of a wall along a direction, metres, with what is beyond its ends. */
struct Interval {
  double begin, end;
  EdgeKind begin_kind = EdgeKind::Open, end_kind = EdgeKind::Open;
};

/** \brief A polygon that is not upright, seen from above. */
struct Cover {
  std::size_t plane; ///< index in the map
  bool is_ceiling;
  std::vector<std::vector<Vector2d>> loops;
};

bool
isFinite(const PlanePatch& plane)
{
  const auto areFinite = [](const std::vector<Eigen::Vector3f>& loop) {
    return std::all_of(
        loop.begin(), loop.end(), [](const auto& place) { return place.allFinite(); });
  };
  return plane.coefficients.allFinite() &&
         std::all_of(plane.polygons.begin(),
                     plane.polygons.end(),
                     [&](const PlanePolygon& polygon) {
                       return areFinite(polygon.outer) &&
                              std::all_of(polygon.holes.begin(),
                                          polygon.holes.end(),
                                          areFinite);
                     });
}

std::vector<std::vector<Vector3d>>
loopsOf(const PlanePolygon& polygon)
{
  std::vector<std::vector<Vector3d>> loops(1 + polygon.holes.size());
  const auto take = [](const std::vector<Eigen::Vector3f>& from,
                       std::vector<Vector3d>& to) {
    for (const Eigen::Vector3f& place : from)
      to.push_back(place.cast<double>());
  };
  take(polygon.outer, loops[0]);
  for (std::size_t hole = 0; hole < polygon.holes.size(); ++hole)
    take(polygon.holes[hole], loops[hole + 1]);
  return loops;
}

/** \brief For each loop of a polygon, what is beyond the edges from its points to the next. */
std::vector<std::vector<EdgeKind>>
edgeKindsOf(const PlanePolygon& polygon)
{
  std::vector<std::vector<EdgeKind>> kinds;
  std::size_t first = 0;
  const auto take = [&](std::size_t count) {
    kinds.emplace_back(count, EdgeKind::Open);
    for (std::size_t k = 0; k < count && first + k < polygon.edges.size(); ++k)
      kinds.back()[k] = polygon.edges[first + k].kind;
    first += count;
  };
  take(polygon.outer.size());
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
    take(hole.size());
  return kinds;
}

/** \brief An upright plane. */
class Wall {
public:
  Wall(const PlanePatch& patch, std::size_t plane, const Vector3d& up)
  : plane_(plane)
  , coefficients_(patch.coefficients)
  , up_(up)
  , normal_((patch.coefficients.head<3>() - patch.coefficients.head<3>().dot(up) * up)
                .normalized())
  , along_(normal_.cross(up))
  {
    for (const PlanePolygon& polygon : patch.polygons) {
      polygons_.push_back(loopsOf(polygon));
      kinds_.push_back(edgeKindsOf(polygon));
    }
    origin_ = patch.polygons.front().outer.front().cast<double>();
    for (const auto& loops : polygons_)
      for (const Vector3d& place : loops.front())
        minimum_ = std::min(minimum_, place.dot(up));
  }

  std::size_t
  plane() const
  {
    return plane_;
  }

  double
  lowest() const
  {
    return minimum_;
  }

  const Vector3d&
  normal() const
  {
    return normal_;
  }

  /** \brief Where a level plane at this height cuts the polygons, ascending. */
  std::vector<Interval>
  section(double height) const
  {
    return cut(up_, height - origin_.dot(up_), along_);
  }

  /** \brief The heights, relative to another one, where the wall is at a place. */
  std::vector<Interval>
  heights(double along, double above) const
  {
    std::vector<Interval> intervals = cut(along_, along, up_);
    for (Interval& one : intervals) {
      one.begin += origin_.dot(up_) - above;
      one.end += origin_.dot(up_) - above;
    }
    return intervals;
  }

  /** \brief A point of the wall at a height above the origin of the map: where its plane,
   * which may lean a little, is there. */
  Vector3d
  point(double along, double height) const
  {
    const Vector3d upright =
        origin_ + along * along_ + (height - origin_.dot(up_)) * up_;
    return upright - coefficients_.dot(upright.homogeneous()) /
                         coefficients_.head<3>().dot(normal_) * normal_;
  }

private:
  /** \brief Where the polygons are cut by a plane with this normal and distance from the
   * origin of the wall: ascending, along a direction. */
  std::vector<Interval>
  cut(const Vector3d& normal, double distance, const Vector3d& direction) const
  {
    std::vector<Interval> intervals;
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      std::vector<std::pair<double, EdgeKind>> crossings;
      for (std::size_t l = 0; l < polygons_[p].size(); ++l) {
        const std::vector<Vector3d>& loop = polygons_[p][l];
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const Vector3d a = loop[k] - origin_;
          const Vector3d b = loop[(k + 1) % loop.size()] - origin_;
          const double before = a.dot(normal) - distance,
                       behind = b.dot(normal) - distance;
          if ((before > 0) != (behind > 0))
            crossings.emplace_back(
                (a + before / (before - behind) * (b - a)).dot(direction),
                kinds_[p][l][k]);
        }
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        intervals.push_back({crossings[k].first,
                             crossings[k + 1].first,
                             crossings[k].second,
                             crossings[k + 1].second});
    }
    return joined(std::move(intervals));
  }

public:
  /** \brief Joins intervals that touch or overlap, as polygons may; ascending. */
  static std::vector<Interval>
  joined(std::vector<Interval> intervals)
  {
    std::sort(intervals.begin(), intervals.end(), [](const auto& a, const auto& b) {
      return a.begin < b.begin;
    });
    std::vector<Interval> result;
    for (const Interval& one : intervals)
      if (result.empty() || one.begin > result.back().end)
        result.push_back(one);
      else if (one.end > result.back().end) {
        result.back().end = one.end;
        result.back().end_kind = one.end_kind;
      }
    return result;
  }

private:
  std::size_t plane_;
  Eigen::Vector4d coefficients_;
  Vector3d up_, normal_, along_, origin_;
  std::vector<std::vector<std::vector<Vector3d>>> polygons_;
  std::vector<std::vector<std::vector<EdgeKind>>> kinds_; ///< of their edges
  double minimum_ = std::numeric_limits<double>::infinity();
};

/** \brief Do two segments have a point in common? */
bool
meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
  const auto side = [](const Vector2d& p, const Vector2d& q, const Vector2d& r) {
    return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
  };
  return (side(a, b, c) > 0) != (side(a, b, d) > 0) &&
         (side(c, d, a) > 0) != (side(c, d, b) > 0);
}

/** \brief A polygon of a level plane, seen from above. */
struct Level {
  double height; ///< above the floor
  Eigen::AlignedBox2d box;
  std::vector<std::vector<Vector2d>> loops;
};

/** \brief Makes a plan. */
class PlanMaker {
public:
  explicit PlanMaker(const CompactMap& map)
  {
    const bool is_shifted = !map.shift.isZero(0);
    plan_.shift = map.shift;
    plan_.up = is_shifted ? upAxis(map) : upDirection(map);
    const Vector3d& up = plan_.up;
    const Vector3d right =
        std::abs(up.x()) < 0.8 ? Vector3d::UnitX() : Vector3d::UnitY();
    plan_.x_axis = (right - right.dot(up) * up).normalized();
    plan_.y_axis = up.cross(plan_.x_axis);
    std::vector<const PlanePatch*> floors, ceilings; // level
    std::vector<std::size_t> facing_down;
    for (std::size_t p = 0; p < map.planes.size(); ++p) {
      const PlanePatch& plane = map.planes[p];
      if (plane.polygons.empty() || plane.polygons.front().outer.empty() ||
          !isFinite(plane))
        continue;
      const double cosine = plane.coefficients.head<3>().dot(up);
      if (std::abs(cosine) < upright_cosine)
        walls_.emplace_back(plane, p, up);
      else if (cosine > level_cosine)
        floors.push_back(&plane);
      else if (cosine < -level_cosine)
        ceilings.push_back(&plane);
      if (cosine <= -upright_cosine)
        facing_down.push_back(p);
    }
    if (!is_shifted)
      alignWithWalls(map);
    chooseHeights(floors, ceilings);
    constexpr double step = 0.3; // metres
    for (const PlanePatch* plane : floors)
      if (std::abs(heightOf(*plane) - plan_.floor) <= step)
        cover(*plane, static_cast<std::size_t>(plane - map.planes.data()), false);
    for (const Cover& floor : covers_)
      plan_.floors.push_back(floor.loops);
    for (const PlanePatch* plane : floors)
      if (const double height = heightOf(*plane) - plan_.floor;
          height > lowest_sill && height < plan_.cut - plan_.floor)
        for (const PlanePolygon& polygon : plane->polygons)
          addLevel(height, flatLoopsOf(polygon));
    for (const std::size_t p : facing_down)
      if (reachesAboveCut(map.planes[p]))
        cover(map.planes[p], p, true);
  }

  /** \brief Floors and ceilings. */
  const std::vector<Cover>&
  covers() const
  {
    return covers_;
  }

  FloorPlan
  make()
  {
    for (const Wall& wall : walls_)
      for (const Interval& piece : wall.section(plan_.cut))
        plan_.walls.push_back(
            {flat(wall, piece.begin), flat(wall, piece.end), wall.plane()});
    for (const Wall& wall : walls_)
      addOpenings(wall);
    for (std::size_t k = 0; k < plan_.openings.size(); ++k)
      for (std::size_t l = k + 1; l < plan_.openings.size(); ++l)
        if (areFaces(plan_.openings[k], plan_.openings[l]))
          adjust(plan_.openings[k], plan_.openings[l]);
    acmap::addHiddenCorners(plan_);
    return plan_;
  }

private:
  Vector2d
  flat(const Wall& wall, double along) const
  {
    return plan_.placeOf(wall.point(along, plan_.cut));
  }

  /** \brief Turns the axes by at most 45 degrees, so that walls are along them, if most
   * walls are at right angles. */
  void
  alignWithWalls(const CompactMap& map)
  {
    std::complex<double> sum = 0; // of directions modulo 90 degrees
    double area = 0;
    for (const Wall& wall : walls_) {
      const Vector2d normal = plan_.placeOf(wall.normal());
      sum += map.planes[wall.plane()].area *
             std::polar(1.0, 4 * std::atan2(normal.y(), normal.x()));
      area += map.planes[wall.plane()].area;
    }
    if (!(std::abs(sum) > 0.5 * area))
      return;
    const Eigen::AngleAxisd turn(std::arg(sum) / 4, plan_.up);
    plan_.x_axis = turn * plan_.x_axis;
    plan_.y_axis = turn * plan_.y_axis;
  }

  /** \brief Height of a level plane, at its first corner. */
  double
  heightOf(const PlanePatch& plane) const
  {
    return plane.polygons.front().outer.front().cast<double>().dot(plan_.up);
  }

  static const PlanePatch*
  largest(const std::vector<const PlanePatch*>& planes)
  {
    const auto maximum = std::max_element(
        planes.begin(), planes.end(), [](const PlanePatch* a, const PlanePatch* b) {
          return a->area < b->area;
        });
    return maximum == planes.end() ? nullptr : *maximum;
  }

  /** \brief The lowest plane with at least half of the largest area: a worktop may be
   * larger than what was seen of the floor. */
  const PlanePatch*
  lowestOfLarge(const std::vector<const PlanePatch*>& planes) const
  {
    const PlanePatch* lowest = largest(planes);
    const double min_area = lowest ? lowest->area / 2 : 0;
    for (const PlanePatch* const plane : planes)
      if (plane->area >= min_area && heightOf(*plane) < heightOf(*lowest))
        lowest = plane;
    return lowest;
  }

  void
  chooseHeights(const std::vector<const PlanePatch*>& floors,
                const std::vector<const PlanePatch*>& ceilings)
  {
    constexpr double above_tables = 1.5; // metres
    constexpr double share = 0.6;
    if (const PlanePatch* const floor = lowestOfLarge(floors))
      plan_.floor = heightOf(*floor);
    else if (!walls_.empty())
      plan_.floor = std::min_element(walls_.begin(),
                                     walls_.end(),
                                     [](const Wall& a, const Wall& b) {
                                       return a.lowest() < b.lowest();
                                     })
                        ->lowest();
    plan_.cut = plan_.floor + above_tables;
    const PlanePatch* const ceiling = largest(ceilings);
    if (!ceiling || !(heightOf(*ceiling) > plan_.floor))
      return;
    constexpr double lower = 0.3; // metres, of which ceilings of one storey differ
    ceiling_ = heightOf(*ceiling) - plan_.floor + lower;
    plan_.cut =
        std::min(plan_.cut, plan_.floor + share * (heightOf(*ceiling) - plan_.floor));
  }

  bool
  reachesAboveCut(const PlanePatch& plane) const
  {
    return std::any_of(
        plane.polygons.begin(), plane.polygons.end(), [&](const PlanePolygon& polygon) {
          return std::any_of(
              polygon.outer.begin(), polygon.outer.end(), [&](const auto& place) {
                return place.template cast<double>().dot(plan_.up) > plan_.cut;
              });
        });
  }

  void
  cover(const PlanePatch& plane, std::size_t number, bool is_ceiling)
  {
    for (const PlanePolygon& polygon : plane.polygons)
      covers_.push_back({number, is_ceiling, flatLoopsOf(polygon)});
  }

  void
  addLevel(double height, std::vector<std::vector<Vector2d>> loops)
  {
    Eigen::AlignedBox2d box;
    for (const Vector2d& place : loops.front())
      box.extend(place);
    levels_.push_back({height, box, std::move(loops)});
  }

  std::vector<std::vector<Vector2d>>
  flatLoopsOf(const PlanePolygon& polygon) const
  {
    std::vector<std::vector<Vector2d>> loops;
    for (const std::vector<Vector3d>& loop : loopsOf(polygon)) {
      loops.emplace_back();
      for (const Vector3d& place : loop)
        loops.back().push_back(plan_.placeOf(place));
    }
    return loops;
  }

  /** \brief Adds the openings between the pieces of a wall, and those at its ends. */
  void
  addOpenings(const Wall& wall)
  {
    if (wall.section(plan_.cut).empty())
      return;
    const std::vector<Interval> pieces = piecesInLine(wall);
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k)
      addGap(wall, pieces[k], pieces[k + 1]);
    constexpr int most_piers = 3;
    Interval last = pieces.front(), first = pieces.back();
    for (int pier = 0; pier < most_piers; ++pier) {
      const auto corner = cornerBeyond(wall, last.begin, -1);
      if (!corner)
        break;
      addGap(wall, {*corner, *corner}, last);
      const auto next = pierBeyond(wall, *corner, -1);
      if (!next)
        break;
      last = {*next, *next};
    }
    for (int pier = 0; pier < most_piers; ++pier) {
      const auto corner = cornerBeyond(wall, first.end, 1);
      if (!corner)
        break;
      addGap(wall, first, {*corner, *corner});
      const auto next = pierBeyond(wall, *corner, 1);
      if (!next)
        break;
      first = {*next, *next};
    }
  }

  /** \brief The pieces of a wall, and those of others that lie in the same plane. */
  std::vector<Interval>
  piecesInLine(const Wall& wall) const
  {
    constexpr double off = 0.025, min_cosine = 0.95; // metres
    const Vector2d from = flat(wall, 0), along = flat(wall, 1) - from;
    const Vector2d front = plan_.placeOf(wall.normal());
    std::vector<Interval> pieces = wall.section(plan_.cut);
    const Interval near{pieces.front().begin - widest_window,
                        pieces.back().end + widest_window};
    for (const PlanWall& other : plan_.walls) {
      const double a = along.dot(other.from - from), b = along.dot(other.to - from);
      if (other.plane != wall.plane() && frontOf(other).dot(front) > min_cosine &&
          std::abs(front.dot(other.from - from)) < off &&
          std::abs(front.dot(other.to - from)) < off && std::min(a, b) > near.begin &&
          std::max(a, b) < near.end && !isBelowLintel(wall, (a + b) / 2))
        pieces.push_back({std::min(a, b), std::max(a, b)});
    }
    return Wall::joined(std::move(pieces));
  }

  /** \brief Does a wall leave room for the leaf of a door at a place? */
  bool
  isBelowLintel(const Wall& wall, double along) const
  {
    constexpr double highest_leaf = 2.6; // metres
    return frameAt(wall, along).top <= highest_leaf;
  }

  /** \brief Adds the openings of a gap between two pieces of a wall: one between its reveals,
   * where these were seen, or one on each side of another wall that ends in it. */
  void
  addGap(const Wall& wall, const Interval& before, const Interval& behind)
  {
    constexpr double slack = 0.05; // metres, by which outlines may end beside a reveal
    const double begin = before.end, end = behind.begin;
    const auto ahead = cornerBeyond(wall, begin, 1), back = cornerBeyond(wall, end, -1);
    constexpr double thickest = thickest_wall + 0.1; // metres, as outlines have it
    const bool are_pieces = before.begin < before.end && behind.begin < behind.end;
    if (are_pieces && end - begin <= thickest &&
        (isAbutted(wall, begin) || isAbutted(wall, end)))
      return; // another wall ends there
    const bool has_end = ahead && *ahead > begin + slack && *ahead <= end + slack,
               has_begin = back && *back < end - slack && *back >= begin - slack;
    const double first = has_begin ? *back : begin, last = has_end ? *ahead : end;
    // something may have hidden the wall where it was not seen to end
    const bool is_seen = has_begin || has_end ||
                         (before.end_kind != EdgeKind::Frontier &&
                          behind.begin_kind != EdgeKind::Frontier);
    bool is_open = false;
    if (last - first > slack)
      is_open = addOpening(wall, first, last, is_seen);
    else {
      is_open = addOpening(wall, begin, last, true);
      is_open = addOpening(wall, first, end, true) || is_open;
    }
    if (!is_open && end - begin <= widest_opening) {
      const GapFrame frame = frameOf(wall, begin, end);
      if (frame.is_walled || frame.is_covered)
        plan_.unseen_walls.push_back(
            {flat(wall, begin), flat(wall, end), wall.plane()});
    }
  }

  /** \brief Does another wall stand in front of a place of a wall, and end there? */
  bool
  isAbutted(const Wall& wall, double along) const
  {
    constexpr double beside = 0.05, in_front = 0.15, max_cosine = 0.3; // metres
    const Vector2d place = flat(wall, along), front = plan_.placeOf(wall.normal());
    return std::any_of(
        plan_.walls.begin(), plan_.walls.end(), [&](const PlanWall& other) {
          const double from = front.dot(other.from - place),
                       to = front.dot(other.to - place);
          return std::abs(frontOf(other).dot(front)) < max_cosine &&
                 std::abs(frontOf(other).dot(place - other.from)) < beside &&
                 std::min(from, to) < in_front && std::max(from, to) > in_front;
        });
  }

  /** \brief Adds a part of a gap, if it is an opening.
   * \param[in] is_seen Were its sides seen? Otherwise it may be a part of the wall that was
   * hidden, unless the floor goes on in it, or a leaf closes it
   * \return whether it is an opening */
  bool
  addOpening(const Wall& wall, double begin, double end, bool is_seen)
  {
    constexpr double narrowest = 0.4; // metres
    const double width = end - begin;
    if (width < narrowest || width > widest_window || isHidden(wall, begin, end))
      return false;
    PlanOpening opening{flat(wall, begin), flat(wall, end), wall.plane()};
    const GapFrame frame = frameOf(wall, begin, end);
    opening.is_window = frame.bottom > 0;
    opening.bottom = frame.bottom;
    opening.top = frame.top;
    const bool has_frame = frame.is_walled || std::isfinite(frame.top);
    if (opening.is_window
            ? !is_seen || !frame.is_level || !(has_frame || isOutside(opening))
            : width > (std::isfinite(opening.top) ? widest_opening : widest_door) ||
                  !frame.is_covered ||
                  !(is_seen || hasFloor(opening) || hasLeaf(opening)))
      return false;
    if (!isKnown(opening))
      plan_.openings.push_back(opening);
    return true;
  }

  /** \brief Gives both faces of an opening the same sides: the mean ones, or where they differ
   * by more than outlines do, those that leave less open: part of a wall was hidden. */
  static void
  adjust(PlanOpening& one, PlanOpening& other)
  {
    constexpr double same = 0.04; // metres
    const Vector2d along = (one.to - one.from).normalized();
    const auto agree = [&](Vector2d& side, Vector2d& other_side, double outwards) {
      const double off =
          along.dot(other_side - side); // of the other one, along the first
      const double middle = std::abs(off) <= same ? off / 2
                            : off * outwards > 0  ? 0.0
                                                  : off;
      side += middle * along;
      other_side += (middle - off) * along;
    };
    agree(one.from, other.to, -1);
    agree(one.to, other.from, 1);
  }

  /** \brief Was floor seen behind the middle of an opening? */
  bool
  hasFloor(const PlanOpening& opening) const
  {
    constexpr double behind = 0.05; // metres
    const Vector2d place = (opening.from + opening.to) / 2 - behind * frontOf(opening);
    return std::any_of(plan_.floors.begin(),
                       plan_.floors.end(),
                       [&](const auto& loops) { return isInside(loops, place); });
  }

  /** \brief Does a wall, or a leaf, close an opening a little behind its middle? */
  bool
  hasLeaf(const PlanOpening& opening) const
  {
    constexpr double nearest = 0.02, deepest = 0.35; // metres
    const Vector2d middle = (opening.from + opening.to) / 2;
    return std::any_of(
        plan_.walls.begin(), plan_.walls.end(), [&](const PlanWall& other) {
          return meet(middle - nearest * frontOf(opening),
                      middle - deepest * frontOf(opening),
                      other.from,
                      other.to);
        });
  }

  /** \brief Is no wall behind the middle of an opening? */
  bool
  isOutside(const PlanOpening& opening) const
  {
    constexpr double from = 0.02, reach = 2; // metres
    const Vector2d middle = (opening.from + opening.to) / 2;
    return std::none_of(
        plan_.walls.begin(), plan_.walls.end(), [&](const PlanWall& other) {
          return meet(middle - from * frontOf(opening),
                      middle - reach * frontOf(opening),
                      other.from,
                      other.to);
        });
  }

  /** \brief Is there an opening already, of another plane of the same wall? */
  bool
  isKnown(const PlanOpening& opening) const
  {
    constexpr double off = 0.3, min_cosine = 0.9; // metres
    const Vector2d middle = (opening.from + opening.to) / 2;
    return std::any_of(
        plan_.openings.begin(), plan_.openings.end(), [&](const PlanOpening& other) {
          const Vector2d way = other.to - other.from;
          const double share = way.dot(middle - other.from) / way.squaredNorm();
          return other.plane != opening.plane &&
                 frontOf(other).dot(frontOf(opening)) > min_cosine &&
                 std::abs(frontOf(other).dot(middle - other.from)) < off && share > 0 &&
                 share < 1;
        });
  }

  /** \brief What a wall leaves open at the section, metres above the floor. */
  struct Frame {
    double bottom = 0;                                     ///< 0: down to the floor
    double top = std::numeric_limits<double>::quiet_NaN(); ///< NaN: without an end
    bool is_walled = false;  ///< the wall itself ends at the bottom, not a sill alone
    bool is_covered = false; ///< the wall goes on above it, even if in another storey
  };

  /** \brief The same for a gap. */
  struct GapFrame : Frame {
    /** \brief Have bottom and top the same heights along it, as those of a window? The end of
     * what was seen of a wall has not. */
    bool is_level = false;
  };

  /** \brief Bottom and top of a gap where most of it has them; parts of a narrow lintel may not
   * have been seen. */
  GapFrame
  frameOf(const Wall& wall, double begin, double end) const
  {
    constexpr int samples = 9, min_level = 6; // of these
    constexpr double min_share = 0.8;         // of the lintels that were seen
    std::vector<double> bottoms, tops;
    int walled = 0, covered = 0;
    for (int k = 0; k < samples; ++k) {
      const Frame frame =
          frameAt(wall, begin + (0.1 + 0.8 * k / (samples - 1)) * (end - begin));
      bottoms.push_back(frame.bottom);
      walled += frame.is_walled;
      covered += frame.is_covered;
      if (std::isfinite(frame.top))
        tops.push_back(frame.top);
    }
    const auto isLevel =
        [](const std::vector<double>& heights, double middle, double least) {
          constexpr double tolerance = 0.1; // metres
          return static_cast<double>(
                     std::count_if(heights.begin(), heights.end(), [&](double height) {
                       return std::abs(height - middle) <= tolerance;
                     })) >= least;
        };
    GapFrame frame;
    frame.bottom = medianOf(bottoms);
    frame.is_walled = 2 * walled > samples;
    frame.is_covered = 3 * covered >= samples;
    const bool has_top = 3 * tops.size() >= samples;
    if (has_top)
      frame.top = medianOf(tops);
    frame.is_level =
        isLevel(bottoms, frame.bottom, min_level) &&
        (!has_top ||
         isLevel(tops, frame.top, min_share * static_cast<double>(tops.size())));
    return frame;
  }

  static double
  medianOf(std::vector<double> values)
  {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  Frame
  frameAt(const Wall& wall, double along) const
  {
    Frame frame;
    for (const Interval& part : wall.heights(along, plan_.floor))
      if (part.begin > plan_.cut - plan_.floor) {
        frame.is_covered = true;
        if (part.begin < ceiling_)
          frame.top = part.begin;
        break;
      }
      else if (part.end > lowest_sill)
        frame.bottom = part.end;
    frame.is_walled = frame.bottom > 0;
    if (!frame.is_walled)
      frame.bottom = sillAt(flat(wall, along), plan_.placeOf(wall.normal()));
    return frame;
  }

  /** \brief Height above the floor of a sill in a wall: a level plane that lies within its
   * thickness; 0 without one. */
  double
  sillAt(const Vector2d& place, const Vector2d& front) const
  {
    constexpr double in_front = 0.3, deep = thickest_wall + 0.05; // metres
    double highest = 0;
    for (const Level& level : levels_)
      if (level.height > highest && level.box.exteriorDistance(place) < thickest_wall) {
        const auto reaches = [&](double behind) {
          return isInside(level.loops, place - behind * front);
        };
        if ((reaches(0.08) || reaches(0.2)) && !reaches(deep) && !reaches(-in_front))
          highest = level.height;
      }
    return highest;
  }

  /** \brief Where the line of a wall, beyond its end, meets the seen side of the next
   * wall.
   * \param[in] way 1 or -1, along the wall */
  std::optional<double>
  cornerBeyond(const Wall& wall, double from, double way) const
  {
    return nextFace(wall, from, way, -1, widest_window);
  }

  /** \brief Where the line of a wall leaves a pier of which it has met the seen side. */
  std::optional<double>
  pierBeyond(const Wall& wall, double from, double way) const
  {
    return nextFace(wall, from, way, 1, thickest_wall);
  }

  /** \brief Where the line of a wall, from a place on it, meets the next wall across it.
   * \param[in] way 1 or -1, along the wall
   * \param[in] side from which that wall is seen: 1 from beyond it, -1 from the place
   * \param[in] reach metres */
  std::optional<double>
  nextFace(const Wall& wall, double from, double way, double side, double reach) const
  {
    constexpr double min_sine = 0.5;
    constexpr double longer = 0.15; // metres, by which outlines may end before a corner
    const Vector2d begin = flat(wall, from);
    const Vector2d direction = (flat(wall, from + way) - begin).normalized();
    std::optional<double> nearest;
    for (const PlanWall& other : plan_.walls) {
      const double facing = frontOf(other).dot(direction);
      if (!(side * facing > min_sine))
        continue;
      const double distance = (other.from - begin).dot(frontOf(other)) / facing;
      const Vector2d along = (other.to - other.from).normalized();
      const double place = (begin + distance * direction - other.from).dot(along);
      if (distance > 0 && distance <= reach && place >= -longer &&
          place <= (other.to - other.from).norm() + longer &&
          (!nearest || distance < *nearest))
        nearest = distance;
    }
    if (nearest)
      return from + way * *nearest;
    return {};
  }

  /** \brief Does another wall stand in front of the middle of a gap? */
  bool
  isHidden(const Wall& wall, double begin, double end) const
  {
    constexpr double from = 0.02, reach = 1; // metres
    const Vector2d middle = flat(wall, (begin + end) / 2);
    const Vector2d front = plan_.placeOf(wall.normal());
    return std::any_of(
        plan_.walls.begin(), plan_.walls.end(), [&](const PlanWall& other) {
          return meet(
              middle + from * front, middle + reach * front, other.from, other.to);
        });
  }

  FloorPlan plan_;
  std::vector<Wall> walls_;
  std::vector<Cover> covers_;
  std::vector<Level> levels_; ///< between floor and section
  /** \brief What is higher above the floor belongs to another storey. */
  double ceiling_ = std::numeric_limits<double>::infinity();
};

/** \brief The floor as square cells that walls and openings divide into rooms. */
class FloorCells {
public:
  explicit FloorCells(const FloorPlan& plan)
  {
    Eigen::AlignedBox2d box;
    for (const auto& polygon : plan.floors)
      for (const auto& loop : polygon)
        for (const Vector2d& place : loop)
          box.extend(place);
    if (box.isEmpty())
      return;
    // walls may enclose more than the floor that was seen, though not far from it
    const Vector2d reach = Vector2d::Constant(box.sizes().maxCoeff());
    const Eigen::AlignedBox2d near(box.min() - reach, box.max() + reach);
    for (const PlanWall& wall : plan.walls)
      if (near.contains(wall.from) && near.contains(wall.to))
        box.extend(wall.from).extend(wall.to);
    if (!(box.sizes().minCoeff() > 0))
      return;
    cell_ = std::max(0.02, box.sizes().maxCoeff() / 4000);
    origin_ =
        box.min() - Vector2d::Constant(2 * cell_); // with a border around the floor
    columns_ = static_cast<std::size_t>(box.sizes().x() / cell_) + 5;
    rows_ = static_cast<std::size_t>(box.sizes().y() / cell_) + 5;
    kinds_.assign(columns_ * rows_, Kind::Unseen);
    lines_.assign(kinds_.size(), Line::None);
    parts_.assign(kinds_.size(), none);
    for (const auto& polygon : plan.floors)
      forEachInside(polygon, [&](std::size_t index) { kinds_[index] = Kind::Floor; });
    for (const PlanWall& wall : plan.unseen_walls)
      addLine(wall.from, wall.to, Line::Wall);
    for (const PlanOpening& opening : plan.openings)
      addLine(opening.from, opening.to, Line::Opening);
    for (const PlanWall& wall : plan.walls)
      addLine(wall.from, wall.to, Line::Wall);
  }

  /** \brief The parts of the floor that walls or a ceiling enclose. */
  std::vector<PlanRoom>
  rooms(const std::vector<Cover>& covers)
  {
    std::vector<PlanRoom> rooms;
    if (kinds_.empty())
      return rooms;
    std::int32_t parts = 0;
    spread(0, outdoors, [&](std::size_t index) {
      return kinds_[index] == Kind::Unseen && lines_[index] == Line::None;
    });
    for (std::size_t index = 0; index < kinds_.size(); ++index)
      if (parts_[index] == none && lines_[index] == Line::None)
        spread(index, parts++, [&](std::size_t next) {
          return lines_[next] == Line::None;
        });
    shareWalls();
    const std::vector<Center> centers = findCenters(parts);
    std::vector<PlanRoom> of_parts(centers.size());
    std::vector<std::size_t> first_cells(centers.size());
    const double area = cell_ * cell_;
    for (std::size_t index = 0; index < kinds_.size(); ++index)
      if (parts_[index] >= 0) {
        PlanRoom& room = of_parts[static_cast<std::size_t>(parts_[index])];
        if (room.area == 0)
          first_cells[static_cast<std::size_t>(parts_[index])] = index;
        room.area += area;
        room.seen_area += kinds_[index] == Kind::Floor ? area : 0;
      }
    const std::vector<double> ceilings = ceilingsOf(covers, parts);
    constexpr double min_area = 1;      // square metres
    constexpr double one_wall = 0.5;    // of all directions
    constexpr double min_ceiling = 0.3; // of the area
    constexpr double min_width = 0.46;  // metres: the sill of a window is no room
    std::vector<std::size_t> kept;
    for (std::size_t part = 0; part < centers.size(); ++part)
      if (of_parts[part].seen_area >= min_area &&
          2 * cell_ * centers[part].distance >= min_width &&
          (ceilings[part] >= min_ceiling * of_parts[part].area ||
           enclosureOf(centers[part].cell) > one_wall)) {
        of_parts[part].center = placeOf(centers[part].cell);
        of_parts[part].outline = outlineFrom(first_cells[part]);
        kept.push_back(part);
      }
    std::stable_sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) {
      return of_parts[a].area > of_parts[b].area;
    });
    rooms_of_parts_.assign(centers.size(), none);
    for (const std::size_t part : kept) {
      rooms_of_parts_[part] = static_cast<std::int32_t>(rooms.size());
      rooms.push_back(of_parts[part]);
    }
    return rooms;
  }

  /** \brief Finds the planes around the rooms, and the rooms beside openings. */
  void
  join(const std::vector<Cover>& covers, FloorPlan& plan) const
  {
    if (plan.rooms.empty())
      return;
    std::vector<std::map<std::size_t, double>> sizes(plan.rooms.size()); // of planes
    for (const PlanWall& wall : plan.walls)
      for (double at = cell_ / 2; at < (wall.to - wall.from).norm(); at += cell_) {
        const Vector2d place = wall.from + at * (wall.to - wall.from).normalized();
        const std::int32_t room = roomBeside(place, frontOf(wall));
        if (room >= 0)
          sizes[static_cast<std::size_t>(room)][wall.plane] += cell_;
      }
    constexpr double min_length = 0.1; // metres
    addLarge(sizes, min_length, plan.rooms);
    sizes.assign(sizes.size(), {});
    for (const Cover& cover : covers)
      forEachInside(cover.loops, [&](std::size_t index) {
        if (const std::int32_t room = roomAt(index); room >= 0)
          sizes[static_cast<std::size_t>(room)][cover.plane] += cell_ * cell_;
      });
    constexpr double min_area = 0.3; // square metres
    addLarge(sizes, min_area, plan.rooms);
    for (PlanRoom& room : plan.rooms)
      std::sort(room.planes.begin(), room.planes.end());
    for (PlanOpening& opening : plan.openings) {
      const Vector2d middle = (opening.from + opening.to) / 2;
      opening.rooms = {roomBeside(middle, frontOf(opening)),
                       roomBeside(middle, -frontOf(opening))};
    }
  }

private:
  /** \brief Share of the directions from a cell in which a wall or an opening is; a straight
   * wall is in less than half of them. */
  double
  enclosureOf(std::size_t cell) const
  {
    constexpr int directions = 72;
    int met = 0;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * M_PI * k / directions;
      const Vector2d step(std::cos(angle) / 2, std::sin(angle) / 2); // cells
      Vector2d place = (placeOf(cell) - origin_) / cell_;
      while (isWithin(place) && lines_[indexOf(place)] == Line::None)
        place += step;
      met += isWithin(place);
    }
    return static_cast<double>(met) / directions;
  }

  /** \brief Area of the ceilings above each part, square metres. */
  std::vector<double>
  ceilingsOf(const std::vector<Cover>& covers, std::int32_t parts) const
  {
    std::vector<double> areas(static_cast<std::size_t>(parts));
    for (const Cover& cover : covers)
      if (cover.is_ceiling)
        forEachInside(cover.loops, [&](std::size_t index) {
          if (parts_[index] >= 0)
            areas[static_cast<std::size_t>(parts_[index])] += cell_ * cell_;
        });
    return areas;
  }

  enum class Kind : std::uint8_t { Unseen, Floor };
  enum class Line : std::uint8_t { None, Opening, Wall };
  static constexpr std::int32_t none = -1, outdoors = -2; // instead of a part

  Vector2d
  placeOf(std::size_t index) const
  {
    return origin_ + cell_ * Vector2d(static_cast<double>(index % columns_) + 0.5,
                                      static_cast<double>(index / columns_) + 0.5);
  }

  /** \brief The border of a part.
   * \param[in] first the first one of its cells */
  std::vector<Vector2d>
  outlineFrom(std::size_t first) const
  {
    constexpr double tolerance = 1.5; // cells
    const auto columns = static_cast<int>(columns_);
    const auto isInside = [&](const Eigen::Vector2i& cell) {
      return cell.minCoeff() >= 0 && cell.x() < columns &&
             cell.y() < static_cast<int>(rows_) &&
             parts_[static_cast<std::size_t>(cell.y()) * columns_ +
                    static_cast<std::size_t>(cell.x())] == parts_[first];
    };
    std::vector<Vector2d> outline = acmap::outlineOfCells(
        {static_cast<int>(first % columns_), static_cast<int>(first / columns_)},
        isInside,
        tolerance);
    for (Vector2d& corner : outline)
      corner = origin_ + cell_ * corner;
    return outline;
  }

  static void
  addLarge(const std::vector<std::map<std::size_t, double>>& sizes,
           double minimum,
           std::vector<PlanRoom>& rooms)
  {
    for (std::size_t room = 0; room < rooms.size(); ++room)
      for (const auto& [plane, size] : sizes[room])
        if (size >= minimum)
          rooms[room].planes.push_back(plane);
  }

  /** \brief The room of a cell, or none. */
  std::int32_t
  roomAt(std::size_t index) const
  {
    const std::int32_t part = parts_[index];
    return part < 0 ? none : rooms_of_parts_[static_cast<std::size_t>(part)];
  }

  /** \brief The first room in a direction, or none before the next wall. */
  std::int32_t
  roomBeside(const Vector2d& from, const Vector2d& direction) const
  {
    // a cell of the line itself is less than a diagonal away
    for (double at = 1.5 * cell_; at <= thickest_wall; at += cell_ / 2) {
      const Vector2d place = (from + at * direction - origin_) / cell_;
      if (!isWithin(place))
        return none;
      const std::size_t index = indexOf(place);
      if (lines_[index] == Line::Wall)
        return none;
      if (lines_[index] == Line::None && roomAt(index) >= 0)
        return roomAt(index);
    }
    return none;
  }

  /** \brief Is a place, in cells, within the border? */
  bool
  isWithin(const Vector2d& place) const
  {
    return place.minCoeff() >= 1 && place.x() < static_cast<double>(columns_ - 1) &&
           place.y() < static_cast<double>(rows_ - 1);
  }

  std::size_t
  indexOf(const Vector2d& place) const
  {
    return static_cast<std::size_t>(place.y()) * columns_ +
           static_cast<std::size_t>(place.x());
  }

  template <typename Visitor>
  void
  forEachInside(const std::vector<std::vector<Vector2d>>& polygon,
                const Visitor& visit) const
  {
    for (std::size_t row = 0; row < rows_; ++row) {
      const double y = placeOf(row * columns_).y();
      std::vector<double> crossings;
      for (const std::vector<Vector2d>& loop : polygon)
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const Vector2d &a = loop[k], &b = loop[(k + 1) % loop.size()];
          if ((a.y() > y) != (b.y() > y))
            crossings.push_back(a.x() +
                                (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
      std::sort(crossings.begin(), crossings.end());
      const auto columnAt = [&](double x) {
        return static_cast<std::size_t>(
            std::clamp(std::ceil((x - origin_.x()) / cell_ - 0.5),
                       0.0,
                       static_cast<double>(columns_)));
      };
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        for (std::size_t column = columnAt(crossings[k]);
             column < columnAt(crossings[k + 1]);
             ++column)
          visit(row * columns_ + column);
    }
  }

  /** \brief Marks the cells of a line, a little longer than it is: outlines may end
   * before the corner of a room. */
  void
  addLine(const Vector2d& from, const Vector2d& to, Line line)
  {
    constexpr double longer = 0.15; // metres
    const double length = (to - from).norm();
    if (!(length > 0))
      return;
    for (double at = -longer; at <= length + longer; at += cell_ / 2) {
      const Vector2d place = (from + at / length * (to - from) - origin_) / cell_;
      // the cells of the border stay free, so that the outdoors is connected
      if (isWithin(place))
        lines_[indexOf(place)] = line;
    }
  }

  template <typename Visitor>
  void
  forEachBeside(std::size_t index, const Visitor& visit) const
  {
    if (index >= columns_)
      visit(index - columns_);
    if (index % columns_ > 0)
      visit(index - 1);
    if ((index + 1) % columns_ > 0)
      visit(index + 1);
    if (index + columns_ < kinds_.size())
      visit(index + columns_);
  }

  /** \brief Gives a part to a cell and to all cells connected with it that have none and
   * may belong to it. */
  template <typename Belongs>
  void
  spread(std::size_t start, std::int32_t part, const Belongs& belongs)
  {
    std::vector<std::size_t> open{start};
    parts_[start] = part;
    while (!open.empty()) {
      const std::size_t index = open.back();
      open.pop_back();
      forEachBeside(index, [&](std::size_t next) {
        if (parts_[next] == none && belongs(next)) {
          parts_[next] = part;
          open.push_back(next);
        }
      });
    }
  }

  /** \brief Floor below the line of a wall belongs to the part beside it. */
  void
  shareWalls()
  {
    std::vector<std::size_t> open;
    for (std::size_t index = 0; index < parts_.size(); ++index)
      if (parts_[index] >= 0)
        open.push_back(index);
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::size_t index = open[k];
      forEachBeside(index, [&](std::size_t next) {
        if (parts_[next] == none && kinds_[next] == Kind::Floor) {
          parts_[next] = parts_[index];
          open.push_back(next);
        }
      });
    }
  }

  /** \brief The middle of a part. */
  struct Center {
    std::size_t cell = 0;
    std::int32_t distance = 0; ///< from the border of the part, cells
  };

  /** \brief The one of some cells that is nearest to their mean. */
  std::size_t
  middleOf(const std::vector<std::size_t>& cells) const
  {
    Vector2d mean = Vector2d::Zero();
    for (const std::size_t cell : cells)
      mean += placeOf(cell) / static_cast<double>(cells.size());
    return *std::min_element(
        cells.begin(), cells.end(), [&](std::size_t one, std::size_t other) {
          return (placeOf(one) - mean).squaredNorm() <
                 (placeOf(other) - mean).squaredNorm();
        });
  }

  /** \brief For each part the middle one of the cells with the maximum distance, along rows and
   * columns, from the cells that are not in it. */
  std::vector<Center>
  findCenters(std::int32_t parts) const
  {
    std::vector<std::int32_t> distances(parts_.size());
    std::vector<std::size_t> shell, next_shell;
    for (std::size_t index = 0; index < parts_.size(); ++index)
      forEachBeside(index, [&](std::size_t next) {
        if (parts_[index] >= 0 && parts_[next] != parts_[index] &&
            distances[index] == 0) {
          distances[index] = 1;
          shell.push_back(index);
        }
      });
    std::vector<Center> centers(static_cast<std::size_t>(parts));
    std::vector<std::vector<std::size_t>> farthest(centers.size());
    for (std::int32_t distance = 2; !shell.empty(); ++distance) {
      next_shell.clear();
      for (const std::size_t index : shell) {
        const auto part = static_cast<std::size_t>(parts_[index]);
        if (centers[part].distance < distance - 1)
          farthest[part].clear();
        centers[part].distance = distance - 1;
        farthest[part].push_back(index);
        forEachBeside(index, [&](std::size_t next) {
          if (parts_[next] == parts_[index] && distances[next] == 0) {
            distances[next] = distance;
            next_shell.push_back(next);
          }
        });
      }
      shell.swap(next_shell);
    }
    for (std::size_t part = 0; part < centers.size(); ++part)
      centers[part].cell = middleOf(farthest[part]);
    return centers;
  }

  Vector2d origin_ = Vector2d::Zero();
  double cell_ = 0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<Kind> kinds_;
  std::vector<Line> lines_;
  std::vector<std::int32_t> parts_;
  std::vector<std::int32_t> rooms_of_parts_;
};

} // namespace

FloorPlan
makeFloorPlan(const CompactMap& map)
{
  PlanMaker maker(map);
  FloorPlan plan = maker.make();
  FloorCells cells(plan);
  plan.rooms = cells.rooms(maker.covers());
  cells.join(maker.covers(), plan);
  if (plan.rooms.size() == map.rooms.size())
    for (std::size_t room = 0; room < plan.rooms.size(); ++room)
      plan.rooms[room].name = map.rooms[room].label.name;
  acmap::addContents(map, plan);
  return plan;
}

void
setRooms(const FloorPlan& plan, CompactMap& map)
{
  const auto onFloor = [&](const Vector2d& place) { return plan.pointAt(place, 0); };
  map.rooms.clear();
  for (const PlanRoom& room : plan.rooms)
    map.rooms.push_back({onFloor(room.center),
                         room.area,
                         room.seen_area,
                         {room.planes.begin(), room.planes.end()},
                         {}});
  map.openings.clear();
  std::vector<const PlanOpening*> fronts; // of the openings of the map
  for (const PlanOpening& opening : plan.openings) {
    const auto plane = static_cast<std::int32_t>(opening.plane);
    const auto other =
        std::find_if(fronts.begin(), fronts.end(), [&](const PlanOpening* front) {
          return areFaces(*front, opening);
        });
    if (other != fronts.end()) {
      MapOpening& one = map.openings[static_cast<std::size_t>(other - fronts.begin())];
      one.planes[1] = plane;
      if (one.rooms[1] < 0)
        one.rooms[1] = opening.rooms[0];
      continue;
    }
    fronts.push_back(&opening);
    map.openings.push_back({onFloor(opening.from),
                            onFloor(opening.to),
                            opening.bottom,
                            opening.top,
                            opening.is_window ? OpeningKind::Window : OpeningKind::Door,
                            {plane, -1},
                            opening.rooms});
  }
  for (std::size_t k = 0; k < map.openings.size(); ++k)
    for (std::size_t room = 0; room < map.rooms.size(); ++room)
      if (const auto& sides = map.openings[k].rooms;
          std::count(sides.begin(), sides.end(), static_cast<std::int32_t>(room)) > 0)
        map.rooms[room].openings.push_back(static_cast<std::int32_t>(k));
}

} // namespace pcl
