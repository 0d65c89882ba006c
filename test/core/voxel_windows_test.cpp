#include "noisy_clouds.h"

#include <pcl/core/impl/voxel_windows.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Part = std::tuple<int, int, int, std::uint32_t>;

NoisyCloud
makeScene(std::uint64_t seed)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0.5F, 0.2F, -1.0F}, {-0.7F, -0.4F, 4.5F}};
  Random random(seed);
  cloud.addPatch(squarePatch(1, 0.4), 2000, 0.05, random, 0);
  cloud.addPatch(squarePatch(1, 1.2), 2000, 0.05, random, 1);
  cloud.points.emplace_back(9, 9, 9); // isolated
  cloud.view.push_back(1);
  return cloud;
}

/** Checks all cells; sorted. */
std::vector<Part>
naiveWindow(const VoxelMoments& voxels, VoxelKey middle, int reach)
{
  const VoxelPlace at = placeOf(middle);
  std::vector<Part> parts;
  for (std::uint32_t c = 0; c < voxels.cells.size(); ++c) {
    const VoxelPlace place = placeOf(voxels.cells[c].key);
    const int dx = place[0] - at[0], dy = place[1] - at[1], dz = place[2] - at[2];
    if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) <= reach)
      parts.emplace_back(dx, dy, dz, c);
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

std::vector<Part>
partsOf(const std::vector<WindowPart>& window)
{
  std::vector<Part> parts;
  for (const WindowPart& part : window)
    parts.emplace_back(part.dx, part.dy, part.dz, part.cell);
  return parts;
}

class Windows : public testing::Test {
protected:
  const NoisyCloud cloud_ = makeScene(1);
  const VoxelMoments voxels_ =
      sumVoxels(cloud_.pointView(), cloud_.sensorView(), 0.08, 1);
  const VoxelWindows windows_{voxels_};

  VoxelKey
  keyOf(std::size_t voxel) const
  {
    return voxels_.cells[windows_.firstCell(voxel)].key;
  }

  void
  expectWindow(VoxelWindows::Cursor& cursor, std::size_t voxel, int reach) const
  {
    std::vector<Part> parts = partsOf(cursor.moveTo(voxel));
    std::sort(parts.begin(), parts.end());
    ASSERT_EQ(parts, naiveWindow(voxels_, keyOf(voxel), reach)) << "voxel " << voxel;
  }
};

TEST_F(Windows, voxelsAreTheCellsOfOnePlace)
{
  ASSERT_GT(windows_.size(), 300U);
  ASSERT_LT(windows_.size(), voxels_.cells.size())
      << "no voxel was seen from two sides";
  EXPECT_EQ(windows_.firstCell(0), 0U);
  EXPECT_EQ(windows_.firstCell(windows_.size()), voxels_.cells.size());
  for (std::size_t v = 0; v < windows_.size(); ++v) {
    ASSERT_LT(windows_.firstCell(v), windows_.firstCell(v + 1));
    for (std::size_t c = windows_.firstCell(v); c < windows_.firstCell(v + 1); ++c)
      ASSERT_EQ(voxelOf(voxels_.cells[c].key), voxelOf(keyOf(v)));
    ASSERT_TRUE(v == 0 || voxelOf(keyOf(v - 1)) < voxelOf(keyOf(v)));
  }
}

TEST_F(Windows, areTheCellsAround)
{
  for (const int reach : {1, 2}) {
    VoxelWindows::Cursor cursor(windows_, reach);
    for (std::size_t v = 0; v < windows_.size(); ++v)
      expectWindow(cursor, v, reach);
  }
}

TEST_F(Windows, mayStartAnywhereAndSkip)
{
  for (const int reach : {1, 2})
    for (const std::size_t step : {1, 7, 100})
      for (std::size_t start = 0; start < windows_.size(); start += 37) {
        VoxelWindows::Cursor cursor(windows_, reach);
        for (std::size_t v = start; v < std::min(start + 5 * step, windows_.size());
             v += step)
          expectWindow(cursor, v, reach);
      }
}

TEST_F(Windows, mayBeCollectedTwice)
{
  VoxelWindows::Cursor cursor(windows_, 2);
  for (const std::size_t v : {0, 0, 55, 55, 56})
    expectWindow(cursor, v, 2);
}

TEST_F(Windows, orderIsThatOfThePlaces)
{
  VoxelWindows::Cursor straight(windows_, 2);
  for (std::size_t v = 0; v < windows_.size(); ++v) {
    const std::vector<Part> parts = partsOf(straight.moveTo(v));
    ASSERT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  }
}

TEST_F(Windows, aLonelyVoxelIsItsOwnWindow)
{
  VoxelWindows::Cursor cursor(windows_, 2);
  const auto& parts = cursor.moveTo(windows_.size() - 1);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].isMiddle());
  EXPECT_TRUE(parts[0].isInner());
}

TEST_F(Windows, chosenPartsAreSummedAboutTheMiddle)
{
  VoxelWindows::Cursor cursor(windows_, 2);
  for (std::size_t v = 0; v < windows_.size(); v += 11) {
    const auto& parts = cursor.moveTo(v);
    const Moments sum =
        sumParts(voxels_, parts, [](const WindowPart& part) { return part.isInner(); });
    const Eigen::Vector3d center = voxels_.lattice.center(placeOf(keyOf(v)));
    const double edge = voxels_.lattice.edge();
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    double count = 0, second = 0;
    for (const Eigen::Vector3f& point : cloud_.points) {
      const Eigen::Vector3d off = (point.cast<double>() - center) / edge;
      if (off.cwiseAbs().maxCoeff() > 1.5)
        continue;
      ++count;
      first += off;
      second += off.x() * off.z();
    }
    EXPECT_EQ(sum.count, count);
    EXPECT_NEAR(sum.x, first.x(), 1e-4 * count);
    EXPECT_NEAR(sum.y, first.y(), 1e-4 * count);
    EXPECT_NEAR(sum.z, first.z(), 1e-4 * count);
    EXPECT_NEAR(sum.xz, second, 2e-4 * count);
  }
}

TEST(NoWindows, areLegal)
{
  const VoxelMoments voxels;
  const VoxelWindows windows(voxels);
  EXPECT_EQ(windows.size(), 0U);
  EXPECT_EQ(windows.firstCell(0), 0U);
}

} // namespace
} // namespace pcl::acmap::test
