#include "plan/wall_bodies.h"

#include "plan/opening_faces.h"

#include <pcl/core/impl/planar_geometry.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

/** \brief The seen side of a wall. */
struct Face {
  std::size_t wall;
  Vector2d from, along, front;
  double length;
};

std::vector<Face>
facesOf(const FloorPlan& plan)
{
  constexpr double shortest = 1e-3; // metres
  std::vector<Face> faces;
  for (std::size_t w = 0; w < plan.walls.size(); ++w) {
    const PlanWall& wall = plan.walls[w];
    const double length = (wall.to - wall.from).norm();
    if (wall.role == SurfaceRole::Wall && length > shortest)
      faces.push_back(
          {w, wall.from, (wall.to - wall.from) / length, frontOf(wall), length});
  }
  return faces;
}

/** \brief A part of a face with one back: the distance of the back behind its begin and
 * its end. */
struct Part {
  double begin, end;
  double behind_begin, behind_end;
  bool is_measured;
};

/** \brief Another face as seen from one: where it is behind it, along it. */
struct Back {
  double begin, end;
  double behind, slope; ///< at along = 0, and its change by metre

  double
  at(double along) const
  {
    return behind + slope * along;
  }
};

std::optional<Back>
backOf(const Face& face, const Face& other)
{
  constexpr double min_cosine = 0.99, thinnest = 0.02; // of a wall, metres
  if (face.front.dot(other.front) > -min_cosine)
    return {};
  const Vector2d a = other.from - face.from;
  const Vector2d b = a + other.length * other.along;
  const double from = b.dot(face.along), to = a.dot(face.along);
  const double behind_from = -b.dot(face.front), behind_to = -a.dot(face.front);
  const double slope = (behind_to - behind_from) / (to - from);
  const Back back{std::max(from, 0.0),
                  std::min(to, face.length),
                  behind_from - slope * from,
                  slope};
  if (back.begin >= back.end ||
      std::min(back.at(back.begin), back.at(back.end)) < thinnest ||
      std::max(back.at(back.begin), back.at(back.end)) > thickest_wall)
    return {};
  return back;
}

/** \brief Divides a face by what is behind it. */
std::vector<Part>
partsOf(const Face& face, const std::vector<Face>& faces, double strip)
{
  constexpr double shortest = 1e-6; // metres
  std::vector<Back> backs;
  std::vector<double> ends{0, face.length};
  for (const Face& other : faces)
    if (const auto back = backOf(face, other)) {
      backs.push_back(*back);
      ends.push_back(back->begin);
      ends.push_back(back->end);
    }
  std::sort(ends.begin(), ends.end());
  std::vector<Part> parts;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double middle = (ends[k] + ends[k + 1]) / 2;
    if (ends[k + 1] - ends[k] < shortest)
      continue;
    const Back* nearest = nullptr;
    for (const Back& back : backs)
      if (back.begin <= middle && back.end >= middle &&
          (!nearest || back.at(middle) < nearest->at(middle)))
        nearest = &back;
    if (nearest)
      parts.push_back(
          {ends[k], ends[k + 1], nearest->at(ends[k]), nearest->at(ends[k + 1]), true});
    else
      parts.push_back({ends[k], ends[k + 1], strip, strip, false});
  }
  return parts;
}

/** \brief A face with its parts, which its joints change. */
struct Body {
  Face face;
  std::vector<Part> parts;
  std::vector<WallBody> quads;
};

WallBody
quadOf(const Face& face, const Part& part)
{
  const auto at = [&](double along, double behind) -> Vector2d {
    return face.from + along * face.along - behind * face.front;
  };
  return {{at(part.begin, 0),
           at(part.end, 0),
           at(part.end, part.behind_end),
           at(part.begin, part.behind_begin)},
          face.wall,
          part.is_measured};
}

/** \brief Where two lines meet. */
std::optional<Vector2d>
meetingOf(const Vector2d& a,
          const Vector2d& way_a,
          const Vector2d& b,
          const Vector2d& way_b)
{
  constexpr double min_sine = 0.25;
  const double sine = crossOf(way_a, way_b);
  if (std::abs(sine) < min_sine)
    return {};
  return a + crossOf(b - a, way_b) / sine * way_a;
}

/** \brief Continues the end of one face and the begin of the next one to their corner. */
void
join(Body& one, Body& next)
{
  constexpr double reach = 0.2; // metres, outlines may end before a corner
  WallBody& last = one.quads.back();
  WallBody& first = next.quads.front();
  const auto front =
      meetingOf(last.corners[1], one.face.along, first.corners[0], next.face.along);
  const auto backOfLast = [&](std::size_t line) {
    return meetingOf(last.corners[2],
                     last.corners[2] - last.corners[3],
                     first.corners[line],
                     line == 0 ? next.face.along
                               : Vector2d(first.corners[2] - first.corners[3]));
  };
  const auto backOfFirst = [&](std::size_t line) {
    return meetingOf(first.corners[3],
                     first.corners[2] - first.corners[3],
                     last.corners[line],
                     line == 1 ? one.face.along
                               : Vector2d(last.corners[2] - last.corners[3]));
  };
  // a wall of known thickness ends at the face of one that it abuts
  const bool last_abuts = last.is_measured && !first.is_measured,
             first_abuts = first.is_measured && !last.is_measured;
  const auto last_back = backOfLast(last_abuts ? 0 : 3),
             first_back = backOfFirst(first_abuts ? 1 : 2);
  const auto isNear = [&](const Vector2d& place, const Vector2d& end, double limit) {
    return (place - end).norm() <= limit;
  };
  if (!front || !isNear(*front, last.corners[1], reach) ||
      !isNear(*front, first.corners[0], reach))
    return;
  const double limit = reach + 2 * thickest_wall;
  last.corners[1] = first.corners[0] = *front;
  if (last_back && isNear(*last_back, *front, limit))
    last.corners[2] = *last_back;
  if (first_back && isNear(*first_back, *front, limit))
    first.corners[3] = *first_back;
  if (last_abuts || first_abuts) {
    const Vector2d &end = last.corners[2], &begin = first.corners[3];
    // before the end of the wall, between the strips on both sides of it
    one.quads.push_back(
        {{*front, last_abuts ? end : begin, last_abuts ? begin : end, *front},
         one.face.wall,
         false,
         false});
  }
}

/** \brief The face that begins where another one ends, if there is one. */
Body*
nextOf(const Body& one, std::vector<Body>& bodies)
{
  constexpr double reach = 0.2; // metres
  const Vector2d end = one.face.from + one.face.length * one.face.along;
  Body* nearest = nullptr;
  double least = reach;
  for (Body& other : bodies) {
    const double distance = (other.face.from - end).norm();
    constexpr double min_sine = 0.25;
    if (&other != &one && distance < least &&
        std::abs(crossOf(one.face.along, other.face.along)) > min_sine) {
      least = distance;
      nearest = &other;
    }
  }
  return nearest;
}

} // namespace

std::vector<WallBody>
wallBodiesOf(const FloorPlan& plan, double strip)
{
  const std::vector<Face> faces = facesOf(plan);
  std::vector<Body> bodies;
  for (const Face& face : faces) {
    Body body{face, partsOf(face, faces, strip), {}};
    for (const Part& part : body.parts)
      body.quads.push_back(quadOf(face, part));
    if (!body.quads.empty())
      bodies.push_back(std::move(body));
  }
  for (Body& body : bodies)
    if (Body* const next = nextOf(body, bodies))
      join(body, *next);
  std::vector<WallBody> all;
  for (const Body& body : bodies)
    all.insert(all.end(), body.quads.begin(), body.quads.end());
  return all;
}

} // namespace pcl::acmap
