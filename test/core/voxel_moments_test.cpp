#include "noisy_clouds.h"

#include <pcl/core/impl/voxel_moments.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Corner = std::array<std::int64_t, 3>; // in multiples of the edge length
using CellName = std::pair<Corner, unsigned>;
using Naive = std::map<CellName, std::vector<std::size_t>>;

Corner
cornerOf(const Eigen::Vector3d& place, double edge)
{
  Corner corner;
  for (int axis = 0; axis < 3; ++axis)
    corner[axis] = static_cast<std::int64_t>(std::floor(place[axis] / edge));
  return corner;
}

/** The points of each cell, with a plain map. */
Naive
naiveCells(const NoisyCloud& cloud, const SensorView& sensors, double edge)
{
  Naive cells;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f p = cloud.points[i];
    if (!p.allFinite())
      continue;
    unsigned octant = 0;
    if (const Eigen::Vector3f* s = sensors[i])
      octant = (s->x() > p.x()) * 4 + (s->y() > p.y()) * 2 + (s->z() > p.z());
    cells[{cornerOf(p.cast<double>(), edge), octant}].push_back(i);
  }
  return cells;
}

std::map<CellName, VoxelCell>
byName(const VoxelMoments& voxels)
{
  std::map<CellName, VoxelCell> cells;
  const double edge = voxels.lattice.edge();
  for (const VoxelCell& cell : voxels.cells)
    cells[{cornerOf(voxels.lattice.center(placeOf(cell.key)), edge),
           octantOf(cell.key)}] = cell;
  return cells;
}

struct Gauss {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

Gauss
gaussOf(const std::vector<Eigen::Vector3f>& points,
        const std::vector<std::size_t>& chosen)
{
  Gauss gauss;
  const auto size = static_cast<double>(chosen.size());
  for (const std::size_t i : chosen)
    gauss.mean += points[i].cast<double>() / size;
  for (const std::size_t i : chosen) {
    const Eigen::Vector3d off = points[i].cast<double>() - gauss.mean;
    gauss.covariance += off * off.transpose() / size;
  }
  return gauss;
}

/** Mean and covariance in metres. */
Gauss
gaussOf(const VoxelCell& cell, const VoxelLattice& lattice)
{
  const Moments& m = cell.moments;
  const Eigen::Vector3d mean = m.mean();
  Gauss gauss;
  gauss.mean = lattice.center(placeOf(cell.key)) + mean * lattice.edge();
  gauss.covariance << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  gauss.covariance = (gauss.covariance / m.count - mean * mean.transpose()) *
                     lattice.edge() * lattice.edge();
  return gauss;
}

/** Requires equal counts, and means and covariances within a thousandth of an edge. */
void
expectAsNaive(const VoxelMoments& voxels,
              const NoisyCloud& cloud,
              const SensorView& sensors)
{
  const double edge = voxels.lattice.edge();
  const Naive naive = naiveCells(cloud, sensors, edge);
  const auto cells = byName(voxels);
  ASSERT_EQ(cells.size(), voxels.cells.size()) << "two cells of one name";
  ASSERT_EQ(cells.size(), naive.size());
  for (const auto& [name, points] : naive) {
    const auto found = cells.find(name);
    ASSERT_NE(found, cells.end());
    ASSERT_EQ(found->second.moments.count, static_cast<double>(points.size()));
    const Gauss wanted = gaussOf(cloud.points, points);
    const Gauss gauss = gaussOf(found->second, voxels.lattice);
    ASSERT_LT((gauss.mean - wanted.mean).cwiseAbs().maxCoeff(), 1e-3 * edge);
    ASSERT_LT((gauss.covariance - wanted.covariance).cwiseAbs().maxCoeff(),
              1e-3 * edge * edge);
  }
}

NoisyCloud
makeTwoSides(std::uint64_t seed)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0.5F, 0.2F, -1.0F}, {-0.7F, -0.4F, 4.5F}};
  Random random(seed);
  cloud.addPatch(squarePatch(2, 0.3), 2000, 0.02, random, 0);
  cloud.addPatch(squarePatch(2, 0.3), 2000, 0.02, random, 1);
  return cloud;
}

void
expectSameBytes(const VoxelMoments& a, const VoxelMoments& b)
{
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for (std::size_t c = 0; c < a.cells.size(); ++c) {
    const VoxelCell &one = a.cells[c], &other = b.cells[c];
    EXPECT_EQ(std::memcmp(&one.moments, &other.moments, sizeof(Moments)), 0);
    EXPECT_EQ(one.way, other.way);
    EXPECT_EQ(std::tie(one.key, one.witness, one.range),
              std::tie(other.key, other.witness, other.range));
  }
  ASSERT_EQ(a.colors.size(), b.colors.size());
  for (std::size_t c = 0; c < a.colors.size(); ++c)
    EXPECT_EQ(std::tie(a.colors[c].red, a.colors[c].green, a.colors[c].blue),
              std::tie(b.colors[c].red, b.colors[c].green, b.colors[c].blue));
}

TEST(SumVoxels, areTheNaiveSums)
{
  const NoisyCloud cloud = makeTwoSides(1);
  for (const double edge : {0.03, 0.0625, 0.25, 7.0}) {
    expectAsNaive(sumVoxels(cloud.pointView(), SensorView(), edge, 1), cloud, {});
    expectAsNaive(sumVoxels(cloud.pointView(), cloud.sensorView(), edge, 1),
                  cloud,
                  cloud.sensorView());
  }
}

TEST(SumVoxels, cellsAscend)
{
  const NoisyCloud cloud = makeTwoSides(2);
  const auto cells = sumVoxels(cloud.pointView(), cloud.sensorView(), 0.05, 0).cells;
  ASSERT_GT(cells.size(), 1000U);
  for (std::size_t c = 1; c < cells.size(); ++c)
    ASSERT_LT(cells[c - 1].key, cells[c].key);
}

TEST(SumVoxels, neitherThreadsNorOrderShow)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0.5F, 0.2F, -1.0F}, {-0.7F, -0.4F, 4.5F}};
  Random random(3);
  cloud.addPatch(squarePatch(3, 0.3), 45000, 0.02, random, 0); // 810 000 points in all
  cloud.addPatch(squarePatch(3, 0.3), 45000, 0.02, random, 1);
  std::vector<std::uint32_t> packed;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    packed.push_back(static_cast<std::uint32_t>(random.bits()));
  const ColorView colors{packed.data(), sizeof(std::uint32_t)};
  const auto sum = [&](unsigned threads) {
    return sumVoxels(cloud.pointView(), cloud.sensorView(), 0.05, threads, colors);
  };
  const VoxelMoments alone = sum(1);
  for (const unsigned threads : {2U, 8U, 0U})
    expectSameBytes(sum(threads), alone);

  const NoisyCloud mixed = shuffled(cloud, 4);
  const VoxelMoments other = sumVoxels(mixed.pointView(), mixed.sensorView(), 0.05, 8);
  ASSERT_EQ(other.cells.size(), alone.cells.size());
  for (std::size_t c = 0; c < other.cells.size(); ++c) {
    ASSERT_EQ(other.cells[c].key, alone.cells[c].key);
    ASSERT_EQ(
        std::memcmp(&other.cells[c].moments, &alone.cells[c].moments, sizeof(Moments)),
        0);
    ASSERT_EQ(other.cells[c].range, alone.cells[c].range);
  }
}

TEST(SumVoxels, pointsThatAreNotFiniteAreCounted)
{
  NoisyCloud cloud = makeTwoSides(5);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  cloud.points[3] = {nan, 0, 0};
  cloud.points[7] = {0, 0, nan};
  cloud.points[8000] = {0, -infinity, 0};
  const VoxelMoments voxels = sumVoxels(cloud.pointView(), cloud.sensorView(), 0.1, 1);
  EXPECT_EQ(voxels.invalid_points, 3U);
  EXPECT_EQ(voxels.distant_points, 0U);
  expectAsNaive(voxels, cloud, cloud.sensorView());
}

TEST(SumVoxels, aFarStrayIsCountedAndHarmsNobody)
{
  const NoisyCloud cloud = makeTwoSides(6);
  for (const float far : {1e9F, -1e9F, 3e38F}) {
    NoisyCloud strayed = cloud;
    strayed.points.insert(strayed.points.begin() + 11, {far, far, far});
    strayed.view.insert(strayed.view.begin() + 11, 0);
    const VoxelMoments voxels =
        sumVoxels(strayed.pointView(), strayed.sensorView(), 0.1, 1);
    EXPECT_EQ(voxels.distant_points, 1U);
    EXPECT_EQ(voxels.invalid_points, 0U);
    expectAsNaive(voxels, cloud, cloud.sensorView());
  }
}

TEST(SumVoxels, nationalGridsAreNoTrouble)
{
  NoisyCloud cloud;
  Random random(7);
  for (int i = 0; i < 5000; ++i) {
    const double x = random.uniform(0, 20);
    const double y = random.uniform(0, 20);
    cloud.points.emplace_back(500000 + static_cast<float>(x),
                              5400000 + static_cast<float>(y),
                              static_cast<float>(600 + 0.1 * x));
    cloud.view.push_back(-1);
  }
  const VoxelMoments voxels = sumVoxels(cloud.pointView(), {}, 0.75, 1);
  EXPECT_EQ(voxels.distant_points, 0U);
  EXPECT_GT(voxels.cells.size(), 300U);
  expectAsNaive(voxels, cloud, {});
}

TEST(SumVoxels, nothingGivesNothing)
{
  EXPECT_TRUE(sumVoxels(PointView(), SensorView(), 0.1, 0).cells.empty());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  NoisyCloud cloud;
  cloud.points.assign(9, {nan, nan, nan});
  const VoxelMoments voxels = sumVoxels(cloud.pointView(), SensorView(), 0.1, 0);
  EXPECT_TRUE(voxels.cells.empty());
  EXPECT_EQ(voxels.invalid_points, 9U);
  EXPECT_TRUE(coarserVoxels(voxels).cells.empty());
}

TEST(SumVoxels, sidesOfAWallNeverShareACell)
{
  const NoisyCloud cloud = makeTwoSides(8);
  const VoxelMoments voxels = sumVoxels(cloud.pointView(), cloud.sensorView(), 0.2, 1);
  const auto cells = byName(voxels);
  std::map<Corner, std::size_t> sides;
  for (const auto& [name, cell] : cells)
    ++sides[name.first];
  const auto shared = std::count_if(
      sides.begin(), sides.end(), [](const auto& side) { return side.second >= 2; });
  EXPECT_GT(shared, 80);
  // each cell holds points of one view, as the sensors are on both sides of the wall
  for (const auto& [name, points] : naiveCells(cloud, cloud.sensorView(), 0.2))
    for (const std::size_t i : points)
      ASSERT_EQ(cloud.view[i], cloud.view[points[0]]);
}

TEST(SumVoxels, witnessIsNearestToItsSensor)
{
  const NoisyCloud cloud = makeTwoSides(9);
  const SensorView sensors = cloud.sensorView();
  const auto cells = byName(sumVoxels(cloud.pointView(), sensors, 0.1, 1));
  for (const auto& [name, points] : naiveCells(cloud, sensors, 0.1)) {
    float nearest = std::numeric_limits<float>::max();
    for (const std::size_t i : points)
      nearest = std::min(nearest, (*sensors[i] - cloud.points[i]).norm());
    const VoxelCell& cell = cells.at(name);
    const auto witness = static_cast<std::size_t>(cell.witness);
    EXPECT_FLOAT_EQ(cell.range, nearest);
    EXPECT_FLOAT_EQ((*sensors[witness] - cloud.points[witness]).norm(), nearest);
    EXPECT_EQ(std::count(points.begin(), points.end(), witness), 1);
  }
}

TEST(SumVoxels, witnessIsTheFirstPointWhereNoSensorIsKnown)
{
  const NoisyCloud cloud = makeTwoSides(10);
  const auto cells = byName(sumVoxels(cloud.pointView(), {}, 0.1, 1));
  for (const auto& [name, points] : naiveCells(cloud, {}, 0.1)) {
    EXPECT_EQ(cells.at(name).witness, static_cast<std::int32_t>(points[0]));
    EXPECT_EQ(cells.at(name).range, 0);
  }
}

TEST(SumVoxels, colorsAreSummed)
{
  NoisyCloud cloud = makeTwoSides(11);
  std::vector<std::array<std::uint32_t, 2>> packed; // the second value must be skipped
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    packed.push_back({static_cast<std::uint32_t>(0xff000000U + i * 2654435761U), 77});
  const VoxelMoments voxels = sumVoxels(cloud.pointView(),
                                        cloud.sensorView(),
                                        0.1,
                                        0,
                                        {packed.data(), 2 * sizeof(std::uint32_t)});
  ASSERT_EQ(voxels.colors.size(), voxels.cells.size());
  const Naive naive = naiveCells(cloud, cloud.sensorView(), 0.1);
  for (std::size_t c = 0; c < voxels.cells.size(); ++c) {
    ColorSum sum;
    const CellName name = {
        cornerOf(voxels.lattice.center(placeOf(voxels.cells[c].key)), 0.1),
        octantOf(voxels.cells[c].key)};
    for (const std::size_t i : naive.at(name)) {
      sum.red += packed[i][0] >> 16 & 0xff;
      sum.green += packed[i][0] >> 8 & 0xff;
      sum.blue += packed[i][0] & 0xff;
    }
    EXPECT_EQ(voxels.colors[c].red, sum.red);
    EXPECT_EQ(voxels.colors[c].green, sum.green);
    EXPECT_EQ(voxels.colors[c].blue, sum.blue);
  }
}

TEST(SumVoxels, indicesChoosePointsAndColors)
{
  const NoisyCloud cloud = makeTwoSides(12);
  const std::vector<std::int32_t> indices = {5, 4000, 77, 7999};
  std::vector<std::uint32_t> packed(cloud.points.size());
  for (std::size_t i = 0; i < packed.size(); ++i)
    packed[i] = static_cast<std::uint32_t>(i);
  const VoxelMoments voxels = sumVoxels(
      {cloud.points.data(), sizeof(Eigen::Vector3f), 4, indices.data()},
      {cloud.view.data(), sizeof(std::int32_t), cloud.viewpoints, indices.data()},
      1e-3,
      0,
      {packed.data(), sizeof(std::uint32_t)});
  ASSERT_EQ(voxels.cells.size(), 4U);
  for (std::size_t c = 0; c < 4; ++c) {
    const auto point = static_cast<std::uint32_t>(
        indices.at(static_cast<std::size_t>(voxels.cells[c].witness)));
    EXPECT_EQ(voxels.colors[c].green, point >> 8);
    EXPECT_EQ(voxels.colors[c].blue, point & 0xff);
    EXPECT_LT((gaussOf(voxels.cells[c], voxels.lattice).mean -
               cloud.points[point].cast<double>())
                  .norm(),
              1e-6);
  }
}

} // namespace
} // namespace pcl::acmap::test
