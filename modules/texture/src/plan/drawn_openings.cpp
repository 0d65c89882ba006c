#include "plan/drawn_openings.h"

#include "plan/opening_faces.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

/** \brief Distance to the first wall in a direction, at most a reach. */
double
distanceToWall(const FloorPlan& plan,
               const Vector2d& from,
               const Vector2d& direction,
               double reach)
{
  double nearest = reach;
  const Vector2d aside(-direction.y(), direction.x());
  for (const PlanWall& wall : plan.walls) {
    const double a = aside.dot(wall.from - from), b = aside.dot(wall.to - from);
    if ((a > 0) == (b > 0) || wall.role != SurfaceRole::Wall)
      continue;
    const double distance =
        direction.dot(wall.from + a / (a - b) * (wall.to - wall.from) - from);
    if (distance > 0)
      nearest = std::min(nearest, distance);
  }
  return nearest;
}

/** \brief The measured thickness of the wall beside an opening, or 0. */
double
depthBeside(const PlanOpening& opening, const std::vector<WallBody>& bodies)
{
  constexpr double same = 0.05; // metres
  for (const WallBody& body : bodies)
    if (body.is_measured)
      for (const auto& [side, end, back] :
           {std::tuple(&opening.from, 1, 2), std::tuple(&opening.to, 0, 3)}) {
        const Vector2d& on_face = body.corners[static_cast<std::size_t>(end)];
        if ((on_face - *side).norm() < same)
          return -frontOf(opening).dot(body.corners[static_cast<std::size_t>(back)] -
                                       on_face);
      }
  return 0;
}

/** \brief How far back the reveals beside an opening were seen, or 0. */
double
depthOfReveals(const PlanOpening& opening, const FloorPlan& plan)
{
  constexpr double same = 0.06, max_cosine = 0.1; // metres
  const Vector2d along = (opening.to - opening.from).normalized();
  const Vector2d front = frontOf(opening);
  double depth = 0;
  for (const PlanWall& wall : plan.walls) {
    const Vector2d way = (wall.to - wall.from).normalized();
    const double near = std::min(-front.dot(wall.from - opening.from),
                                 -front.dot(wall.to - opening.from)),
                 far = std::max(-front.dot(wall.from - opening.from),
                                -front.dot(wall.to - opening.from));
    for (const Vector2d& side : {opening.from, opening.to})
      if (std::abs(along.dot(way)) < max_cosine &&
          std::abs(along.dot(wall.from - side)) < same && std::abs(near) < same &&
          far < thickest_wall)
        depth = std::max(depth, far);
  }
  return depth;
}

/** \brief Does a leaf turn towards the front of the opening? */
bool
opensToFront(const DrawnOpening& opening)
{
  const auto [front, back] = opening.face.rooms;
  if (std::isfinite(opening.face.leaf))
    return opening.is_measured && opening.face.leaf < opening.depth / 2;
  // rooms are ordered by decreasing area
  return back < 0 || (front >= 0 && front > back);
}

void
findHinge(const FloorPlan& plan, DrawnOpening& opening)
{
  constexpr double beside = 0.05, reach = 4; // metres
  const PlanOpening& face = opening.face;
  const Vector2d along = (face.to - face.from).normalized();
  const Vector2d off = opening.opens_to_front
                           ? Vector2d(beside * frontOf(face))
                           : Vector2d(-(opening.depth + beside) * frontOf(face));
  const bool is_at_from = distanceToWall(plan, face.from + off, -along, reach) <=
                          distanceToWall(plan, face.to + off, along, reach);
  opening.hinge = is_at_from ? face.from : face.to;
  opening.lock = is_at_from ? face.to : face.from;
}

} // namespace

Vector2d
DrawnOpening::onBack(const Vector2d& place) const
{
  return place - depth * frontOf(face);
}

std::vector<DrawnOpening>
drawnOpeningsOf(const FloorPlan& plan,
                const std::vector<WallBody>& bodies,
                double strip)
{
  std::vector<DrawnOpening> openings;
  for (const PlanOpening& opening : plan.openings) {
    const auto other =
        std::find_if(openings.begin(), openings.end(), [&](const DrawnOpening& one) {
          return !one.is_measured && areFaces(one.face, opening);
        });
    if (other == openings.end()) {
      openings.push_back({opening});
      continue;
    }
    other->depth =
        -frontOf(other->face).dot((opening.from + opening.to) / 2 - other->face.from);
    other->is_measured = true;
    if (other->face.rooms[1] < 0)
      other->face.rooms[1] = opening.rooms[0];
  }
  constexpr double thinnest = 0.03; // of a wall, metres
  for (DrawnOpening& opening : openings) {
    if (!opening.is_measured) {
      opening.depth = depthBeside(opening.face, bodies);
      opening.is_measured = opening.depth > thinnest;
      if (!opening.is_measured)
        opening.depth = std::max(strip, depthOfReveals(opening.face, plan));
    }
    opening.opens_to_front = opensToFront(opening);
    findHinge(plan, opening);
  }
  return openings;
}

} // namespace pcl::acmap
