#include "compact_map_runs.h"

#include "temporary_folder.h"

#include <pcl/io/pcd_io.h>

#include <filesystem>

namespace pcl::acmap::test {

ToolRun
runMapping(const std::vector<std::string>& arguments, RunSettings settings)
{
  if (settings.environment.empty())
    settings.environment = {{"DISPLAY", std::nullopt}};
  return runTool(ACMAP_COMPACT_MAPPING, arguments, settings);
}

ToolRun
runTexturing(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_PLANE_TEXTURING, arguments, settings);
}

const Corridor&
corridor()
{
  static const TemporaryFolder folder;
  static const Corridor corridor = [] {
    Corridor made;
    made.session = folder.path("session");
    made.merged = folder.path("merged.pcd");
    made.map = folder.path("map");
    made.planes = made.map + "/map.json";
    const ToolRun rig = runTool(ACMAP_SIMULATED_RIG,
                                {"-o",
                                 made.session,
                                 "--clouds",
                                 "--observations",
                                 "4",
                                 "--merged",
                                 made.merged});
    EXPECT_EQ(rig.exit_code, 0) << rig.err;
    made.run = runMapping({made.session, "-o", made.map});
    EXPECT_EQ(made.run.exit_code, 0) << made.run.err;
    return made;
  }();
  return corridor;
}

std::string
copyOfSession(const std::string& folder)
{
  std::filesystem::copy(corridor().session, folder);
  return folder;
}

std::string
observation(const std::string& session, int number)
{
  return session + "/observation_000" + std::to_string(number) + ".pcd";
}

void
changeViewpoint(const std::string& path,
                const std::function<void(PointCloud<PointXYZRGB>&)>& change)
{
  PointCloud<PointXYZRGB> cloud;
  ASSERT_EQ(io::loadPCDFile(path, cloud), 0);
  change(cloud);
  ASSERT_EQ(io::savePCDFileBinary(path, cloud), 0);
}

} // namespace pcl::acmap::test
