#include "plane_tables.h"

#include "markdown_row.h"
#include "statistics.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace pcl::acmap::bench {
namespace {

constexpr double grid = 0.01; // metres

struct Shape {
  std::string name;
  std::size_t planes; // true number of planes
  PlaneInput input;
};

Shape
makeShape(const std::string& name,
          std::size_t planes,
          const PointCloud<PointXYZ>::Ptr& points,
          double noise)
{
  return {name, planes, {points, {}, {}, noise, grid, toleranceFor(noise)}};
}

/** Two boards of 2 m by 1.5 m, one behind the other. */
PointCloud<PointXYZ>::Ptr
makeBoards(double distance, double noise)
{
  constexpr int columns = 200;
  constexpr int rows = 150;
  const auto points = std::make_shared<PointCloud<PointXYZ>>();
  Random random(1);
  for (const double z : {0.0, distance})
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        points->emplace_back(
            static_cast<float>(grid * column),
            static_cast<float>(grid * row),
            static_cast<float>(noise > 0 ? z + noise * random.normal() : z));
  return points;
}

/** A wall 4 m wide and 2.5 m high, curved with a radius of 8 m. */
PointCloud<PointXYZ>::Ptr
makeCurvedWall(double noise)
{
  constexpr double radius = 8;
  constexpr int columns = 400;
  constexpr int rows = 250;
  const auto points = std::make_shared<PointCloud<PointXYZ>>();
  Random random(1);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double angle = grid * (column - columns / 2) / radius;
      const double range = radius + noise * random.normal();
      points->emplace_back(static_cast<float>(range * std::sin(angle)),
                           static_cast<float>(grid * row),
                           static_cast<float>(range * std::cos(angle)));
    }
  return points;
}

std::string
judged(std::size_t found, const Shape& shape, bool is_ours)
{
  const std::string number = std::to_string(found);
  return is_ours && found != shape.planes
             ? "**" + number + "** (missed: " + std::to_string(shape.planes) + ")"
             : number;
}

void
printShape(const Shape& shape, const NamedFinders& finders)
{
  for (const NamedFinder& finder : finders) {
    const FoundPlanes found = findPlanes(finder, shape.input);
    const auto labelled = std::count_if(found.labels.begin(),
                                        found.labels.end(),
                                        [](std::int32_t label) { return label >= 0; });
    MarkdownRow()
        .text(shape.name)
        .count(found.labels.size())
        .count(shape.planes)
        .text(finder.name)
        .text(judged(found.planes.size(), shape, finder.is_ours))
        .number(percent(static_cast<std::size_t>(labelled), found.labels.size()), 1)
        .number(found.seconds, 3)
        .print();
  }
}

} // namespace

void
printShapePlanes(const NamedFinders& finders)
{
  constexpr double distance = 0.12;
  constexpr double noise = 0.005;
  std::cout << "\n### Shapes\n";
  printHead(
      {"shape", "points", "planes", "finder", "found", "points in them %", "CPU s"});
  printShape(makeShape("two boards 12 cm apart, exact", 2, makeBoards(distance, 0), 0),
             finders);
  printShape(
      makeShape(
          "two boards 12 cm apart, noise 5 mm", 2, makeBoards(distance, noise), noise),
      finders);
  printShape(
      makeShape("curved wall, radius 8 m, noise 5 mm", 0, makeCurvedWall(noise), noise),
      finders);
}

} // namespace pcl::acmap::bench
