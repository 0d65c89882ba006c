#include <pcl/core/impl/planar_geometry.h>
#include <pcl/pipeline/surface_names.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace pcl {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// metres above the floor, and shares of the height of a room
constexpr double eye_level = 1.5, head_level = 1.9, up_to_ceiling = 0.85;

constexpr double steepest =
    0.7; // cosine between up and the normal of a ceiling or a top

constexpr double wall_area = 2; // square metres, of a wall that was seen in part

/** \brief Where a plane is, in the frame of a plan; metres, heights above its floor. */
struct PlacedPlane {
  bool is_finite = false;
  Vector3d normal = Vector3d::Zero();
  Vector2d front = Vector2d::Zero(); ///< horizontal part of the normal
  Vector2d center = Vector2d::Zero();
  double facing_up = 0; ///< cosine between normal and up
  double low = 0, high = 0;
  double begin = 0, end = 0; ///< of an upright plane, along its horizontal direction
  Vector2d size = Vector2d::Constant(nan);

  bool
  isUpright() const
  {
    return std::abs(facing_up) < acmap::upright_cosine;
  }

  /** \brief Horizontal direction along an upright plane. */
  Vector2d
  along() const
  {
    return Vector2d(-front.y(), front.x()).normalized();
  }
};

bool
turnsLeft(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
  return (b - a).x() * (c - b).y() - (b - a).y() * (c - b).x() > 0;
}

/** \brief One half of the convex hull of sorted points (Andrew's monotone chain). */
template <typename Iterator>
std::vector<Vector2d>
chainOf(Iterator begin, Iterator end)
{
  std::vector<Vector2d> chain;
  for (; begin != end; ++begin) {
    while (chain.size() >= 2 &&
           !turnsLeft(chain[chain.size() - 2], chain.back(), *begin))
      chain.pop_back();
    chain.push_back(*begin);
  }
  return chain;
}

/** \brief Sides of the smallest rectangle around points, the longer one first; zero without
 * points. */
Vector2d
sidesOfSmallestRectangle(std::vector<Vector2d> points)
{
  if (points.empty())
    return Vector2d::Zero();
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vector2d> hull = chainOf(points.begin(), points.end());
  const std::vector<Vector2d> upper = chainOf(points.rbegin(), points.rend());
  hull.insert(hull.end(), upper.begin(), upper.end());
  Vector2d smallest = Vector2d::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vector2d edge = hull[(k + 1) % hull.size()] - hull[k];
    // a side of the smallest rectangle lies on an edge of the hull
    const Vector2d along = edge.norm() > 0 ? edge.normalized() : Vector2d::UnitX();
    Eigen::AlignedBox2d box;
    for (const Vector2d& corner : hull)
      box.extend(
          Vector2d(corner.dot(along), corner.dot(Vector2d(-along.y(), along.x()))));
    if (box.sizes().prod() < smallest.prod() ||
        (box.sizes().prod() == smallest.prod() && box.sizes().sum() < smallest.sum()))
      smallest = box.sizes();
  }
  return {smallest.maxCoeff(), smallest.minCoeff()};
}

/** \brief "room 1", "rooms 1 and 3", "rooms 1, 2 and 4".
 * \param[in] rooms indices, ascending; not empty */
std::string
namesOf(const std::vector<std::size_t>& rooms)
{
  std::string text = rooms.size() > 1 ? "rooms " : "room ";
  for (std::size_t k = 0; k < rooms.size(); ++k)
    text += (k == 0                  ? ""
             : k + 1 == rooms.size() ? " and "
                                     : ", ") +
            std::to_string(rooms[k] + 1);
  return text;
}

/** \brief "Wall of room 2"; the kind alone where there is no room. */
std::string
nameIn(const std::string& kind,
       const char* relation,
       const std::vector<std::size_t>& rooms)
{
  return rooms.empty() ? kind : kind + " " + relation + " " + namesOf(rooms);
}

class SurfaceNaming {
public:
  SurfaceNaming(const FloorPlan& plan, CompactMap& map)
  : plan_(plan)
  , map_(map)
  , rooms_of_planes_(map.planes.size())
  {
    for (std::size_t room = 0; room < map.rooms.size(); ++room)
      for (const std::int32_t plane : map.rooms[room].planes)
        rooms_of_planes_[static_cast<std::size_t>(plane)].push_back(room);
    for (const PlanePatch& plane : map.planes)
      placed_.push_back(placeOf(plane));
    measureBuilding();
  }

  void
  nameAll()
  {
    for (std::size_t p = 0; p < placed_.size(); ++p)
      map_.planes[p].label = {"", SurfaceRole::Other, placed_[p].size};
    if (is_building_) {
      giveRolesOfParts();
      // what continues a wall or stands before one is known once walls are
      for (std::size_t p = 0; p < placed_.size(); ++p)
        if (isTall(p) && roleOf(p) == SurfaceRole::Other)
          setRole(p, SurfaceRole::Wall);
      for (std::size_t p = 0; p < placed_.size(); ++p)
        if (roleOf(p) == SurfaceRole::Other && placed_[p].is_finite)
          setRole(p, placed_[p].isUpright() ? roleOfUpright(p) : roleOfSlope(p));
    }
    for (std::size_t p = 0; p < placed_.size(); ++p)
      map_.planes[p].label.name = nameOfPlane(p);
    nameCylinders();
    nameBoxes();
    nameRooms();
  }

private:
  PlacedPlane
  placeOf(const PlanePatch& plane) const
  {
    PlacedPlane placed;
    placed.normal = plane.coefficients.head<3>();
    placed.facing_up = placed.normal.dot(plan_.up);
    placed.front = plan_.placeOf(placed.normal);
    placed.center = plan_.placeOf(plane.center);
    const Vector3d side =
        placed.isUpright() ? placed.normal.cross(plan_.up).normalized() : plane.axis_u;
    const Vector3d other = placed.normal.cross(side);
    std::vector<Vector2d> corners;
    Eigen::AlignedBox1d heights, lengths;
    for (const PlanePolygon& polygon : plane.polygons)
      for (const Eigen::Vector3f& corner : polygon.outer) {
        const Vector3d place = corner.cast<double>();
        corners.emplace_back(place.dot(side), place.dot(other));
        heights.extend(Eigen::Matrix<double, 1, 1>(plan_.heightOf(place)));
        lengths.extend(
            Eigen::Matrix<double, 1, 1>(plan_.placeOf(place).dot(placed.along())));
      }
    placed.is_finite = !corners.empty() && plane.coefficients.allFinite() &&
                       std::all_of(corners.begin(), corners.end(), [](const auto& one) {
                         return one.allFinite();
                       });
    if (!placed.is_finite)
      return placed;
    placed.low = heights.min().x();
    placed.high = heights.max().x();
    placed.begin = lengths.min().x();
    placed.end = lengths.max().x();
    placed.size = placed.isUpright()
                      ? Vector2d(placed.end - placed.begin, placed.high - placed.low)
                      : sidesOfSmallestRectangle(std::move(corners));
    return placed;
  }

  /** \brief Extent, height of the rooms, and area of the floor. */
  void
  measureBuilding()
  {
    constexpr double min_extent = 1.5; // metres; less is an object
    Eigen::AlignedBox3d extent;
    double ceiling_area = 0;
    for (std::size_t p = 0; p < placed_.size(); ++p) {
      const PlacedPlane& one = placed_[p];
      if (!one.is_finite)
        continue;
      extent.extend(Vector3d(one.center.x(), one.center.y(), one.low));
      extent.extend(Vector3d(one.center.x(), one.center.y(), one.high));
      if (one.facing_up < -acmap::level_cosine && one.low > head_level &&
          map_.planes[p].area > ceiling_area) {
        ceiling_area = map_.planes[p].area;
        ceiling_ = one.low;
      }
      if (one.facing_up > acmap::level_cosine && std::abs(one.low) <= step)
        floor_area_ = std::max(floor_area_, map_.planes[p].area);
      min_size_ = std::max(min_size_, one.size.maxCoeff());
    }
    is_building_ = !extent.isEmpty() &&
                   std::max(extent.diagonal().norm(), min_size_) >= min_extent;
  }

  SurfaceRole
  roleOf(std::size_t plane) const
  {
    return map_.planes[plane].label.role;
  }

  void
  setRole(std::size_t plane, SurfaceRole role)
  {
    map_.planes[plane].label.role = role;
  }

  /** \brief Roles of the sides of boxes and of the leaves of recesses. */
  void
  giveRolesOfParts()
  {
    for (const BoxPatch& box : map_.boxes) {
      const double height = (box.axes.transpose() * plan_.up).cwiseAbs().dot(box.size);
      const bool is_pillar =
          std::isfinite(ceiling_) && height > up_to_ceiling * ceiling_;
      const bool hangs =
          plan_.heightOf(box.center) - height / 2 > head_level; // as a duct does
      for (const BoxFace& face : box.faces)
        if (!is_pillar && !hangs && face.plane >= 0 &&
            (face.kind == BoxFaceKind::Seen || face.kind == BoxFaceKind::Slanted))
          setRole(static_cast<std::size_t>(face.plane), SurfaceRole::Furniture);
    }
    for (const RecessPatch& recess : map_.recesses)
      if (recess.leaf >= 0 && recess.reaches_floor)
        setRole(static_cast<std::size_t>(recess.leaf), SurfaceRole::DoorLeaf);
  }

  /** \brief Is an upright plane as high as a wall? The sides of ducts, which hang from the
   * ceiling, are not, unless they are large. */
  bool
  isTall(std::size_t plane) const
  {
    constexpr double min_area = 0.5, min_width = 0.25; // square metres, metres
    const PlacedPlane& one = placed_[plane];
    const double area = map_.planes[plane].area;
    if (!one.is_finite || !one.isUpright())
      return false;
    if (plan_.floors.empty())
      return one.high - one.low >= eye_level && area >= 2 * min_area;
    const double enough =
        std::isfinite(ceiling_) ? up_to_ceiling * ceiling_ : head_level;
    if (one.high < enough)
      return false;
    return one.low > head_level ? area >= wall_area
                                : area >= min_area || one.size.x() >= min_width;
  }

  /** \brief Does some wall fulfil a condition? */
  template <typename Condition>
  bool
  hasWall(const Condition& condition) const
  {
    for (std::size_t p = 0; p < placed_.size(); ++p)
      if (roleOf(p) == SurfaceRole::Wall && condition(placed_[p]))
        return true;
    return false;
  }

  /** \brief Is a plane in the plane of a wall? */
  bool
  continuesWall(const PlacedPlane& one) const
  {
    constexpr double min_cosine = 0.996, max_offset = 0.05; // 5 degrees, metres
    return hasWall([&](const PlacedPlane& wall) {
      return one.normal.dot(wall.normal) > min_cosine &&
             std::abs((one.center - wall.center).dot(wall.front.normalized())) <
                 max_offset;
    });
  }

  /** \brief Is a plane in front of another one that faces the same side, as the front of a
   * cupboard is in front of a wall? */
  static bool
  isBefore(const PlacedPlane& one, const PlacedPlane& other)
  {
    constexpr double min_cosine = 0.95, nearest = 0.08, farthest = 1.2, slack = 0.1;
    const double before = (one.center - other.center).dot(other.front.normalized());
    const double place = one.center.dot(other.along());
    return one.normal.dot(other.normal) > min_cosine && before > nearest &&
           before < farthest && place > other.begin - slack &&
           place < other.end + slack;
  }

  bool
  standsBeforeWall(const PlacedPlane& one) const
  {
    return hasWall([&](const PlacedPlane& wall) { return isBefore(one, wall); });
  }

  /** \brief Is an upright plane the last one behind furniture, as far as was seen? Walls are
   * hidden below, and often not seen above. */
  bool
  isBehindFurniture(const PlacedPlane& one) const
  {
    constexpr double above_worktops = 1.15; // metres
    bool has_furniture = false, is_last = true;
    for (const PlacedPlane& other : placed_) {
      if (!other.is_finite || !other.isUpright())
        continue;
      has_furniture = has_furniture || isBefore(other, one);
      is_last = is_last && !isBefore(one, other);
    }
    return one.high > above_worktops && has_furniture && is_last;
  }

  /** \brief Has an upright plane the size of a door, and is a side of it at the side of one? */
  bool
  isOpenDoor(const PlacedPlane& one) const
  {
    constexpr double narrowest = 0.55, widest = 1.25, lowest = 1.8, highest = 2.3,
                     above_floor = 0.3, slack = 0.2;
    if (one.size.x() < narrowest || one.size.x() > widest || one.high < lowest ||
        one.high > highest || one.low > above_floor)
      return false;
    const double depth = one.center.dot(one.front.normalized());
    const Vector2d hinges[] = {depth * one.front.normalized() + one.begin * one.along(),
                               depth * one.front.normalized() + one.end * one.along()};
    return std::any_of(
        map_.openings.begin(), map_.openings.end(), [&](const MapOpening& opening) {
          for (const Vector2d& hinge : hinges)
            for (const Vector3d& side : {opening.from, opening.to})
              if (opening.kind == OpeningKind::Door &&
                  (plan_.placeOf(side) - hinge).norm() < slack)
                return true;
          return false;
        });
  }

  /** \brief The role of an upright plane that is not as high as a wall. */
  SurfaceRole
  roleOfUpright(std::size_t plane) const
  {
    const PlacedPlane& one = placed_[plane];
    if (plan_.floors.empty())
      return SurfaceRole::Other;
    if (isOpenDoor(one))
      return SurfaceRole::DoorLeaf;
    if (continuesWall(one))
      return SurfaceRole::Wall;
    if (one.low < head_level && standsBeforeWall(one))
      return SurfaceRole::Furniture;
    if (one.high > eye_level && one.low < head_level &&
        (map_.planes[plane].area >= wall_area || one.high > head_level))
      return SurfaceRole::Wall;
    if (isBehindFurniture(one))
      return SurfaceRole::Wall;
    return one.high < head_level && !plan_.rooms.empty() ? SurfaceRole::Furniture
                                                         : SurfaceRole::Other;
  }

  SurfaceRole
  roleOfSlope(std::size_t plane) const
  {
    constexpr double small = 0.12, min_area = 0.5; // metres, square metres
    if (plan_.floors.empty())
      return SurfaceRole::Other;
    const PlacedPlane& one = placed_[plane];
    const double area = map_.planes[plane].area;
    const bool is_level = std::abs(one.facing_up) > acmap::level_cosine;
    const double top = std::isfinite(ceiling_) ? up_to_ceiling * ceiling_
                                               : std::max(head_level, one.low);
    if (one.facing_up > 0) {
      if (is_level && (std::abs(one.low) <= small ||
                       (std::abs(one.low) <= step && area >= 2 * min_area)))
        return SurfaceRole::Floor;
      if (is_level && std::abs(one.low) > head_level && area >= floor_area_ / 2)
        return SurfaceRole::Floor;
      return one.low >= 0 && one.high < top && one.low < head_level &&
                     !plan_.rooms.empty()
                 ? SurfaceRole::Furniture
                 : SurfaceRole::Other;
    }
    if (one.low >= head_level && area >= min_area && one.facing_up < -steepest)
      return SurfaceRole::Ceiling;
    return one.high < head_level && one.low > 0 && !plan_.rooms.empty()
               ? SurfaceRole::Furniture
               : SurfaceRole::Other;
  }

  std::vector<std::size_t>
  roomsAt(const Vector2d& place) const
  {
    for (std::size_t room = 0; room < plan_.rooms.size(); ++room)
      if (acmap::isInside(plan_.rooms[room].outline, place))
        return {room};
    return {};
  }

  /** \brief The rooms that a plane bounds, or the one in which it stands. */
  std::vector<std::size_t>
  roomsAt(std::size_t plane) const
  {
    if (!rooms_of_planes_[plane].empty())
      return rooms_of_planes_[plane];
    const PlacedPlane& one = placed_[plane];
    if (!one.isUpright())
      return roomsAt(one.center);
    constexpr double reach = 0.1; // metres; the outline may pass through the plane
    return roomsAt(Vector2d(one.center + reach * one.front.normalized()));
  }

  std::string
  nameOfPlane(std::size_t plane) const
  {
    const PlacedPlane& one = placed_[plane];
    const std::vector<std::size_t> rooms =
        one.is_finite ? roomsAt(plane) : std::vector<std::size_t>();
    switch (roleOf(plane)) {
    case SurfaceRole::Floor:
      return nameIn("Floor", "of", rooms);
    case SurfaceRole::Ceiling:
      return nameIn("Ceiling", "of", rooms);
    case SurfaceRole::Wall:
      return nameIn("Wall", "of", rooms);
    case SurfaceRole::DoorLeaf:
      return nameIn("Door leaf", "of", rooms);
    case SurfaceRole::Furniture:
      return nameIn(std::abs(one.facing_up) < steepest ? "Side of furniture"
                    : one.facing_up > 0                ? "Top of furniture"
                                                       : "Underside of furniture",
                    "in",
                    rooms);
    case SurfaceRole::Other:
      break;
    }
    return nameIn("Surface", "in", rooms);
  }

  void
  nameCylinders()
  {
    for (CylinderPatch& cylinder : map_.cylinders) {
      cylinder.label = {
          nameIn(kindOf(cylinder), "in", roomsAt(plan_.placeOf(cylinder.axis_point))),
          SurfaceRole::Other,
          {2 * cylinder.radius, cylinder.high - cylinder.low}};
    }
  }

  const char*
  kindOf(const CylinderPatch& cylinder) const
  {
    constexpr double pipe = 0.08, column = 0.6, min_height = 1; // radii, metres
    const bool is_column =
        std::abs(cylinder.axis_direction.dot(plan_.up)) > acmap::level_cosine &&
        cylinder.high - cylinder.low > min_height;
    if (!is_building_ || plan_.floors.empty())
      return "Cylinder";
    if (cylinder.is_hollow)
      return is_column ? "Curved wall" : "Curved surface";
    if (cylinder.radius < pipe)
      return "Pipe";
    return is_column && cylinder.radius < column ? "Column" : "Curved surface";
  }

  void
  nameBoxes()
  {
    for (BoxPatch& box : map_.boxes)
      box.name = nameIn("Box", "in", roomsAt(plan_.placeOf(box.center)));
    for (RecessPatch& recess : map_.recesses)
      recess.name =
          nameIn(recess.reaches_floor ? "Closed door" : "Recess",
                 "of",
                 recess.wall >= 0 ? roomsAt(static_cast<std::size_t>(recess.wall))
                                  : std::vector<std::size_t>());
  }

  void
  nameRooms()
  {
    for (std::size_t room = 0; room < map_.rooms.size(); ++room)
      map_.rooms[room].label = {"Room " + std::to_string(room + 1),
                                SurfaceRole::Other,
                                sidesOfSmallestRectangle(plan_.rooms[room].outline)};
    for (MapOpening& opening : map_.openings) {
      std::vector<std::size_t> rooms;
      for (const std::int32_t room : opening.rooms)
        if (room >= 0)
          rooms.push_back(static_cast<std::size_t>(room));
      std::sort(rooms.begin(), rooms.end());
      rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
      opening.label = {
          nameIn(opening.kind == OpeningKind::Window ? "Window" : "Door",
                 rooms.size() > 1 ? "between" : "of",
                 rooms),
          SurfaceRole::Other,
          {(opening.to - opening.from).norm(), opening.top - opening.bottom}};
    }
  }

  static constexpr double step = 0.3; // metres, as for floors of a plan

  const FloorPlan& plan_;
  CompactMap& map_;
  std::vector<std::vector<std::size_t>> rooms_of_planes_;
  std::vector<PlacedPlane> placed_;
  bool is_building_ = false;
  double ceiling_ = nan; ///< height of the largest ceiling
  double floor_area_ = 0, min_size_ = 0;
};

} // namespace

void
nameSurfaces(const FloorPlan& plan, CompactMap& map)
{
  SurfaceNaming(plan, map).nameAll();
}

FloorPlan
nameParts(CompactMap& map)
{
  FloorPlan plan = makeFloorPlan(map);
  setRooms(plan, map);
  nameSurfaces(plan, map);
  return plan;
}

} // namespace pcl
