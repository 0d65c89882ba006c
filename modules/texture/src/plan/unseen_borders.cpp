#include "plan/unseen_borders.h"

#include <pcl/core/impl/planar_geometry.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Border = std::vector<Vector2d>;

/** \brief Finds the borders of a plan that are neither walls nor openings. */
class BorderFinder {
public:
  explicit BorderFinder(const FloorPlan& plan)
  : plan_(plan)
  {
    for (const PlanWall& wall : plan.walls)
      if (wall.role == SurfaceRole::Wall)
        closed_.push_back({wall.from, wall.to});
    for (const PlanOpening& opening : plan.openings)
      closed_.push_back({opening.from, opening.to});
    for (const PlanWall& wall : plan.unseen_walls)
      closed_.push_back({wall.from, wall.to});
  }

  std::vector<Border>
  find()
  {
    for (const PlanWall& wall : plan_.unseen_walls)
      borders_.push_back({wall.from, wall.to});
    for (const PlanRoom& room : plan_.rooms)
      addOpenBorders(room.outline);
    return borders_;
  }

  /** \brief The corners in which walls meet that end before it. */
  std::vector<PlanWall>
  hiddenCorners() const
  {
    std::vector<const PlanWall*> ending, beginning;
    for (const PlanWall& wall : plan_.walls)
      if (wall.role == SurfaceRole::Wall) {
        if (isEndFree(wall.to, wall.from))
          ending.push_back(&wall);
        if (isEndFree(wall.from, wall.to))
          beginning.push_back(&wall);
      }
    std::vector<PlanWall> corners;
    for (const PlanWall* wall : ending) {
      std::optional<Border> shortest;
      const PlanWall* nearest = nullptr;
      for (const PlanWall* next : beginning)
        if (const auto corner = cornerOf(*wall, *next);
            corner && (!shortest || lengthOf(*corner) < lengthOf(*shortest))) {
          shortest = corner;
          nearest = next;
        }
      if (!shortest)
        continue;
      corners.push_back({(*shortest)[0], (*shortest)[1], wall->plane});
      corners.push_back({(*shortest)[1], (*shortest)[2], nearest->plane});
    }
    return corners;
  }

private:
  struct Segment {
    Vector2d from, to;
  };

  void
  add(const Border& border)
  {
    for (std::size_t k = 0; k + 1 < border.size(); ++k)
      closed_.push_back({border[k], border[k + 1]});
    borders_.push_back(border);
  }

  static double
  distanceTo(const Segment& segment, const Vector2d& place)
  {
    const Vector2d way = segment.to - segment.from;
    const double share =
        way.squaredNorm() > 0 ? way.dot(place - segment.from) / way.squaredNorm() : 0;
    return (segment.from + std::clamp(share, 0.0, 1.0) * way - place).norm();
  }

  /** \brief Is nothing beside an end of a wall but what continues the wall backwards? */
  bool
  isEndFree(const Vector2d& end, const Vector2d& start) const
  {
    constexpr double near = 0.2, beyond = 0.02, max_sine = 0.1; // metres
    const Vector2d way = (end - start).normalized();
    return std::none_of(closed_.begin(), closed_.end(), [&](const Segment& other) {
      const bool is_behind =
          std::abs(crossOf(way, (other.to - other.from).normalized())) < max_sine &&
          std::max(way.dot(other.from - end), way.dot(other.to - end)) < beyond;
      return !is_behind && distanceTo(other, end) < near;
    });
  }

  static std::optional<Border>
  cornerOf(const PlanWall& wall, const PlanWall& next)
  {
    constexpr double min_sine = 0.5, longest = 2.5; // metres
    const Vector2d way = (wall.to - wall.from).normalized(),
                   other = (next.to - next.from).normalized();
    const double sine = crossOf(way, other); // positive: the room is in the corner
    if (sine < min_sine)
      return {};
    const double ahead = crossOf(next.from - wall.to, other) / sine;
    const Vector2d corner = wall.to + ahead * way;
    const double before = other.dot(next.from - corner);
    if (ahead < 0 || before < 0 || ahead > longest || before > longest)
      return {};
    return Border{wall.to, corner, next.from};
  }

  static double
  lengthOf(const Border& border)
  {
    double length = 0;
    for (std::size_t k = 0; k + 1 < border.size(); ++k)
      length += (border[k + 1] - border[k]).norm();
    return length;
  }

  /** \brief Adds the parts of the outline of a room that end in the open: with nothing beside
   * them, nor a little further outside, where only the floor was hidden. */
  void
  addOpenBorders(const std::vector<Vector2d>& outline)
  {
    constexpr double shortest = 0.3, step = 0.1; // metres
    constexpr double most_steps = 4000;
    double length = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
      length += (outline[(k + 1) % outline.size()] - outline[k]).norm();
    const double part = std::max(step, length / most_steps);
    const std::vector<Segment> closed = closed_;
    Border border;
    const auto finish = [&] {
      if (lengthOf(border) >= shortest)
        add(withoutStraightPoints(border));
      border.clear();
    };
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vector2d &a = outline[k], &b = outline[(k + 1) % outline.size()];
      const Vector2d way = b - a;
      const auto steps = std::max(1, static_cast<int>(std::ceil(way.norm() / part)));
      const Vector2d outwards = Vector2d(way.y(), -way.x()).normalized();
      for (int s = 0; s < steps; ++s) {
        const Vector2d place = a + static_cast<double>(s) / steps * way;
        if (isClosed(place, outwards, closed))
          finish();
        else
          border.push_back(place);
      }
    }
    finish();
  }

  bool
  isClosed(const Vector2d& place,
           const Vector2d& outwards,
           const std::vector<Segment>& closed) const
  {
    constexpr double near = 0.25, hidden = 4; // metres
    const auto isNear = [&](const Segment& one) {
      if (distanceTo(one, place) < near)
        return true;
      const double a = crossOf(outwards, one.from - place),
                   b = crossOf(outwards, one.to - place);
      if ((a > 0) == (b > 0))
        return false;
      const double distance =
          outwards.dot(one.from + a / (a - b) * (one.to - one.from) - place);
      return distance > 0 && distance < hidden;
    };
    return std::any_of(closed.begin(), closed.end(), isNear) ||
           std::any_of(
               plan_.columns.begin(), plan_.columns.end(), [&](const auto& one) {
                 return std::abs((place - one.center).norm() - one.radius) < near;
               });
  }

  static Border
  withoutStraightPoints(const Border& border)
  {
    constexpr double straight = 1e-9;
    Border bent;
    for (std::size_t k = 0; k < border.size(); ++k)
      if (k == 0 || k + 1 == border.size() ||
          std::abs(crossOf((border[k] - border[k - 1]).normalized(),
                           (border[k + 1] - border[k]).normalized())) > straight)
        bent.push_back(border[k]);
    return bent;
  }

  const FloorPlan& plan_;
  std::vector<Segment> closed_;
  std::vector<Border> borders_;
};

} // namespace

void
addHiddenCorners(FloorPlan& plan)
{
  const std::vector<PlanWall> corners = BorderFinder(plan).hiddenCorners();
  plan.unseen_walls.insert(plan.unseen_walls.end(), corners.begin(), corners.end());
}

std::vector<Border>
unseenBordersOf(const FloorPlan& plan)
{
  return BorderFinder(plan).find();
}

} // namespace pcl::acmap
