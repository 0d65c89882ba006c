#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace pcl::acmap::test {
namespace {

/** Two noisy faces of a board 12 cm thick, each seen by a separate view. */
std::string
boardPcd(bool with_views)
{
  std::ostringstream rows;
  Random random(7);
  constexpr int points = 20000;
  for (int i = 0; i < points; ++i) {
    const int side = i % 2;
    rows << random.uniform() << ' ' << random.uniform() << ' '
         << (side ? 2.0 : 2.12) + 0.01 * random.normal() << ' ' << (side ? 255 : 65280);
    rows << (with_views ? side ? " 0" : " 1" : "") << '\n';
  }
  std::ostringstream text;
  text << "VERSION 0.7\nFIELDS x y z rgb" << (with_views ? " view" : "")
       << "\nSIZE 4 4 4 4" << (with_views ? " 4" : "") << "\nTYPE F F F U"
       << (with_views ? " I" : "") << "\nCOUNT 1 1 1 1" << (with_views ? " 1" : "")
       << "\nWIDTH " << points << "\nHEIGHT 1\nVIEWPOINT 0.5 0.5 0 1 0 0 0\nPOINTS "
       << points << "\nDATA ascii\n"
       << rows.str();
  return text.str();
}

class Consolidate : public testing::Test {
protected:
  std::string
  output(const std::string& name) const
  {
    return folder_.path(name);
  }

  nlohmann::json
  reportOf(const std::string& name) const
  {
    std::ifstream file(output(name));
    return nlohmann::json::parse(file);
  }

  TemporaryFolder folder_;
};

TEST_F(Consolidate, takesALengthOrAutoOrNothing)
{
  const std::string input = folder_.write("in.pcd", boardPcd(false));
  const std::string json = output("r.json");
  const auto voxelOf = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--report", json});
    const ToolRun run = runSurface(all);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return reportOf("r.json").at("consolidation").at("voxel_size").get<double>();
  };
  const double automatic = voxelOf({"--consolidate", input, output("a.ply")});
  EXPECT_GT(automatic, 0.01);
  EXPECT_EQ(voxelOf({input, output("b.ply"), "--consolidate"}), automatic);
  EXPECT_EQ(voxelOf({input, output("c.ply"), "-consolidate", "auto"}), automatic);
  EXPECT_EQ(voxelOf({input, "--consolidate=0.05", output("d.ply")}), 0.05);
  EXPECT_EQ(voxelOf({input, "--consolidate", "0.05", output("d.ply")}), 0.05);
}

TEST_F(Consolidate, refusesNonsense)
{
  const std::string input = folder_.write("in.pcd", boardPcd(false));
  for (const std::string value : {"-1", "nan", "1e10", "five"}) {
    const ToolRun run = runSurface({input, output("a.ply"), "--consolidate=" + value});
    EXPECT_EQ(run.exit_code, 2) << value;
    EXPECT_EQ(run.errorLines(), 1U) << run.err;
  }
}

TEST_F(Consolidate, keepsTheSidesOfABoardByTheTrajectoryBeside)
{
  const std::string input = folder_.write("map.pcd", boardPcd(true));
  const ToolRun without = runSurface({input, output("a.ply"), "--consolidate", "0.05"});
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_NE(without.err.find("trajectory.txt"), std::string::npos) << without.err;

  folder_.write("trajectory.txt", "0 0.5 0.5 0 0 0 0 1\n1 0.5 0.5 5 0 0 0 1\n");
  const ToolRun run = runSurface({input, output("b.ply"), "--consolidate", "0.05"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.err.empty()) << run.err;
  const PointCloudFile mesh = loadPointCloud(output("b.ply"));
  std::size_t near = 0, far = 0;
  for (std::size_t i = 0; i < mesh.points().size(); ++i) {
    near += std::abs(mesh.points()[i].z() - 2.0F) < 0.005F;
    far += std::abs(mesh.points()[i].z() - 2.12F) < 0.005F;
  }
  EXPECT_GT(near, 300U);
  EXPECT_GT(far, 300U);
  EXPECT_GT(static_cast<double>(near + far),
            0.95 * static_cast<double>(mesh.points().size()));
}

TEST_F(Consolidate, saysWhyThereIsNothing)
{
  const std::string input = folder_.write("one.xyz", "1 2 3\n1 2 3\n");
  const ToolRun run = runSurface({input, output("a.ply"), "--consolidate"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.err.find("voxel size"), std::string::npos) << run.err;
}

} // namespace
} // namespace pcl::acmap::test
