#include "quality/presumed_surfaces.h"

#include "quality/plan_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double depth = 4;   // metres beyond an open end
constexpr double cell = 0.25; // metres

/** \brief Share of what is presumed that is there: a corridor goes on, a room may end soon. */
constexpr double expected_of_corridor = 0.9, expected_of_room = 0.3;

bool
cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
  const auto side =
      [](const Vector2d& from, const Vector2d& to, const Vector2d& point) {
        return crossOf(to - from, point - from) > 0;
      };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

/** \brief Spreads floor and ceiling from the open ends of the rooms. */
class SpreadFloor {
public:
  SpreadFloor(const FloorPlan& plan, const UnseenSurfaces& unseen)
  : plan_(plan)
  {
    for (const UnseenPatch& patch : unseen.patches)
      if (patch.is_open) {
        const Vector2d place = plan.placeOf(patch.center);
        const double height = plan.heightOf(patch.center);
        if (ends_.empty() || ends_.back().place != place) // once for all heights
          ends_.push_back({place, -plan.placeOf(patch.normal), patch.room});
        heights_[patch.room] = std::max(heights_[patch.room], height);
      }
  }

  PresumedSurfaces
  spread(const UnseenSurfaces& unseen)
  {
    for (const UnseenPatch& patch : unseen.patches)
      if (!patch.is_open || isInLineWithWall(patch))
        presumed_.patches.push_back(patch);
    continueWalls();
    spreadLevels();
    return std::move(presumed_);
  }

private:
  using Cell = std::pair<std::int32_t, std::int32_t>;

  struct OpenEnd {
    Vector2d place, outwards;
    std::int32_t room;
  };

  struct SpreadCell {
    Cell cell;
    std::int32_t room;
    Vector2d origin; ///< the open end from which it was reached
  };

  static Cell
  cellOf(const Vector2d& place)
  {
    const auto index = [](double length) {
      constexpr double farthest = 1e9;
      return static_cast<std::int32_t>(
          std::clamp(std::floor(length / cell), -farthest, farthest));
    };
    return {index(place.x()), index(place.y())};
  }

  static Vector2d
  placeOf(const Cell& which)
  {
    return {(which.first + 0.5) * cell, (which.second + 0.5) * cell};
  }

  /** \brief Does a seen wall point along the border of which a patch is a part? */
  bool
  isInLineWithWall(const UnseenPatch& patch) const
  {
    constexpr double near = 0.35, longest = 8, max_sine = 0.2; // metres
    const Vector2d place = plan_.placeOf(patch.center),
                   normal = plan_.placeOf(patch.normal).normalized();
    return std::any_of(
        plan_.walls.begin(), plan_.walls.end(), [&](const PlanWall& wall) {
          const Vector2d way = (wall.to - wall.from).normalized();
          return wall.role == SurfaceRole::Wall &&
                 std::abs(way.dot(normal)) < max_sine &&
                 std::abs(crossOf(way, place - wall.from)) < near &&
                 std::min((place - wall.from).norm(), (place - wall.to).norm()) <
                     longest;
        });
  }

  bool
  isInRoom(const Vector2d& place) const
  {
    return std::any_of(
        plan_.rooms.begin(), plan_.rooms.end(), [&](const PlanRoom& room) {
          return isInside(room.outline, place);
        });
  }

  bool
  isBlocked(const Vector2d& from, const Vector2d& to) const
  {
    return std::any_of(plan_.walls.begin(),
                       plan_.walls.end(),
                       [&](const PlanWall& wall) {
                         return cross(from, to, wall.from, wall.to);
                       }) ||
           std::any_of(presumed_.walls.begin(),
                       presumed_.walls.end(),
                       [&](const PresumedWall& wall) {
                         return cross(from, to, wall.from, wall.to);
                       });
  }

  /** \brief Room whose open end is nearest to the end of a wall, at most 4 m away; -1 if there is none,
   * or if another wall or an opening begins there. */
  std::int32_t
  roomEndingAt(const Vector2d& end, const PlanWall& wall) const
  {
    constexpr double near = 0.3; // metres
    const auto isNear = [&](const auto& line) {
      return distanceToSegment(line.from, line.to, end) < near;
    };
    const auto isNext = [&](const PlanWall& other) {
      return &other != &wall && isNear(other);
    };
    if (std::any_of(plan_.walls.begin(), plan_.walls.end(), isNext) ||
        std::any_of(plan_.openings.begin(), plan_.openings.end(), isNear))
      return -1;
    std::int32_t room = -1;
    double distance = depth;
    for (const OpenEnd& one : ends_)
      if (const double its = (one.place - end).norm(); its < distance) {
        room = one.room;
        distance = its;
      }
    return room;
  }

  /** \brief Are walls, seen or presumed, close on two opposite sides of a place? */
  bool
  isInCorridor(const Vector2d& place) const
  {
    constexpr double max_width = 3; // metres
    constexpr int directions = 4;   // of lines through the place
    for (int k = 0; k < directions; ++k) {
      const double angle = 3.14159265358979323846 * k / directions;
      const Vector2d way(std::cos(angle), std::sin(angle));
      if (distanceToWall(place, way, max_width) +
              distanceToWall(place, -way, max_width) <
          max_width)
        return true;
    }
    return false;
  }

  /** \brief At most the reach. */
  double
  distanceToWall(const Vector2d& place, const Vector2d& way, double reach) const
  {
    double nearest = reach;
    const auto meet = [&](const auto& wall) {
      if (!cross(place, place + nearest * way, wall.from, wall.to))
        return;
      const Vector2d along = wall.to - wall.from;
      nearest =
          std::min(nearest, crossOf(wall.from - place, along) / crossOf(way, along));
    };
    std::for_each(plan_.walls.begin(), plan_.walls.end(), meet);
    std::for_each(presumed_.walls.begin(), presumed_.walls.end(), meet);
    return nearest;
  }

  void
  continueWalls()
  {
    constexpr double beside = 0.02; // metres, so that a wall does not meet itself
    std::vector<std::pair<Vector2d, std::int32_t>> fronts;
    for (const PlanWall& wall : plan_.walls) {
      if (wall.role != SurfaceRole::Wall)
        continue;
      const Vector2d way = (wall.to - wall.from).normalized();
      const Vector2d front(-way.y(), way.x());
      for (const bool is_end : {false, true}) {
        const Vector2d from = is_end ? wall.to : wall.from;
        const Vector2d ahead = is_end ? way : -way;
        const std::int32_t room = roomEndingAt(from, wall);
        if (room < 0)
          continue;
        const Vector2d begin = from + beside * ahead;
        double length = 0;
        while (length < depth && !meetsWall(begin, begin + (length + cell) * ahead) &&
               !isInRoom(begin + (length + cell) * ahead + cell * front))
          length += cell;
        if (length > 0) {
          presumed_.walls.push_back({begin, begin + length * ahead});
          fronts.emplace_back(front, room);
        }
      }
    }
    for (std::size_t k = 0; k < fronts.size(); ++k) // once all of them stand
      addWall(presumed_.walls[k], fronts[k].first, fronts[k].second);
  }

  bool
  meetsWall(const Vector2d& from, const Vector2d& to) const
  {
    return std::any_of(
        plan_.walls.begin(), plan_.walls.end(), [&](const PlanWall& wall) {
          return cross(from, to, wall.from, wall.to);
        });
  }

  void
  addWall(const PresumedWall& wall, const Vector2d& front, std::int32_t room)
  {
    const double height = heights_.at(room), length = (wall.to - wall.from).norm();
    const Vector3d normal = front.x() * plan_.x_axis + front.y() * plan_.y_axis;
    const double expected = isInCorridor(wall.from + cell * front)
                                ? expected_of_corridor
                                : expected_of_room;
    for (double along = cell / 2; along < length; along += cell)
      for (double up = cell / 2; up < height; up += cell)
        presumed_.patches.push_back(
            {plan_.pointAt(wall.from + along / length * (wall.to - wall.from), up),
             normal,
             expected * cell * cell,
             SurfaceRole::Wall,
             room,
             true});
  }

  void
  spreadLevels()
  {
    std::map<Cell, bool> reached;
    std::deque<SpreadCell> open;
    const auto add = [&](const SpreadCell& next) {
      const Vector2d place = placeOf(next.cell);
      if ((place - next.origin).norm() > depth || isInRoom(place) ||
          !reached.emplace(next.cell, true).second)
        return;
      open.push_back(next);
      const double expected =
          isInCorridor(place) ? expected_of_corridor : expected_of_room;
      for (const bool is_ceiling : {false, true})
        presumed_.patches.push_back(
            {plan_.pointAt(place, is_ceiling ? heights_.at(next.room) : 0),
             is_ceiling ? (-plan_.up).eval() : plan_.up,
             expected * cell * cell,
             is_ceiling ? SurfaceRole::Ceiling : SurfaceRole::Floor,
             next.room,
             true});
    };
    for (const OpenEnd& end : ends_)
      add({cellOf(end.place + cell * end.outwards), end.room, end.place});
    while (!open.empty()) {
      const SpreadCell one = open.front();
      open.pop_front();
      for (const auto& [x, y] : {Cell{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const Cell next{one.cell.first + x, one.cell.second + y};
        if (!isBlocked(placeOf(one.cell), placeOf(next)))
          add({next, one.room, one.origin});
      }
    }
  }

  const FloorPlan& plan_;
  std::vector<OpenEnd> ends_;
  std::map<std::int32_t, double> heights_; ///< of the rooms with open ends
  PresumedSurfaces presumed_;
};

} // namespace

PresumedSurfaces
presumedSurfaces(const FloorPlan& plan, const UnseenSurfaces& unseen)
{
  return SpreadFloor(plan, unseen).spread(unseen);
}

bool
isBehindPresumed(const std::vector<PresumedWall>& walls,
                 const Vector2d& eye,
                 const Vector2d& place)
{
  constexpr double before = 0.95; // what is on the wall itself is not behind it
  const Vector2d end = eye + before * (place - eye);
  return std::any_of(walls.begin(), walls.end(), [&](const PresumedWall& wall) {
    return cross(eye, end, wall.from, wall.to);
  });
}

} // namespace pcl::acmap
