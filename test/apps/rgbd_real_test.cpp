#include "run_tool.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/image_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

const std::string kitchen = "C_sequence/redkitchen_000_495";

using Cloud = PointCloud<PointXYZRGB>;

/** The kitchen, imported once for all tests. */
class RealRgbd : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    if (!hasTestData(kitchen + "/camera-intrinsics.txt"))
      return;
    folder_ = new TemporaryFolder;
    run_ = runTool(ACMAP_RGBD_IMPORT,
                   {testDataPath(kitchen).string(), "-o", folder_->path("kitchen")});
    unregistered_run_ = runTool(ACMAP_RGBD_IMPORT,
                                {testDataPath(kitchen).string(),
                                 "--registered",
                                 "-o",
                                 folder_->path("unregistered")});
  }

  static void
  TearDownTestSuite()
  {
    delete folder_;
    folder_ = nullptr;
  }

  void
  SetUp() override
  {
    if (!folder_)
      GTEST_SKIP() << kitchen << " is not in the folder that ACMAP_TEST_DATA names";
    ASSERT_EQ(run_.exit_code, 0) << run_.err;
    ASSERT_EQ(unregistered_run_.exit_code, 0) << unregistered_run_.err;
  }

  static std::string
  outputFile(const std::string& name, const std::string& folder = "kitchen")
  {
    return folder_->path(folder) + "/" + name;
  }

  static Cloud
  observation(int index, const std::string& folder = "kitchen")
  {
    const std::string digits = std::to_string(index);
    const std::string name =
        "observation_" + std::string(4 - digits.size(), '0') + digits + ".pcd";
    Cloud cloud;
    EXPECT_EQ(io::loadPCDFile(outputFile(name, folder), cloud), 0);
    return cloud;
  }

  static TemporaryFolder* folder_;
  static ToolRun run_;
  /** \brief With --registered, although the images are not registered. */
  static ToolRun unregistered_run_;
};

TemporaryFolder* RealRgbd::folder_ = nullptr;
ToolRun RealRgbd::run_;
ToolRun RealRgbd::unregistered_run_;

TEST_F(RealRgbd, AllObservationsAreThere)
{
  EXPECT_EQ(run_.err, "");
  const Trajectory trajectory = loadTrajectory(outputFile("trajectory.txt"));
  ASSERT_EQ(trajectory.poses.size(), 50u);
  for (int index = 0; index < 50; ++index) {
    const Cloud cloud = observation(index);
    ASSERT_EQ(cloud.width, 640u);
    ASSERT_EQ(cloud.height, 480u);
    const auto finite = std::count_if(
        cloud.begin(), cloud.end(), [](const PointXYZRGB& p) { return p.z > 0.3F; });
    // the colour camera has a larger field of view than the depth camera
    EXPECT_GT(finite, 640 * 480 * 0.45);
    const Eigen::Vector3d origin = cloud.sensor_origin_.head<3>().cast<double>();
    const auto& pose = trajectory.poses[static_cast<std::size_t>(index)];
    EXPECT_LT((origin - pose.translation()).norm(), 1e-5);
  }
}

TEST_F(RealRgbd, ColoursAreThoseOfTheImage)
{
  const RgbImage image =
      loadRgbImage(testDataPath(kitchen + "/frame-000490.color.jpg").string());
  const Cloud cloud = observation(49);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(cloud[i].r, image.values[3 * i]);
    ASSERT_EQ(cloud[i].g, image.values[3 * i + 1]);
    ASSERT_EQ(cloud[i].b, image.values[3 * i + 2]);
  }
}

/** Standard deviation of the points of a window from their best-fit plane; negative if
 * the window has too few points. */
double
unevenness(const Cloud& cloud, std::uint32_t column, std::uint32_t row)
{
  constexpr std::uint32_t size = 15;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (std::uint32_t v = row; v < row + size; ++v)
    for (std::uint32_t u = column; u < column + size; ++u)
      if (const auto& p = cloud.at(static_cast<int>(u), static_cast<int>(v)); p.z > 0) {
        const Eigen::Vector3d point = p.getVector3fMap().cast<double>();
        moments += point * point.transpose();
        sum += point;
        ++count;
      }
  if (count < 0.9 * size * size)
    return -1;
  const Eigen::Vector3d mean = sum / count;
  const Eigen::Matrix3d covariance = moments / count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance,
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
}

TEST_F(RealRgbd, MostSurfacesArePlaneInTheSmall)
{
  const Cloud cloud = observation(0);
  std::vector<double> windows;
  for (std::uint32_t row = 0; row + 15 <= cloud.height; row += 15)
    for (std::uint32_t column = 0; column + 15 <= cloud.width; column += 15)
      if (const double off = unevenness(cloud, column, row); off >= 0)
        windows.push_back(off);
  ASSERT_GT(windows.size(), 500u);
  std::sort(windows.begin(), windows.end());
  EXPECT_LT(windows[windows.size() / 2], 0.005);
}

double
medianOf(std::vector<double> values)
{
  EXPECT_GT(values.size(), 5000u);
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/** Calls use (point in the frame of the other view, point of its pixel in this view,
 * point of its pixel in the other view) for every seventh point that is visible in the
 * other view. */
template <typename Use>
void
forEachCommonPoint(const Cloud& from,
                   const Cloud& to,
                   const Eigen::Isometry3d& T_to_from,
                   double focal_length,
                   const Use& use)
{
  for (std::size_t i = 0; i < from.size(); i += 7) {
    if (!(from[i].z > 0))
      continue;
    const Eigen::Vector3d p = T_to_from * from[i].getVector3fMap().cast<double>();
    const double column = std::round(focal_length * p.x() / p.z() + 320);
    const double row = std::round(focal_length * p.y() / p.z() + 240);
    if (p.z() > 0 && column >= 0 && column < 640 && row >= 0 && row < 480)
      use(p, from[i], to.at(static_cast<int>(column), static_cast<int>(row)));
  }
}

/** Median difference between the depths of one view and those of another, both in the
 * frame of the latter, metres. */
double
disagreement(const Cloud& from, const Cloud& to, const Eigen::Isometry3d& T_to_from)
{
  std::vector<double> differences;
  forEachCommonPoint(
      from,
      to,
      T_to_from,
      525,
      [&](const Eigen::Vector3d& p, const PointXYZRGB&, const PointXYZRGB& seen) {
        if (seen.z > 0)
          differences.push_back(std::abs(seen.z - p.z()));
      });
  return medianOf(differences);
}

/** Median difference of their colours, grey levels. */
double
colorDisagreement(const Cloud& from,
                  const Cloud& to,
                  const Eigen::Isometry3d& T_to_from,
                  double focal_length)
{
  std::vector<double> differences;
  forEachCommonPoint(
      from,
      to,
      T_to_from,
      focal_length,
      [&](const Eigen::Vector3d& p, const PointXYZRGB& point, const PointXYZRGB& seen) {
        if (seen.z > 0 && std::abs(seen.z - p.z()) < 0.03)
          differences.push_back((std::abs(point.r - seen.r) +
                                 std::abs(point.g - seen.g) +
                                 std::abs(point.b - seen.b)) /
                                3.0);
      });
  return medianOf(differences);
}

TEST_F(RealRgbd, ViewsAgreeByTheirPoses)
{
  const Trajectory trajectory = loadTrajectory(outputFile("trajectory.txt"));
  const auto between = [&](std::size_t to, std::size_t from) {
    return trajectory.poses[to].inverse() * trajectory.poses[from];
  };
  for (const int view : {10, 20, 30, 40}) {
    const auto index = static_cast<std::size_t>(view);
    const Cloud from = observation(view);
    const Cloud to = observation(view - 5);
    const double posed = disagreement(from, to, between(index - 5, index));
    EXPECT_LT(posed, 0.03) << view;
    // with the inverse pose, or without it, they do not agree
    EXPECT_LT(posed, 0.5 * disagreement(from, to, Eigen::Isometry3d::Identity()));
    EXPECT_LT(posed, 0.5 * disagreement(from, to, between(index, index - 5)));
  }
}

TEST_F(RealRgbd, ColoursLieWhereTheyBelong)
{
  const auto between = [&](const std::string& folder, std::size_t to) {
    const Trajectory trajectory = loadTrajectory(outputFile("trajectory.txt", folder));
    return trajectory.poses[to].inverse() * trajectory.poses[to + 2];
  };
  double registered_sum = 0, unregistered_sum = 0;
  for (int view = 0; view < 46; view += 5) {
    const auto index = static_cast<std::size_t>(view);
    const double registered = colorDisagreement(
        observation(view + 2), observation(view), between("kitchen", index), 525);
    const double unregistered = colorDisagreement(observation(view + 2, "unregistered"),
                                                  observation(view, "unregistered"),
                                                  between("unregistered", index),
                                                  585);
    EXPECT_LT(registered, unregistered) << view;
    registered_sum += registered;
    unregistered_sum += unregistered;
  }
  EXPECT_LT(registered_sum, 0.9 * unregistered_sum);
}

} // namespace
} // namespace pcl::acmap::test
