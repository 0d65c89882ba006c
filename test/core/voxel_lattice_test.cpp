#include "noisy_clouds.h"

#include <pcl/core/impl/voxel_moments.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace pcl::acmap::test {
namespace {

NoisyCloud
makePoints(const Eigen::Vector3d& middle, std::uint64_t seed)
{
  NoisyCloud cloud;
  cloud.viewpoints = {(middle + Eigen::Vector3d(0.3, 0.1, 5)).cast<float>(),
                      (middle - Eigen::Vector3d(0.3, 0.1, 5)).cast<float>()};
  Random random(seed);
  for (int i = 0; i < 4000; ++i) {
    cloud.points.emplace_back((middle + Eigen::Vector3d(random.uniform(-2, 2),
                                                        random.uniform(-2, 2),
                                                        random.uniform(-0.3, 0.3)))
                                  .cast<float>());
    cloud.view.push_back(i % 2);
  }
  return cloud;
}

TEST(VoxelLattice, keysTellPlaceAndOctant)
{
  Random random(1);
  const auto coordinate = [&] {
    return static_cast<std::int32_t>(random.bits() % (1U << voxel_axis_bits));
  };
  for (int i = 0; i < 1000; ++i) {
    const VoxelPlace place = {coordinate(), coordinate(), coordinate()};
    const auto octant = static_cast<unsigned>(random.bits() % 8);
    const VoxelKey key = voxelKey(place, octant);
    EXPECT_EQ(placeOf(key), place);
    EXPECT_EQ(octantOf(key), octant);
    EXPECT_EQ(voxelOf(key), voxelKey(place));
    EXPECT_LT(key, VoxelKey{1} << 63);
  }
  EXPECT_LT(voxelKey({1, 2, 3}, 7), voxelKey({1, 2, 4}));
  EXPECT_LT(voxelKey({1, 2, 9}), voxelKey({1, 3, 0}));
  EXPECT_LT(voxelKey({1, 9, 9}), voxelKey({2, 0, 0}));
}

TEST(VoxelLattice, octantsTellWhereTheSensorStands)
{
  const Eigen::Vector3f point(1, 2, 3);
  for (unsigned octant = 0; octant < 8; ++octant) {
    const Eigen::Vector3f direction(
        octant & 4 ? 1.F : -1.F, octant & 2 ? 1.F : -1.F, octant & 1 ? 1.F : -1.F);
    EXPECT_EQ(octantTowards(point, point + 0.5F * direction), octant);
  }
}

TEST(VoxelLattice, pointsLieInTheirVoxels)
{
  for (const double edge : {0.013, 0.1, 1.0})
    for (const double far : {0.0, 1000.0}) {
      const NoisyCloud cloud = makePoints({far, -far, far / 2}, 2);
      const VoxelLattice lattice(cloud.pointView(), edge);
      EXPECT_EQ(lattice.edge(), edge);
      for (const Eigen::Vector3f& point : cloud.points) {
        VoxelHit hit;
        ASSERT_TRUE(lattice.locate(point, hit));
        const Eigen::Vector3d off =
            (point.cast<double>() - lattice.center(hit.place)) / edge;
        ASSERT_LE(off.cwiseAbs().maxCoeff(), 0.5 + 1e-9);
        constexpr double ticks = 1 << VoxelLattice::offset_bits;
        for (int axis = 0; axis < 3; ++axis)
          ASSERT_NEAR(off[axis], hit.offset[axis] / ticks, 1.001 / ticks);
      }
    }
}

TEST(VoxelLattice, cloudsInOneFrameShareVoxels)
{
  constexpr double edge = 0.07;
  const VoxelLattice here(makePoints({0, 0, 0}, 3).pointView(), edge);
  const VoxelLattice there(makePoints({31, -55, 12}, 4).pointView(), edge);
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3f point(static_cast<float>(random.uniform(-60, 60)),
                                static_cast<float>(random.uniform(-60, 60)),
                                static_cast<float>(random.uniform(-60, 60)));
    VoxelHit first, second;
    ASSERT_TRUE(here.locate(point, first));
    ASSERT_TRUE(there.locate(point, second));
    EXPECT_TRUE(here.center(first.place).isApprox(there.center(second.place), 1e-12));
    EXPECT_EQ(first.offset, second.offset);
  }
}

TEST(VoxelLattice, coarserOnesHoldEightVoxelsEach)
{
  const NoisyCloud cloud = makePoints({-3, 8, 100}, 6);
  VoxelLattice fine(cloud.pointView(), 0.02);
  for (int doubling = 0; doubling < 6; ++doubling) {
    const VoxelLattice coarse = fine.coarser();
    ASSERT_DOUBLE_EQ(coarse.edge(), 2 * fine.edge());
    for (const Eigen::Vector3f& point : cloud.points) {
      VoxelHit inner, outer;
      ASSERT_TRUE(fine.locate(point, inner));
      ASSERT_TRUE(coarse.locate(point, outer));
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(inner.place[axis] / 2, outer.place[axis]) << "doubling " << doubling;
    }
    fine = coarse;
  }
}

using ByCenter = std::map<std::array<long, 3>, VoxelCell>;

ByCenter
byCenter(const VoxelMoments& voxels)
{
  ByCenter cells;
  for (const VoxelCell& cell : voxels.cells) {
    const Eigen::Vector3d center = voxels.lattice.center(placeOf(cell.key));
    cells[{std::lround(center[0] / voxels.lattice.edge() - 0.5),
           std::lround(center[1] / voxels.lattice.edge() - 0.5),
           std::lround(center[2] / voxels.lattice.edge() - 0.5)}] = cell;
  }
  return cells;
}

TEST(CoarserVoxels, areTheSumsAtTwiceTheEdge)
{
  const NoisyCloud cloud = makePoints({2, -7, 1}, 7);
  VoxelMoments voxels = sumVoxels(cloud.pointView(), cloud.sensorView(), 0.05, 1);
  for (double edge = 0.1; edge < 1; edge *= 2) {
    voxels = coarserVoxels(voxels);
    const ByCenter found = byCenter(voxels);
    const ByCenter wanted = byCenter(sumVoxels(cloud.pointView(), {}, edge, 1));
    ASSERT_EQ(found.size(), voxels.cells.size());
    ASSERT_EQ(found.size(), wanted.size());
    for (const auto& [center, cell] : wanted) {
      ASSERT_EQ(found.count(center), 1U);
      const Moments& m = found.at(center).moments;
      const double tolerance = 1e-4 * cell.moments.count;
      ASSERT_EQ(m.count, cell.moments.count);
      EXPECT_NEAR(m.x, cell.moments.x, tolerance);
      EXPECT_NEAR(m.y, cell.moments.y, tolerance);
      EXPECT_NEAR(m.z, cell.moments.z, tolerance);
      EXPECT_NEAR(m.xx, cell.moments.xx, tolerance);
      EXPECT_NEAR(m.xy, cell.moments.xy, tolerance);
      EXPECT_NEAR(m.xz, cell.moments.xz, tolerance);
      EXPECT_NEAR(m.yy, cell.moments.yy, tolerance);
      EXPECT_NEAR(m.yz, cell.moments.yz, tolerance);
      EXPECT_NEAR(m.zz, cell.moments.zz, tolerance);
    }
  }
}

TEST(CoarserVoxels, keepTheWitness)
{
  const NoisyCloud cloud = makePoints({2, -7, 1}, 8);
  const SensorView sensors = cloud.sensorView();
  const VoxelMoments voxels =
      coarserVoxels(sumVoxels(cloud.pointView(), sensors, 0.1, 1));
  std::map<VoxelKey, float> nearest;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    VoxelHit hit;
    ASSERT_TRUE(voxels.lattice.locate(cloud.points[i], hit));
    const float range = (*sensors[i] - cloud.points[i]).norm();
    float& minimum = nearest.emplace(voxelKey(hit.place), range).first->second;
    minimum = std::min(minimum, range);
  }
  for (const VoxelCell& cell : voxels.cells) {
    const auto witness = static_cast<std::size_t>(cell.witness);
    EXPECT_FLOAT_EQ(cell.range, nearest.at(cell.key));
    EXPECT_FLOAT_EQ((*sensors[witness] - cloud.points[witness]).norm(), cell.range);
  }
}

TEST(CoarserVoxels, keepTheFirstPointWhereNoSensorIsKnown)
{
  const NoisyCloud cloud = makePoints({2, -7, 1}, 9);
  const ByCenter found =
      byCenter(coarserVoxels(sumVoxels(cloud.pointView(), {}, 0.1, 1)));
  for (const auto& [center, cell] : byCenter(sumVoxels(cloud.pointView(), {}, 0.2, 1)))
    EXPECT_EQ(found.at(center).witness, cell.witness);
}

} // namespace
} // namespace pcl::acmap::test
