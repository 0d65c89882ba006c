#include "guard_buildings.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

/** \brief The floor of a building as a union of rectangles along the axes; its walls are
 * the outline of the union. */
class FreeSpace {
public:
  /** \brief Adds a rectangle between two opposite corners, metres. */
  void
  add(double x0, double z0, double x1, double z1);

  /** \brief Adds a rectangle about a line along one of the axes. */
  void
  addAround(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double half_width);

  std::vector<BuildingWall>
  outline() const;

private:
  struct Rectangle {
    double low[2], high[2];
  };

  /** Adds the walls perpendicular to an axis. */
  void
  addOutline(int axis, std::vector<BuildingWall>& walls) const;

  std::vector<double>
  limitsAlong(int axis) const;

  bool
  contains(const Eigen::Vector2d& place) const;

  std::vector<Rectangle> rectangles_;
};

void
FreeSpace::add(double x0, double z0, double x1, double z1)
{
  rectangles_.push_back(
      {{std::min(x0, x1), std::min(z0, z1)}, {std::max(x0, x1), std::max(z0, z1)}});
}

void
FreeSpace::addAround(const Eigen::Vector2d& from,
                     const Eigen::Vector2d& to,
                     double half_width)
{
  const Eigen::Vector2d margin(half_width, half_width);
  const Eigen::Vector2d low = from.cwiseMin(to) - margin;
  const Eigen::Vector2d high = from.cwiseMax(to) + margin;
  add(low[0], low[1], high[0], high[1]);
}

std::vector<double>
FreeSpace::limitsAlong(int axis) const
{
  std::vector<double> limits;
  for (const Rectangle& one : rectangles_) {
    limits.push_back(one.low[axis]);
    limits.push_back(one.high[axis]);
  }
  std::sort(limits.begin(), limits.end());
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  return limits;
}

bool
FreeSpace::contains(const Eigen::Vector2d& place) const
{
  return std::any_of(rectangles_.begin(), rectangles_.end(), [&](const Rectangle& one) {
    return place[0] > one.low[0] && place[0] < one.high[0] && place[1] > one.low[1] &&
           place[1] < one.high[1];
  });
}

void
FreeSpace::addOutline(int axis, std::vector<BuildingWall>& walls) const
{
  const std::vector<double> across = limitsAlong(axis);
  const std::vector<double> along = limitsAlong(1 - axis);
  constexpr double aside = 1e-4; // metres
  for (const double at : across) {
    bool continues = false;
    for (std::size_t i = 1; i < along.size(); ++i) {
      Eigen::Vector2d place;
      place[1 - axis] = (along[i - 1] + along[i]) / 2;
      place[axis] = at - aside;
      const bool before = contains(place);
      place[axis] = at + aside;
      const bool is_wall = before != contains(place);
      if (is_wall && continues)
        walls.back().to[1 - axis] = along[i];
      else if (is_wall) {
        BuildingWall wall;
        wall.from[axis] = wall.to[axis] = at;
        wall.from[1 - axis] = along[i - 1];
        wall.to[1 - axis] = along[i];
        walls.push_back(wall);
      }
      continues = is_wall;
    }
  }
}

std::vector<BuildingWall>
FreeSpace::outline() const
{
  std::vector<BuildingWall> walls;
  addOutline(0, walls);
  addOutline(1, walls);
  return walls;
}

/** Adds walls between consecutive corners. */
void
addWallsThrough(const std::vector<Eigen::Vector2d>& corners,
                std::vector<BuildingWall>& walls)
{
  for (std::size_t i = 1; i < corners.size(); ++i)
    walls.push_back({corners[i - 1], corners[i]});
}

/** Poses through corners, facing in the direction of motion; the robot turns in place, at
 * most 0.7 rad from scan to scan. \param[in] step metres */
std::vector<PlanarPose>
drive(const std::vector<Eigen::Vector2d>& corners, double step)
{
  constexpr double turn = 0.7; // radians
  std::vector<PlanarPose> path;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d leg = corners[i] - corners[i - 1];
    if (leg.norm() < 1e-6)
      continue;
    const double heading = std::atan2(leg[0], leg[1]);
    if (!path.empty()) {
      const double left = std::remainder(heading - path.back().theta, 2 * M_PI);
      const int turns = static_cast<int>(std::abs(left) / turn);
      const PlanarPose last = path.back();
      for (int k = 1; k <= turns; ++k)
        path.push_back({last.x, last.z, last.theta + left * k / (turns + 1)});
    }
    const int steps = std::max(1, static_cast<int>(std::lround(leg.norm() / step)));
    for (int k = path.empty() ? 0 : 1; k <= steps; ++k) {
      const Eigen::Vector2d place = corners[i - 1] + leg * k / steps;
      path.push_back({place[0], place[1], heading});
    }
  }
  return path;
}

using Corners = std::vector<Eigen::Vector2d>;

int
wholeBetween(Random& random, int minimum, int maximum)
{
  return minimum + static_cast<int>(random.uniform(0, maximum - minimum + 1 - 1e-9));
}

bool
isTrue(Random& random, double probability)
{
  return random.uniform() < probability;
}

double
reachOf(Random& random)
{
  constexpr double reaches[] = {8, 12, 20, 30};
  return reaches[wholeBetween(random, 0, 3)];
}

Building
buildingOf(const FreeSpace& space, std::vector<PlanarPose> path, Random& random)
{
  return {space.outline(), std::move(path), reachOf(random)};
}

/** A room beside a corridor. */
struct SideRoom {
  double from, to, depth; ///< metres; from and to along the corridor
  double door;            ///< centre of the door, along the corridor
  double side;            ///< -1 left, 1 right
};

/** A corridor along z that begins at a place, with rooms on its sides. */
struct RoomedCorridor {
  Eigen::Vector2d begin{0, 0};
  double length = 20, half_width = 1, wall = 0.15; ///< metres
  std::vector<SideRoom> rooms;

  Eigen::Vector2d
  at(double along, double aside) const
  {
    return begin + Eigen::Vector2d(aside, along);
  }

  void
  addTo(FreeSpace& space) const
  {
    space.addAround(at(half_width, 0), at(length - half_width, 0), half_width);
    for (const SideRoom& room : rooms) {
      const double near = room.side * (half_width + wall);
      const double far = near + room.side * room.depth;
      const Eigen::Vector2d a = at(room.from, near), b = at(room.to, far);
      space.add(a[0], a[1], b[0], b[1]);
      const Eigen::Vector2d c = at(room.door - 0.5, room.side * (half_width - 0.1));
      const Eigen::Vector2d d = at(room.door + 0.5, near + 0.1 * room.side);
      space.add(c[0], c[1], d[0], d[1]);
    }
  }

  /** A visit of a room, from the corridor and back to it. */
  void
  visit(const SideRoom& room, double share, Corners& way) const
  {
    const double inside = room.side * (half_width + wall + share * room.depth);
    way.push_back(at(room.door, 0));
    way.push_back(at(room.door, inside));
    way.push_back(at(room.door, 0));
  }
};

void
addRooms(RoomedCorridor& corridor, double minimum, double maximum, Random& random)
{
  for (const double side : {-1.0, 1.0}) {
    double from = 0.2;
    for (;;) {
      const double to = from + random.uniform(minimum, maximum);
      if (to > corridor.length)
        break;
      const double door = random.uniform(from + 0.7, to - 0.7);
      corridor.rooms.push_back({from, to, random.uniform(2.5, 5), door, side});
      from = to + 0.15;
    }
  }
}

/** Visits some rooms in the order of their doors, then goes back part of the way. */
Corners
tourOf(const RoomedCorridor& corridor, int visits, Random& random)
{
  std::vector<SideRoom> rooms = corridor.rooms;
  while (static_cast<int>(rooms.size()) > visits)
    rooms.erase(rooms.begin() +
                wholeBetween(random, 0, static_cast<int>(rooms.size()) - 1));
  std::sort(rooms.begin(), rooms.end(), [](const SideRoom& a, const SideRoom& b) {
    return a.door < b.door;
  });
  Corners way{corridor.at(0.6, 0)};
  for (const SideRoom& room : rooms)
    corridor.visit(room, random.uniform(0.3, 0.7), way);
  way.push_back(corridor.at(corridor.length - 1, 0));
  way.push_back(corridor.at(corridor.length * random.uniform(0.1, 0.7), 0));
  return way;
}

/** Adds niches, such as doors, to a corridor along an axis. */
void
addNiches(FreeSpace& space,
          const Eigen::Vector2d& from,
          const Eigen::Vector2d& to,
          double half_width,
          Random& random)
{
  constexpr double per_metre = 0.02;
  const Eigen::Vector2d leg = to - from, along = leg.normalized();
  const Eigen::Vector2d aside(along[1], -along[0]);
  const int niches = static_cast<int>(std::lround(per_metre * leg.norm()));
  for (int i = 0; i < niches; ++i) {
    const double at = random.uniform(1, std::max(1.1, leg.norm() - 1));
    const double side = isTrue(random, 0.5) ? 1 : -1;
    const double depth = random.uniform(0.1, 0.6), half = random.uniform(0.3, 0.8);
    const Eigen::Vector2d a =
        from + (at - half) * along + side * half_width * 0.9 * aside;
    const Eigen::Vector2d b =
        from + (at + half) * along + side * (half_width + depth) * aside;
    space.add(a[0], a[1], b[0], b[1]);
  }
}

void
addBox(const Eigen::Vector2d& middle,
       const Eigen::Vector2d& half,
       WallTime time,
       std::vector<BuildingWall>& walls)
{
  const std::size_t first = walls.size();
  const Eigen::Vector2d low = middle - half, high = middle + half;
  addWallsThrough({low, {high[0], low[1]}, high, {low[0], high[1]}, low}, walls);
  for (std::size_t i = first; i < walls.size(); ++i)
    walls[i].time = time;
}

Building
makeHall(Random& random)
{
  const double x = random.uniform(14, 24), z = random.uniform(12, 20);
  Building building;
  addWallsThrough({{0, 0}, {x, 0}, {x, z}, {0, z}, {0, 0}}, building.walls);
  const double pitch = random.uniform(4, 6), half = random.uniform(0.15, 0.35);
  const bool is_round = isTrue(random, 0.5);
  for (double at_x = pitch; at_x < x - 1.5; at_x += pitch)
    for (double at_z = pitch; at_z < z - 1.5; at_z += pitch) {
      if (!is_round) {
        addBox({at_x, at_z}, {half, half}, WallTime::Always, building.walls);
        continue;
      }
      Corners corners;
      for (int i = 0; i <= 12; ++i)
        corners.emplace_back(at_x + half * std::cos(i * M_PI / 6),
                             at_z + half * std::sin(i * M_PI / 6));
      addWallsThrough(corners, building.walls);
    }
  const double a = pitch / 2;
  building.path =
      drive({{a, a}, {a, z - a}, {x - a, z - a}, {x - a, a}, {a, a}, {a, z / 2}},
            random.uniform(0.7, 1.1));
  building.reach = random.uniform(6, 14);
  return building;
}

/** Corridors without doors, with a bend or two. */
Building
makeBlank(Random& random)
{
  const double z = random.uniform(20, 35), x = random.uniform(6, 14);
  const int bends = wholeBetween(random, 0, 2);
  Corners line{{0, 0}, {0, z}};
  if (bends > 0)
    line.emplace_back(x, z);
  if (bends > 1)
    line.emplace_back(x, z / 3);
  const double half_width = random.uniform(0.8, 1.4);
  FreeSpace space;
  for (std::size_t i = 1; i < line.size(); ++i) {
    space.addAround(line[i - 1], line[i], half_width);
    addNiches(space, line[i - 1], line[i], half_width, random);
  }
  return buildingOf(space, drive(line, random.uniform(0.6, 0.9)), random);
}

Building
makeWarehouse(Random& random)
{
  const int aisles = wholeBetween(random, 3, 5);
  const double length = random.uniform(8, 13), aisle = random.uniform(1.8, 2.6);
  const double shelf = random.uniform(0.8, 1.4), cross = 2.2;
  const double x = aisles * aisle + (aisles - 1) * shelf;
  Building building;
  addWallsThrough(
      {{0, 0}, {x, 0}, {x, length + 2 * cross}, {0, length + 2 * cross}, {0, 0}},
      building.walls);
  Corners way;
  for (int i = 0; i < aisles; ++i) {
    const double at = aisle / 2 + i * (aisle + shelf);
    if (i > 0)
      addBox({at - (aisle + shelf) / 2, cross + length / 2},
             {shelf / 2, length / 2},
             WallTime::Always,
             building.walls);
    const double ends[2] = {cross / 2, length + 1.5 * cross};
    way.emplace_back(at, ends[i % 2]);
    way.emplace_back(at, ends[1 - i % 2]);
  }
  way.emplace_back(aisle / 2, way.back()[1]);
  building.path = drive(way, random.uniform(0.8, 1.1));
  building.reach = reachOf(random);
  return building;
}

/** A corridor around a round court, with pillars along its outer wall. */
Building
makeCurved(Random& random)
{
  constexpr int sides = 72;
  const double radius = random.uniform(4.5, 8), width = random.uniform(1.8, 2.6);
  const double flat = random.uniform(0.7, 1);
  Building building;
  Corners inner, outer, way;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    const Eigen::Vector2d out(std::cos(angle), flat * std::sin(angle));
    inner.emplace_back((radius - width / 2) * out);
    outer.emplace_back((radius + width / 2) * out);
    if (i < sides && isTrue(random, 0.12))
      addBox(outer.back(), {0.2, 0.2}, WallTime::Always, building.walls);
  }
  addWallsThrough(inner, building.walls);
  addWallsThrough(outer, building.walls);
  const double end = 2 * M_PI * random.uniform(0.9, 1.4), step = 0.7 / radius;
  for (double angle = 0; angle < end; angle += step)
    building.path.push_back({radius * std::cos(angle),
                             radius * flat * std::sin(angle),
                             std::atan2(-std::sin(angle), flat * std::cos(angle))});
  building.reach = reachOf(random);
  return building;
}

/** Equal wings with equal rooms beside a corridor. */
Building
makeWings(Random& random)
{
  const int wings = wholeBetween(random, 2, 3);
  const double pitch = random.uniform(9, 12), length = random.uniform(7, 9);
  const double depth = random.uniform(2.5, 3), width = random.uniform(3, 3.4);
  FreeSpace space;
  Corners way{{-1, 0}};
  space.add(-2, -1, (wings - 1) * pitch + 2, 1);
  for (int i = 0; i < wings; ++i) {
    RoomedCorridor wing;
    wing.begin = {i * pitch, 0.5};
    wing.length = length;
    for (const double side : {-1.0, 1.0})
      for (const double from : {1.2, 1.35 + width})
        wing.rooms.push_back({from, from + width, depth, from + width / 2, side});
    wing.addTo(space);
    way.emplace_back(i * pitch, 0);
    wing.visit(
        wing.rooms[static_cast<std::size_t>(wholeBetween(random, 0, 3))], .5, way);
    way.emplace_back(i * pitch, length - 1);
    way.emplace_back(i * pitch, 0);
  }
  way.emplace_back(0, 0);
  return buildingOf(space, drive(way, random.uniform(0.8, 1.1)), random);
}

/** Rooms that are visited twice, with other furniture at the second time. */
Building
makeMoved(Random& random)
{
  RoomedCorridor corridor;
  corridor.length = random.uniform(9, 13);
  addRooms(corridor, 3, 5, random);
  FreeSpace space;
  corridor.addTo(space);
  Building building;
  Corners way = tourOf(corridor, 3, random);
  const Corners again = way;
  way.insert(way.end(), again.begin(), again.end());
  building.walls = space.outline();
  building.path = drive(way, random.uniform(0.8, 1.1));
  building.reach = reachOf(random);
  addFurniture(building, wholeBetween(random, 5, 10), false, random);
  addFurniture(building, wholeBetween(random, 15, 30), true, random);
  return building;
}

/** Exactly equal corridors without rooms beside a spine, each of them visited. */
Building
makeEqualCorridors(Random& random)
{
  const int corridors = wholeBetween(random, 3, 6);
  const double pitch = random.uniform(4, 9), length = random.uniform(6, 12);
  const double half_width = random.uniform(0.8, 1.2);
  FreeSpace space;
  space.add(-2, -half_width, (corridors - 1) * pitch + 2, half_width);
  Corners way{{-1, 0}};
  for (int i = 0; i < corridors; ++i) {
    const double x = i * pitch;
    space.add(x - half_width, 0, x + half_width, length);
    way.emplace_back(x, 0);
    way.emplace_back(x, length - 1);
    way.emplace_back(x, 0);
  }
  if (isTrue(random, 0.5))
    way.emplace_back(-1, 0);
  return buildingOf(space, drive(way, random.uniform(0.7, 1.1)), random);
}

/** Exactly equal rooms on one or both sides of a corridor, each of them visited. */
Building
makeEqualRooms(Random& random)
{
  const int rooms = wholeBetween(random, 3, 5);
  const double width = random.uniform(3, 4.5), depth = random.uniform(3, 4.5);
  const bool has_two_sides = isTrue(random, 0.5);
  RoomedCorridor corridor;
  corridor.length = 0.4 + rooms * (width + 0.15);
  for (int i = 0; i < rooms; ++i)
    for (const double side : {-1.0, 1.0})
      if (side > 0 || has_two_sides) {
        const double from = 0.2 + i * (width + 0.15);
        corridor.rooms.push_back({from, from + width, depth, from + width / 2, side});
      }
  FreeSpace space;
  corridor.addTo(space);
  Corners way{corridor.at(0.6, 0)};
  for (const SideRoom& room : corridor.rooms)
    corridor.visit(room, 0.55, way);
  way.push_back(corridor.at(corridor.length - 1, 0));
  if (isTrue(random, 0.5))
    way.push_back(corridor.at(1, 0));
  return buildingOf(space, drive(way, random.uniform(0.7, 1)), random);
}

/** A square ring of four equal corridors, more than once around. */
Building
makeRing(Random& random)
{
  const double side = random.uniform(9, 18), half_width = random.uniform(0.8, 1.3);
  const Corners corners{{0, 0}, {0, side}, {side, side}, {side, 0}};
  FreeSpace space;
  Corners way;
  const int legs = wholeBetween(random, 5, 8);
  for (std::size_t i = 0; i < 4; ++i)
    space.addAround(corners[i], corners[(i + 1) % 4], half_width);
  for (int i = 0; i <= legs; ++i)
    way.push_back(corners[static_cast<std::size_t>(i % 4)]);
  return buildingOf(space, drive(way, random.uniform(0.7, 1)), random);
}

/** A long corridor with hardly anything along it, there or there and back. */
Building
makeLongCorridor(Random& random)
{
  const double length = random.uniform(40, 80), half_width = random.uniform(0.9, 1.4);
  const Eigen::Vector2d end(0, length);
  FreeSpace space;
  space.addAround({0, 0}, end, half_width);
  addNiches(space, {0, 0}, end, half_width, random);
  Corners way{{0, 0}, end};
  if (isTrue(random, 0.5))
    way.emplace_back(0, length * random.uniform(0, 0.6));
  return buildingOf(space, drive(way, random.uniform(0.7, 1)), random);
}

/** A building and its exact copy, joined by a passage. */
Building
makeTwins(Random& random)
{
  RoomedCorridor first;
  first.length = random.uniform(8, 11);
  addRooms(first, 3, 4.5, random);
  const Corners tour = tourOf(first, 2, random);
  RoomedCorridor second = first;
  second.begin = {random.uniform(13, 17), 0};
  FreeSpace space;
  first.addTo(space);
  second.addTo(space);
  space.add(-1, -1, second.begin[0] + 1, 1);
  Corners way = tour;
  way.emplace_back(0, 0);
  way.push_back(second.begin);
  for (const Eigen::Vector2d& corner : tour)
    way.push_back(second.begin + corner);
  return buildingOf(space, drive(way, random.uniform(0.8, 1.1)), random);
}

/** Rooms most of whose furniture is somewhere else at the second visit. */
Building
makeRefurnished(Random& random)
{
  RoomedCorridor corridor;
  corridor.length = random.uniform(10, 16);
  addRooms(corridor, 3.5, 6, random);
  FreeSpace space;
  corridor.addTo(space);
  Building building;
  Corners way = tourOf(corridor, 4, random);
  const Corners again = way;
  way.insert(way.end(), again.begin(), again.end());
  building.walls = space.outline();
  building.path = drive(way, random.uniform(0.7, 1));
  building.reach = reachOf(random);
  addFurniture(building, wholeBetween(random, 30, 60), true, random);
  return building;
}

} // namespace

void
addFurniture(Building& building, int boxes, bool moves, Random& random)
{
  const std::vector<PlanarPose>& path = building.path;
  for (int i = 0; i < boxes; ++i) {
    const auto at = static_cast<std::size_t>(
        random.uniform(0, static_cast<double>(path.size()) - 1e-9));
    const double angle = random.uniform(0, 2 * M_PI), away = random.uniform(0.9, 2.5);
    const Eigen::Vector2d middle(path[at].x + away * std::sin(angle),
                                 path[at].z + away * std::cos(angle));
    const Eigen::Vector2d half(random.uniform(0.15, 0.5), random.uniform(0.15, 0.5));
    const WallTime time = !moves                ? WallTime::Always
                          : isTrue(random, 0.5) ? WallTime::FirstHalf
                                                : WallTime::SecondHalf;
    const bool is_free =
        std::all_of(path.begin(), path.end(), [&](const PlanarPose& p) {
          return std::abs(p.x - middle[0]) > half[0] + 0.25 ||
                 std::abs(p.z - middle[1]) > half[1] + 0.25;
        });
    if (is_free)
      addBox(middle, half, time, building.walls);
  }
}

const std::vector<BuildingKind>&
buildingKinds()
{
  static const std::vector<BuildingKind> kinds{{"hall", makeHall},
                                               {"blank corridors", makeBlank},
                                               {"warehouse", makeWarehouse},
                                               {"curved walls", makeCurved},
                                               {"wings", makeWings},
                                               {"moved furniture", makeMoved}};
  return kinds;
}

const std::vector<BuildingKind>&
lookalikeKinds()
{
  static const std::vector<BuildingKind> kinds{{"equal corridors", makeEqualCorridors},
                                               {"equal rooms", makeEqualRooms},
                                               {"ring", makeRing},
                                               {"long corridor", makeLongCorridor},
                                               {"twin buildings", makeTwins},
                                               {"refurnished", makeRefurnished}};
  return kinds;
}

} // namespace pcl::acmap::bench
