#include "entropy_runs.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

PointView
viewOf(const PointCloud<PointNormal>& cloud)
{
  return {&cloud.front().x, sizeof(PointNormal), cloud.size()};
}

PointView
normalsOf(const PointCloud<PointNormal>& cloud)
{
  return {&cloud.front().normal_x, sizeof(PointNormal), cloud.size()};
}

std::vector<EntropyCells>
cellsOf(const PosedClouds& map, const MapEntropySettings& settings)
{
  std::vector<EntropyCells> cells;
  for (const auto& cloud : map.clouds)
    cells.push_back(aggregateCells(viewOf(*cloud), normalsOf(*cloud), settings));
  return cells;
}

/** Alternates near and far poses, small and large maps: data of one evaluation must not
 * affect the next one. */
std::vector<std::vector<PlanarPose>>
posesInTurn(const std::vector<PlanarPose>& truth)
{
  std::vector<std::vector<PlanarPose>> all{truth, truth, truth, truth, truth};
  all[1][0].x += 30;
  all[2][1].theta += 1.3;
  all[3][2].z -= 57.3;
  all[3][1].x += 1e7;
  all[3][0].x += 1e7;
  all[3][2].x += 1e7;
  return all;
}

TEST(MapEntropyEvaluator, remembersNothing)
{
  const PosedClouds map = makeRoomViews(3, 2000, 41);
  for (const bool directions : {false, true})
    for (const double sigma : {0.0, 0.1, 0.5}) {
      MapEntropySettings settings;
      settings.direction_aware = directions;
      settings.smoothing = sigma;
      const std::vector<EntropyCells> cells = cellsOf(map, settings);
      MapEntropyEvaluator evaluator(cells, settings);
      for (const auto& poses : posesInTurn(map.poses)) {
        MapEntropyReport report;
        std::vector<Eigen::Vector3d> gradient, wanted;
        MapEntropyEvaluator copy(evaluator), assigned({}, {});
        assigned = evaluator;
        const MapEntropyTerms terms =
            mapEntropy(cells, poses, settings, report, &wanted);
        EXPECT_TRUE(areSame(evaluator.evaluate(poses, report), terms));
        EXPECT_TRUE(areSame(evaluator.evaluate(poses, report, &gradient), terms));
        EXPECT_EQ(gradient, wanted);
        for (MapEntropyEvaluator* other : {&copy, &assigned}) {
          EXPECT_TRUE(areSame(other->evaluate(poses, report, &gradient), terms));
          EXPECT_EQ(gradient, wanted);
        }
      }
    }
}

TEST(MapEntropyEvaluator, refusesPosesAndCellsThatAreNotFinite)
{
  MapEntropySettings settings;
  std::vector<EntropyCells> cells(1);
  cells[0].cells.push_back({1, 2, 3, 0});
  MapEntropyReport report;
  MapEntropyEvaluator evaluator(cells, settings);
  EXPECT_GT(evaluator.evaluate({{0, 0, 0}}, report).total, 0);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(evaluator.evaluate({{nan, 0, 0}}, report), BadArgumentException);
  EXPECT_THROW(evaluator.evaluate({{0, 0, infinity}}, report), BadArgumentException);
  EXPECT_THROW(evaluator.evaluate({}, report), BadArgumentException);
  for (const EntropyCell& bad : {EntropyCell{nan, 0, 1, 0},
                                 EntropyCell{0, infinity, 1, 0},
                                 EntropyCell{0, 0, nan, 0},
                                 EntropyCell{0, 0, -1, 0},
                                 EntropyCell{3e9, 0, 1, 0}}) {
    cells[0].cells[0] = bad;
    EXPECT_THROW(MapEntropyEvaluator(cells, settings), BadArgumentException);
  }
}

double
weightOf(const EntropyCells& cells)
{
  double sum = 0;
  for (const EntropyCell& cell : cells.cells)
    sum += cell.weight;
  return sum;
}

TEST(EntropyCells, keepWeightAndMean)
{
  for (const bool directions : {false, true}) {
    const auto cloud = makeRoomViews(1, 3000, 42).clouds[0];
    MapEntropySettings settings;
    settings.direction_aware = directions;
    const EntropyCells cells =
        aggregateCells(viewOf(*cloud), normalsOf(*cloud), settings);
    EXPECT_EQ(weightOf(cells), 3000);
    Eigen::Vector2d mean(0, 0), wanted(0, 0);
    for (const EntropyCell& cell : cells.cells)
      mean += cell.weight / 3000 * Eigen::Vector2d(cell.x, cell.z);
    for (const PointNormal& point : *cloud)
      wanted += Eigen::Vector2d(point.x, point.z) / 3000;
    EXPECT_LT((mean - wanted).norm(), 1e-7);
  }
}

TEST(EntropyCells, areWholeBinsOnlyWhereTheseAreFilledEvenly)
{
  MapEntropySettings settings;
  settings.bin_size = 1;
  Random random(43);
  std::vector<Eigen::Vector2d> floor, wall;
  for (int i = 0; i < 40000; ++i) {
    floor.emplace_back(random.uniform(-10, 10), random.uniform(-10, 10));
    wall.emplace_back(random.uniform(-10, 10), 0.25 + 0.05 * random.normal());
  }
  const auto floor_cells = aggregateCells(viewOf(*cloudAt(floor)), {}, settings);
  EXPECT_EQ(floor_cells.cells.size(), 400U);
  const auto wall_cells = aggregateCells(viewOf(*cloudAt(wall)), {}, settings);
  EXPECT_EQ(wall_cells.cells.size(), 40U) << "halves";
  EXPECT_EQ(weightOf(wall_cells), 40000);
}

TEST(EntropyCells, haveTheDirectionsOfTheirPoints)
{
  MapEntropySettings settings;
  settings.direction_aware = true;
  PointCloud<PointNormal> cloud;
  for (int i = 0; i < 360; ++i) {
    const double angle = (i - 179.5) * M_PI / 180;
    PointNormal point;
    // On a circle in front of the sensor, with normals pointing back to it.
    point.getVector3fMap() =
        Eigen::Vector3d(-5 * std::cos(angle), 0, -5 * std::sin(angle)).cast<float>();
    point.getNormalVector3fMap() =
        Eigen::Vector3d(std::cos(angle), 0, std::sin(angle)).cast<float>();
    cloud.push_back(point);
  }
  const EntropyCells cells = aggregateCells(viewOf(cloud), normalsOf(cloud), settings);
  EXPECT_EQ(cells.directed_points, 360U);
  for (const EntropyCell& cell : cells.cells) {
    const double wanted = std::atan2(-cell.z, -cell.x);
    EXPECT_LT(std::abs(std::remainder(cell.direction - wanted, 2 * M_PI)), 0.01);
  }
}

} // namespace
} // namespace pcl::acmap::test
