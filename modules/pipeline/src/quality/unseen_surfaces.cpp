#include "quality/plan_places.h"
#include "quality/seen_faces.h"

#include <pcl/pipeline/unseen_surfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double finest = 0.2, default_height = 2.5; // metres
constexpr double max_patches = 60000;

/** \brief Asks the squares of the rooms of a plan. */
class UnseenFinder {
public:
  UnseenFinder(const CompactMap& map, const FloorPlan& plan)
  : plan_(plan)
  {
    constexpr double down = -0.7, upright = 0.5; // cosines
    for (const PlanePatch& plane : map.planes) {
      const double cosine = plane.coefficients.head<3>().dot(plan.up);
      if (cosine < down)
        ceilings_.emplace_back(plane);
      else if (std::abs(cosine) < upright)
        walls_.emplace_back(plane);
    }
    for (const PlanRoom& room : plan.rooms)
      heights_.push_back(heightOf(map, room.planes));
    std::vector<std::size_t> all(map.planes.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] = k;
    const double otherwise = heightOf(map, all).value_or(default_height);
    for (auto& height : heights_)
      height = height.value_or(otherwise);
    for (const MapOpening& opening : map.openings)
      openings_.push_back(&opening);
  }

  UnseenSurfaces
  find()
  {
    found_.patch_size = patchSize();
    for (std::size_t room = 0; room < plan_.rooms.size(); ++room) {
      addLevel(room);
      addWalls(room);
    }
    return std::move(found_);
  }

private:
  /** \brief Mean height of the ceilings among these planes. */
  std::optional<double>
  heightOf(const CompactMap& map, const std::vector<std::size_t>& planes) const
  {
    double sum = 0, area = 0;
    for (const std::size_t plane : planes)
      if (const PlanePatch& one = map.planes.at(plane);
          one.label.role == SurfaceRole::Ceiling && one.area > 0) {
        sum += one.area * plan_.heightOf(one.center);
        area += one.area;
      }
    constexpr double lowest = 1.5; // metres
    return area > 0 && sum > lowest * area ? std::optional(sum / area) : std::nullopt;
  }

  double
  patchSize() const
  {
    constexpr double max_squares = 4e6; // of the rectangles around the rooms
    double area = 0, around = 0;
    for (std::size_t room = 0; room < plan_.rooms.size(); ++room) {
      const std::vector<Vector2d>& outline = plan_.rooms[room].outline;
      area += 2 * plan_.rooms[room].area + *heights_[room] * lengthOf(outline);
      Eigen::AlignedBox2d box;
      for (const Vector2d& corner : outline)
        box.extend(corner);
      around += box.isEmpty() ? 0 : box.volume();
    }
    return std::max(
        {finest, std::sqrt(area / max_patches), std::sqrt(around / max_squares)});
  }

  static double
  lengthOf(const std::vector<Vector2d>& outline)
  {
    double length = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
      length += (outline[(k + 1) % outline.size()] - outline[k]).norm();
    return length;
  }

  void
  add(bool is_seen,
      const Vector3d& center,
      const Vector3d& normal,
      double area,
      SurfaceRole role,
      std::size_t room,
      bool is_open = false)
  {
    (is_seen ? found_.seen_area : found_.unseen_area) += area;
    if (!is_seen)
      found_.patches.push_back(
          {center, normal, area, role, static_cast<std::int32_t>(room), is_open});
  }

  /** \brief Asks floor and ceiling of a room. */
  void
  addLevel(std::size_t room)
  {
    const std::vector<Vector2d>& outline = plan_.rooms[room].outline;
    const double size = found_.patch_size, height = *heights_[room];
    Eigen::AlignedBox2d box;
    for (const Vector2d& corner : outline)
      box.extend(corner);
    if (box.isEmpty())
      return;
    for (double y = box.min().y() + size / 2; y < box.max().y(); y += size)
      for (double x = box.min().x() + size / 2; x < box.max().x(); x += size) {
        const Vector2d place(x, y);
        if (!acmap::isInside(outline, place))
          continue;
        if (!isUnderFurniture(place))
          add(isFloorSeen(place),
              plan_.pointAt(place, 0),
              plan_.up,
              size * size,
              SurfaceRole::Floor,
              room);
        const Vector3d above = plan_.pointAt(place, height);
        add(isCeilingSeen(above),
            above,
            -plan_.up,
            size * size,
            SurfaceRole::Ceiling,
            room);
      }
  }

  bool
  isUnderFurniture(const Vector2d& place) const
  {
    return std::any_of(
        plan_.furniture.begin(), plan_.furniture.end(), [&](const PlanFurniture& one) {
          return acmap::isInside(one.outline, place);
        });
  }

  bool
  isFloorSeen(const Vector2d& place) const
  {
    return std::any_of(
        plan_.floors.begin(), plan_.floors.end(), [&](const auto& loops) {
          return acmap::isInside(loops, place);
        });
  }

  bool
  isCeilingSeen(const Vector3d& point) const
  {
    constexpr double reach = 1; // metres: ducts and lintels hide it
    return std::any_of(
        ceilings_.begin(), ceilings_.end(), [&](const acmap::SeenFace& face) {
          return std::abs(face.distanceTo(point)) < reach && face.covers(point);
        });
  }

  bool
  isWallSeen(const Vector3d& point, const Vector3d& inwards) const
  {
    constexpr double reach = 0.35, min_cosine = 0.5; // metres
    return std::any_of(walls_.begin(), walls_.end(), [&](const acmap::SeenFace& face) {
      return std::abs(face.distanceTo(point)) < reach &&
             std::abs(face.normal().dot(inwards)) > min_cosine && face.covers(point);
    });
  }

  /** \brief Does furniture stand directly in front of a place of a wall? */
  bool
  isBehindFurniture(const Vector2d& place, double height) const
  {
    constexpr double near = 0.35; // metres
    return std::any_of(
        plan_.furniture.begin(), plan_.furniture.end(), [&](const PlanFurniture& one) {
          return height < one.top && (acmap::isInside(one.outline, place) ||
                                      acmap::distanceToLoop(one.outline, place) < near);
        });
  }

  bool
  isInOpening(const Vector2d& place, double height) const
  {
    constexpr double near = 0.4, usual_top = 2.1, margin = 0.1; // metres
    for (const MapOpening* opening : openings_) {
      const double top = std::isfinite(opening->top) ? opening->top : usual_top;
      if (height > opening->bottom - margin && height < top + margin &&
          acmap::distanceToSegment(
              plan_.placeOf(opening->from), plan_.placeOf(opening->to), place) < near)
        return true;
    }
    return false;
  }

  bool
  isAtColumn(const Vector2d& place) const
  {
    constexpr double near = 0.3; // metres
    return std::any_of(
        plan_.columns.begin(), plan_.columns.end(), [&](const PlanColumn& column) {
          return std::abs((place - column.center).norm() - column.radius) < near;
        });
  }

  /** \brief Is neither a wall nor what stands for one near? */
  bool
  isOpen(const Vector2d& place) const
  {
    constexpr double near = 0.4; // metres
    const auto isNear = [&](const auto& line) {
      return acmap::distanceToSegment(line.from, line.to, place) < near;
    };
    return std::none_of(plan_.walls.begin(), plan_.walls.end(), isNear) &&
           std::none_of(plan_.unseen_walls.begin(), plan_.unseen_walls.end(), isNear) &&
           std::none_of(plan_.openings.begin(), plan_.openings.end(), isNear);
  }

  void
  addWalls(std::size_t room)
  {
    const std::vector<Vector2d>& outline = plan_.rooms[room].outline;
    const double height = *heights_[room];
    const auto rows =
        std::max(1, static_cast<int>(std::lround(height / found_.patch_size)));
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vector2d way = outline[(k + 1) % outline.size()] - outline[k];
      const auto columns =
          std::max(1, static_cast<int>(std::lround(way.norm() / found_.patch_size)));
      const double area = way.norm() / columns * height / rows;
      if (!(area > 0))
        continue;
      // counter-clockwise: the room is on the left
      const Vector2d left = Vector2d(-way.y(), way.x()).normalized();
      const Vector3d inwards = left.x() * plan_.x_axis + left.y() * plan_.y_axis;
      for (int column = 0; column < columns; ++column) {
        const Vector2d place = outline[k] + (column + 0.5) / columns * way;
        if (isAtColumn(place))
          continue;
        const bool is_open = isOpen(place);
        for (int row = 0; row < rows; ++row) {
          const double at = (row + 0.5) / rows * height;
          if (isInOpening(place, at))
            continue;
          const Vector3d point = plan_.pointAt(place, at);
          const bool is_seen = isWallSeen(point, inwards);
          if (is_seen || !isBehindFurniture(place, at))
            add(is_seen, point, inwards, area, SurfaceRole::Wall, room, is_open);
        }
      }
    }
  }

  const FloorPlan& plan_;
  std::vector<acmap::SeenFace> ceilings_, walls_;
  std::vector<std::optional<double>> heights_;
  std::vector<const MapOpening*> openings_;
  UnseenSurfaces found_;
};

} // namespace

UnseenSurfaces
findUnseenSurfaces(const CompactMap& map, const FloorPlan& plan)
{
  return UnseenFinder(map, plan).find();
}

} // namespace pcl
