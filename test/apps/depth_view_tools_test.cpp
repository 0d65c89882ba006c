#include "depth_room.h"
#include "plane_runs.h"
#include "temporary_folder.h"
#include "test_data.h"
#include "tool_cases.h"

#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

// Results of the tools for one view with quantised depth, with their defaults.

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class DepthViewTools : public testing::Test {
protected:
  /** \param[in] shift metres along x, out of the sensor's frame */
  std::string
  writeRoom(const DepthRoom::Camera& camera, bool organized = true, float shift = 0)
  {
    PointCloud<PointXYZ> cloud;
    for (const Eigen::Vector3f& point : DepthRoom(camera).points)
      cloud.push_back({point.x() + shift, point.y(), point.z()});
    if (organized) {
      cloud.width = DepthRoom::width;
      cloud.height = DepthRoom::height;
    }
    const std::string path = folder_.path("view.pcd");
    io::savePCDFileBinary(path, cloud);
    return path;
  }

  nlohmann::json
  planesOf(const std::string& view, std::vector<std::string> more = {})
  {
    std::vector<std::string> arguments = joined({view, json_}, more);
    run_ = runPlanes(arguments);
    EXPECT_EQ(run_.exit_code, 0) << run_.err;
    return run_.exit_code == 0 ? jsonOfFile(json_).at("planes") : nlohmann::json();
  }

  TemporaryFolder folder_;
  std::string json_ = folder_.path("planes.json");
  ToolRun run_;
};

TEST_F(DepthViewTools, aQuantisedViewHasItsPlanes)
{
  const DepthRoom room({});
  const std::string labels = folder_.path("labels.pcd");
  const nlohmann::json planes = planesOf(writeRoom({}), {"--labels", labels});
  EXPECT_EQ(planes.size(), room.planes.size());
  EXPECT_THAT(run_.out, HasSubstr("quantised, steps of 11.6 mm at 2 m"));
  EXPECT_EQ(run_.err, "");
  for (const DepthRoom::Plane& plane : room.planes) {
    Eigen::Vector4d truth;
    truth << -plane.normal, plane.distance;
    EXPECT_FALSE(matchOf(planes, truth, 1.5, 0.03).is_null());
  }
  std::size_t labelled = 0;
  for (const std::uint32_t label : labelsOfFile(labels)) {
    EXPECT_LE(label, planes.size());
    labelled += label > 0 ? 1 : 0;
  }
  EXPECT_GT(labelled, 0.95 * static_cast<double>(room.points.size()));
}

TEST_F(DepthViewTools, theSensorMayBeNamed)
{
  DepthRoom::Camera smooth;
  smooth.step = 0;
  const std::string view = writeRoom(smooth);
  EXPECT_EQ(planesOf(view, {"--sensor", "stereo"}).size(), 5u);
  EXPECT_THAT(run_.out, HasSubstr("not quantised"));
  planesOf(view);
  EXPECT_THAT(run_.out, Not(HasSubstr("depth:"))) << "in space";
  planesOf(writeRoom({}), {"--sensor", "laser"});
  EXPECT_THAT(run_.out, Not(HasSubstr("depth:")));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--sensor", "sonar"},
        {"--sensor", "stereo", "--tolerance", "0.02"},
        {"--sensor", "quantised", "--paper"}}) {
    std::vector<std::string> arguments = joined({view, json_}, more);
    const ToolRun refused = runPlanes(arguments);
    EXPECT_EQ(refused.exit_code, 2) << more[1];
    EXPECT_THAT(refused.err, HasSubstr("--sensor"));
  }
  const ToolRun row =
      runPlanes({writeRoom({}, false, 0.3F), json_, "--sensor", "quantised"});
  EXPECT_EQ(row.exit_code, 2);
  EXPECT_THAT(row.err, HasSubstr("in its sensor's frame"));
}

TEST_F(DepthViewTools, aViewWithoutItsRowsIsPutBackIntoItsPicture)
{
  const std::string labels = folder_.path("labels.pcd");
  const nlohmann::json expected = planesOf(writeRoom({}), {"--labels", labels});
  const std::vector<std::uint32_t> of_pixels = labelsOfFile(labels);
  const std::string view = writeRoom({}, false);
  EXPECT_EQ(planesOf(view, {"--labels", labels}), expected);
  EXPECT_EQ(run_.err, "");
  EXPECT_EQ(labelsOfFile(labels), of_pixels);
  const ToolRun mesh =
      runSurface({view, folder_.path("mesh.ply"), "--consolidate"}).succeeded();
  EXPECT_THAT(mesh.out, HasSubstr("refined:"));
}

TEST_F(DepthViewTools, unorganizedStepsAreConsolidatedAndTold)
{
  const nlohmann::json planes = planesOf(writeRoom({}, false, 0.3F));
  EXPECT_THAT(run_.err, HasSubstr("the depth is quantised"));
  EXPECT_THAT(run_.out, HasSubstr("consolidated:"));
  EXPECT_LT(planes.size(), 10u);
}

TEST_F(DepthViewTools, theMeshHasNoSteps)
{
  const std::string mesh = folder_.path("mesh.ply");
  const std::string view = writeRoom({});
  const ToolRun run = runSurface({view, mesh, "--consolidate"}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("refined:"));
  const DepthRoom room({});
  const PointCloudFile vertices = loadPointCloud(mesh);
  ASSERT_EQ(vertices.points().size(), room.points.size());
  double squares = 0, raw = 0;
  for (std::size_t i = 0; i < room.points.size(); ++i) {
    const double z = static_cast<double>(vertices.points()[i].z());
    if (std::isfinite(z)) {
      squares += std::pow(z - room.true_depths[i], 2);
      raw += std::pow(room.points[i].z() - room.true_depths[i], 2);
    }
  }
  EXPECT_LT(squares, 0.2 * raw);

  const ToolRun as_it_is = runSurface({view, mesh}).succeeded();
  EXPECT_THAT(as_it_is.err, HasSubstr("--consolidate takes them out"));
}

TEST_F(DepthViewTools, theOfficeHasFloorAndWallsAndNoLayers)
{
  const std::string office = "E_meshing/office1.pcd";
  if (!hasTestData(office))
    GTEST_SKIP() << office << " is not in the folder that ACMAP_TEST_DATA names";
  const nlohmann::json planes = planesOf(testDataPath(office));
  EXPECT_LE(planes.size(), 20u);
  std::size_t faced = 0;
  for (const nlohmann::json& plane : planes) {
    EXPECT_GT(plane.at("rmse").get<double>(), 1e-4);
    faced += std::abs(plane.at("coefficients").at(2).get<double>()) > 0.9999 ? 1 : 0;
  }
  EXPECT_EQ(faced, 0u) << "layers look along the optical axis";
  const auto at = [&](double x, double y, double z, double d) {
    return matchOf(planes, Eigen::Vector4d(x, y, z, d), 3, 0.1);
  };
  // from the prototype of section 15 of the mathematics: wall, side wall, floor
  EXPECT_FALSE(at(-0.06, -0.025, -0.998, 4.89).is_null());
  EXPECT_FALSE(at(-0.98, -0.019, -0.196, 1.53).is_null());
  EXPECT_FALSE(at(-0.08, -0.997, 0.008, 1.34).is_null());
}

} // namespace
} // namespace pcl::acmap::test
