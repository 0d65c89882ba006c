#include <pcl/conversions.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace pcl::acmap::test {
namespace {

/** \brief Points along x, starting at a number; every fifth one is NaN. */
PointCloudFile
line(int first, int points)
{
  PointCloud<PointXYZRGB> cloud;
  for (int i = first; i < first + points; ++i) {
    PointXYZRGB point;
    point.x = i % 5 == 4 ? std::numeric_limits<float>::quiet_NaN() : float(i);
    point.y = point.z = 0;
    point.rgba = static_cast<std::uint32_t>(i);
    cloud.push_back(point);
  }
  PointCloudFile file;
  toPCLPointCloud2(cloud, file.cloud);
  return file;
}

struct Row {
  float x = 0;
  std::uint32_t color = 0;
  std::int32_t view = 0;

  bool
  operator==(const Row& other) const
  {
    return x == other.x && color == other.color && view == other.view;
  }
};

std::vector<Row>
rowsOf(const CloudRows& cloud)
{
  std::vector<Row> rows(cloud.size());
  EXPECT_EQ(cloud.bytes(), rows.size() * cloud.layout().point_step);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::uint8_t* const row = cloud.data() + i * cloud.layout().point_step;
    std::memcpy(&rows[i].x, row, sizeof rows[i].x);
    std::memcpy(&rows[i].color, row + 12, sizeof rows[i].color);
    std::memcpy(&rows[i].view, row + 16, sizeof rows[i].view);
  }
  return rows;
}

/** \brief Expected rows for observations with these numbers of points. */
std::vector<Row>
expectedOf(const std::vector<int>& sizes, std::size_t every)
{
  std::vector<Row> rows;
  std::size_t finite = 0;
  int number = 0;
  for (std::size_t view = 0; view < sizes.size(); ++view)
    for (int i = 0; i < sizes[view]; ++i, ++number)
      if (number % 5 != 4 && finite++ % every == 0)
        rows.push_back({float(number) + 100,
                        static_cast<std::uint32_t>(number),
                        static_cast<std::int32_t>(view)});
  return rows;
}

TEST(MapRows, HalvesUntilTheyFit)
{
  Eigen::Isometry3d shift = Eigen::Isometry3d::Identity();
  shift.translation().x() = 100;
  for (const std::vector<int>& sizes : {std::vector<int>{40},
                                        {7, 0, 31, 2, 64},
                                        {1, 1, 1, 1, 1, 1, 1},
                                        {200, 3, 3},
                                        {5, 500},
                                        {9001, 3, 5002}}) // several chunks
    for (const std::size_t maximum : {1u, 2u, 3u, 7u, 16u, 33u, 100000u}) {
      MapRows rows(0, true);
      rows.setMaximum(maximum);
      int first = 0;
      for (std::size_t view = 0; view < sizes.size(); ++view) {
        PointCloudFile file = line(first, sizes[view]);
        rows.append(file, shift, static_cast<std::int32_t>(view));
        first += sizes[view];
      }
      std::size_t every = 1;
      while (expectedOf(sizes, every).size() > maximum)
        every *= 2;
      EXPECT_EQ(rows.every(), every) << maximum;
      EXPECT_TRUE(rowsOf(rows.finish()) == expectedOf(sizes, every)) << maximum;
    }
}

TEST(MapRows, EveryNthBeginsWithTheFirst)
{
  MapRows rows(0, true);
  rows.append(line(0, 20), Eigen::Isometry3d::Identity(), 3);
  const CloudRows cloud = rows.finish();
  const std::vector<Row> all = rowsOf(cloud);
  ASSERT_EQ(all.size(), 16u);
  for (const std::size_t n : {1u, 2u, 3u, 15u, 16u, 100u}) {
    std::vector<Row> expected;
    for (std::size_t i = 0; i < all.size(); i += n)
      expected.push_back(all[i]);
    const auto thinned = std::make_shared<PCLPointCloud2>(everyNth(cloud, n));
    EXPECT_TRUE(rowsOf(thinned) == expected) << n;
  }
}

TEST(MapRows, AreMovedWithTheirNormals)
{
  PointCloud<PointXYZRGBNormal> cloud(1, 1);
  cloud[0].x = 1;
  cloud[0].y = 2;
  cloud[0].z = 3;
  cloud[0].normal_x = 1;
  cloud[0].rgba = 7;
  PointCloud<Normal> normals(1, 1);
  normals[0].normal_x = 1;
  PCLPointCloud2 points, directions;
  toPCLPointCloud2(cloud, points);
  toPCLPointCloud2(normals, directions);
  Eigen::Isometry3d motion(Eigen::Translation3d(10, 0, 0));
  motion.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  fromPCLPointCloud2(movedRows(motion, CloudRows::of(points)).copy(), cloud);
  EXPECT_LT((cloud[0].getVector3fMap() - Eigen::Vector3f(8, 1, 3)).norm(), 1e-6);
  EXPECT_LT((cloud[0].getNormalVector3fMap() - Eigen::Vector3f::UnitY()).norm(), 1e-6);
  EXPECT_EQ(cloud[0].rgba, 7u);
  fromPCLPointCloud2(movedRows(motion, CloudRows::of(directions)).copy(), normals);
  EXPECT_LT((normals[0].getNormalVector3fMap() - Eigen::Vector3f::UnitY()).norm(),
            1e-6);
  const CloudRows given = CloudRows::of(points);
  EXPECT_EQ(movedRows(Eigen::Isometry3d::Identity(), given).data(), given.data());
}

} // namespace
} // namespace pcl::acmap::test
