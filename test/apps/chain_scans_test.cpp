#include "chain_runs.h"
#include "e57_file.h"
#include "mcap_file.h"
#include "plane_runs.h"
#include "tool_cases.h"

#include <pcl/core/map_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/** \brief From a scanner, which looks along x with z up, to a camera. */
Eigen::Matrix3d
cameraOfScanner()
{
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return turn;
}

std::string
poseElement(const Eigen::Isometry3d& T_map_scan)
{
  const Eigen::Quaterniond q(T_map_scan.linear());
  const Eigen::Vector3d t = T_map_scan.translation();
  std::ostringstream text;
  text << std::setprecision(17) << "<pose><rotation><w>" << q.w() << "</w><x>" << q.x()
       << "</x><y>" << q.y() << "</y><z>" << q.z() << "</z></rotation><translation><x>"
       << t.x() << "</x><y>" << t.y() << "</y><z>" << t.z()
       << "</z></translation></pose>";
  return text.str();
}

/** \brief A view as the scan of a scanner with rows, columns and colours. */
WrittenScan
scanOfView(const PointCloud<PointXYZRGB>& view, const Eigen::Isometry3d& T_map_camera)
{
  WrittenScan scan;
  scan.count = view.size();
  const Eigen::Isometry3d T_camera_scan(cameraOfScanner());
  scan.more = poseElement(T_map_camera * T_camera_scan);
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    scan.prototype += std::string("<") + name + R"( type="Float" precision="single"/>)";
  scan.prototype += R"(<cartesianInvalidState type="Integer" minimum="0" maximum="2"/>)"
                    R"(<rowIndex type="Integer" minimum="0" maximum="1023"/>)"
                    R"(<columnIndex type="Integer" minimum="0" maximum="1023"/>)";
  for (const char* name : {"colorRed", "colorGreen", "colorBlue"})
    scan.prototype +=
        std::string("<") + name + R"( type="Integer" minimum="0" maximum="255"/>)";
  std::array<std::string, 3> places;
  std::array<BitStream, 6> others;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const PointXYZRGB& point = view[i];
    const bool is_valid = std::isfinite(point.x);
    const std::array<float, 3> place = {point.z, -point.x, -point.y};
    for (std::size_t axis = 0; axis < 3; ++axis)
      places[axis] += e57Bytes(is_valid ? place[axis] : 0.0F);
    others[0].add(is_valid ? 0 : 2, 2);
    others[1].add(i / view.width, 10);
    others[2].add(i % view.width, 10);
    others[3].add(point.r, 8);
    others[4].add(point.g, 8);
    others[5].add(point.b, 8);
  }
  scan.streams.assign(places.begin(), places.end());
  for (const BitStream& stream : others)
    scan.streams.push_back(stream.bytes);
  return scan;
}

void
expectSamePlanes(const CompactMap& map, const CompactMap& expected)
{
  ASSERT_EQ(map.planes.size(), expected.planes.size());
  ASSERT_GE(map.planes.size(), 3U);
  for (std::size_t i = 0; i < map.planes.size(); ++i) {
    EXPECT_LT((map.planes[i].coefficients - expected.planes[i].coefficients).norm(),
              1e-5)
        << i;
    EXPECT_NEAR(map.planes[i].area, expected.planes[i].area, 1e-3) << i;
  }
}

class ChainScans : public ChainTest {
protected:
  void
  SetUp() override
  {
    ChainTest::SetUp();
    pcds_ = posedObservations();
    poses_ = loadTrajectory(pcds_ + "/trajectory.txt").poses;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const std::string path = pcds_ + "/observation_000" + std::to_string(i) + ".pcd";
      ASSERT_EQ(io::loadPCDFile(path, views_.emplace_back()), 0);
      ASSERT_EQ(io::savePCDFileBinary(path, views_.back()), 0); // without sigma
    }
  }

  /** \brief An E57 file of the views.
   * \param[in] T_grid_map of the frame of the file */
  std::string
  scans(const Eigen::Isometry3d& T_grid_map) const
  {
    std::vector<WrittenScan> scans;
    for (std::size_t i = 0; i < views_.size(); ++i)
      scans.push_back(scanOfView(views_[i], T_grid_map * poses_[i]));
    return folder_.write("scans.e57", e57Of(scans, 60));
  }

  std::string pcds_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<PointCloud<PointXYZRGB>> views_;
  std::string out_ = folder_.path("out");
};

TEST_F(ChainScans, GiveTheMapOfTheSameCloudsAsPcds)
{
  const std::string of_pcds = folder_.path("of_pcds");
  runChain(pcds_, of_pcds).succeeded();
  runChain(scans(Eigen::Isometry3d::Identity()), out_).succeeded();
  EXPECT_THAT(stagesOf(out_), ElementsAre("observations", "rectification", "map"));
  const CompactMap map = loadMapFile(out_ + "/map.json"),
                   expected = loadMapFile(of_pcds + "/map.json");
  EXPECT_TRUE(map.shift.isZero(0));
  ASSERT_EQ(map.trajectory.poses.size(), expected.trajectory.poses.size());
  for (std::size_t i = 0; i < map.trajectory.poses.size(); ++i)
    EXPECT_TRUE(map.trajectory.poses[i].isApprox(expected.trajectory.poses[i], 1e-6));
  expectSamePlanes(map, expected);
  runChain(folder_.path("scans.e57"), out_);
  EXPECT_TRUE(madeStages(out_).empty());
}

/** \brief Rows of x y z rgb. */
std::string
rowsOf(const PointCloud<PointXYZRGB>& view)
{
  std::string rows;
  for (const PointXYZRGB& point : view)
    for (const float value : {point.x, point.y, point.z, point.rgb})
      rows += e57Bytes(value);
  return rows;
}

TEST_F(ChainScans, ABagGivesTheMapOfTheSameCloudsAsPcds)
{
  McapWriter bag;
  Trajectory from_first;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const double stamp = 1700000000 + static_cast<double>(i);
    bag.add("/tf",
            "tf2_msgs/msg/TFMessage",
            stamp,
            transformMessage(stamp, "odom", "camera_optical_frame", poses_[i]));
    bag.add("/points",
            "sensor_msgs/msg/PointCloud2",
            stamp,
            cloudMessage(stamp,
                         "camera_optical_frame",
                         views_[i].width,
                         views_[i].height,
                         rowsOf(views_[i])));
    from_first.stamps.push_back(stamp);
    from_first.poses.push_back(poses_[0].inverse() * poses_[i]);
  }
  saveTrajectory(pcds_ + "/trajectory.txt", from_first);
  const std::string of_pcds = folder_.path("of_pcds");
  runChain(pcds_, of_pcds).succeeded();
  const std::string path = folder_.write("robot.mcap", bag.finish());
  runChain(path, out_).succeeded();
  EXPECT_THAT(stagesOf(out_), ElementsAre("observations", "rectification", "map"));
  expectSamePlanes(loadMapFile(out_ + "/map.json"), loadMapFile(of_pcds + "/map.json"));
  runChain(path, out_);
  EXPECT_TRUE(madeStages(out_).empty());
  runChain(path, out_, {"--every", "2"});
  EXPECT_EQ(loadTrajectory(out_ + "/trajectory.txt").poses.size(), 2U);
  expectRefused(runChain(pcds_, folder_.path("other"), {"--every", "2"}),
                2,
                "--every: is for bags");
}

TEST_F(ChainScans, ABagWithoutPosesKeepsItsTimes)
{
  McapWriter bag;
  std::vector<double> stamps;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    stamps.push_back(1700000000.25 + 0.5 * static_cast<double>(i));
    bag.add("/points",
            "sensor_msgs/msg/PointCloud2",
            stamps.back(),
            cloudMessage(stamps.back(),
                         "camera_optical_frame",
                         views_[i].width,
                         views_[i].height,
                         rowsOf(views_[i])));
  }
  const ToolRun run = runChain(folder_.write("robot.mcap", bag.finish()), out_);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(loadTrajectory(out_ + "/trajectory.txt").stamps, stamps);
}

TEST_F(ChainScans, ABagOfLaserScansNamesItsTool)
{
  McapWriter bag;
  bag.add("/scan",
          "sensor_msgs/msg/LaserScan",
          1,
          scanMessage(1, "laser", 0, 0.1F, {1, 2, 3}));
  const std::string path = folder_.write("robot.mcap", bag.finish());
  expectRefused(runChain(path, out_), 3, "run pcl_entropy_rectification " + path);
}

TEST_F(ChainScans, CoordinatesOfANationalGridComeBack)
{
  Eigen::Isometry3d T_grid_map = Eigen::Isometry3d::Identity();
  T_grid_map.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0; // z up
  T_grid_map.translation() << 452300.25, 5411200.5, 310;
  runChain(
      scans(T_grid_map), out_, {"--no-rectification", "--formats", "dxf,ifc,geojson"})
      .succeeded();
  EXPECT_FALSE(fs::exists(out_ + "/map.html"));
  EXPECT_FALSE(fs::exists(out_ + "/floor_plan.svg"));
  const CompactMap map = loadMapFile(out_ + "/map.json");
  const Eigen::Vector3d shift(452000, 5411000, 0);
  EXPECT_EQ(map.shift, shift);
  for (std::size_t i = 0; i < poses_.size(); ++i)
    EXPECT_LT((map.trajectory.poses[i].translation() + shift -
               T_grid_map * poses_[i].translation())
                  .norm(),
              1e-6);
  // walls are near the corridor in the grid
  const auto plan = jsonOfFile(out_ + "/floor_plan.geojson");
  std::size_t walls = 0;
  for (const auto& feature : plan.at("features")) {
    if (feature.at("properties").at("kind") != "wall")
      continue;
    for (const auto& place : feature.at("geometry").at("coordinates")) {
      const Eigen::Vector2d found(place.at(0), place.at(1));
      EXPECT_LT((found - T_grid_map.translation().head<2>()).norm(), 20);
    }
    const auto& plane = map.planes.at(feature.at("properties").at("plane"));
    const auto& from = feature.at("geometry").at("coordinates").at(0);
    const Eigen::Vector3d in_map(from.at(0).get<double>() - shift.x(),
                                 from.at(1).get<double>() - shift.y(),
                                 plan.at("cut"));
    EXPECT_LT(std::abs(plane.coefficients.dot(in_map.homogeneous())), 1e-4);
    ++walls;
  }
  EXPECT_GT(walls, 0U);
  EXPECT_THAT(contentOf(out_ + "/map.ifc"),
              HasSubstr("IFCCARTESIANPOINT((452000.,5411000.,0.))"));
  EXPECT_THAT(contentOf(out_ + "/floor_plan.dxf"), HasSubstr("\n5411"));
}

TEST_F(ChainScans, ABrokenPageIsNamed)
{
  std::string bytes = contentOf(scans(Eigen::Isometry3d::Identity()));
  bytes[100 * 1024] = static_cast<char>(~bytes[100 * 1024]);
  expectRefused(runChain(folder_.write("broken.e57", bytes), out_),
                3,
                "broken.e57: is damaged: the checksum of page 100 is wrong");
}

} // namespace
} // namespace pcl::acmap::test
