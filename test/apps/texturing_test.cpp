#include "compact_map_runs.h"
#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/file_format.h>
#include <pcl/texture/compact_map_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

ToolRun
paint(const std::string& observations,
      const std::string& output,
      const std::vector<std::string>& more = {})
{
  return runTexturing(joined({corridor().planes, observations, "-o", output}, more));
}

std::size_t
countOf(const CompactMap& map, TexelKind kind)
{
  std::size_t count = 0;
  for (const TextureChart& chart : map.charts)
    count += static_cast<std::size_t>(
        std::count(chart.kinds.begin(), chart.kinds.end(), kind));
  return count;
}

TEST(PlaneTexturingTool, PaintsPlanesAsTheChainDoes)
{
  const TemporaryFolder folder;
  const ToolRun run =
      paint(corridor().session, folder.path("t"), {"--report", folder.path("r.json")})
          .succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("painted:"));
  const CompactMap map = loadCompactMap(folder.path("t"));
  const CompactMap chain = loadCompactMap(corridor().map);
  ASSERT_EQ(map.charts.size(), chain.charts.size());
  EXPECT_EQ(map.observations, chain.observations);
  EXPECT_NEAR(static_cast<double>(countOf(map, TexelKind::Seen)),
              static_cast<double>(countOf(chain, TexelKind::Seen)),
              0.001 * static_cast<double>(countOf(chain, TexelKind::Seen)));
  EXPECT_GT(jsonOfFile(folder.path("r.json")).at("texture").at("seen"), 50000);
}

TEST(PlaneTexturingTool, OptionsDoWhatTheySay)
{
  const TemporaryFolder folder;
  const auto mapOf = [&](const std::vector<std::string>& more) {
    fs::remove_all(folder.path("t"));
    const ToolRun run = paint(corridor().session, folder.path("t"), more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return loadCompactMap(folder.path("t"));
  };
  const CompactMap plain = mapOf({});
  EXPECT_GT(countOf(plain, TexelKind::Filled), 0u);
  const CompactMap coarse = mapOf({"--texel", "0.1"});
  EXPECT_NEAR(coarse.charts[0].texel_u.norm(), 0.1, 1e-9);
  for (const TextureChart& chart : mapOf({"--max-texture", "64"}).charts)
    EXPECT_LE(std::max(chart.colors.width, chart.colors.height), 64);
  EXPECT_LT(countOf(mapOf({"--fill", "0"}), TexelKind::Filled),
            countOf(plain, TexelKind::Filled));
  EXPECT_EQ(mapOf({"--jpeg", "--ply"}).charts.size(), plain.charts.size());
  EXPECT_TRUE(fs::exists(folder.path("t/map.ply")));
  EXPECT_TRUE(fs::exists(folder.path("t/texture_0.jpg")));
}

TEST(PlaneTexturingTool, OneCloudInTheFrameOfThePlanesDoes)
{
  const TemporaryFolder folder;
  const ToolRun run = paint(corridor().merged, folder.path("t")).succeeded();
  EXPECT_EQ(run.err, "");
  const CompactMap map = loadCompactMap(folder.path("t"));
  EXPECT_GT(countOf(map, TexelKind::Seen), 50000u);
  EXPECT_TRUE(map.trajectory.poses.empty());
}

TEST(PlaneTexturingTool, ColourlessOrStrangeCloudsAreTold)
{
  const TemporaryFolder folder;
  const ToolRun grey = paint(folder.write("room.pcd", roomPcd()), folder.path("t"));
  EXPECT_EQ(grey.exit_code, 0) << grey.err;
  EXPECT_THAT(grey.err, HasSubstr("no observation has colour"));
  EXPECT_EQ(countOf(loadCompactMap(folder.path("t")), TexelKind::Seen), 0u);
  const ToolRun far = paint(corridor().merged, folder.path("f"), {"--scale", "1000"});
  EXPECT_EQ(far.exit_code, 0) << far.err;
  EXPECT_THAT(far.err, HasSubstr("no observation saw a plane"));
}

TEST(PlaneTexturingTool, PlanesOfNoUseAreRefused)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& planes,
                          int code,
                          const std::string& word) {
    expectRefused(
        runTexturing({planes, corridor().session, "-o", folder.path("t")}), code, word);
  };
  refuse(folder.path("none.json"), 3, "none.json");
  refuse(folder.write("g.json", "garbage"), 3, "g.json");
  refuse(folder.write("e.json", ""), 3, "e.json");
  const std::string whole = contentOf(corridor().planes);
  refuse(folder.write("half.json", whole.substr(0, whole.size() / 2)), 3, "half.json");
  std::string newer = whole;
  const std::string own = "\"format\":" + std::to_string(file_formats::map);
  const std::size_t format = newer.find(own);
  ASSERT_NE(format, std::string::npos);
  newer.replace(format, own.size(), "\"format\":99");
  refuse(folder.write("newer.json", newer), 3, "99");
  refuse(folder.write("no.json", R"({"version":"0.1.0","planes":[]})"), 4, "no plane");
  EXPECT_FALSE(fs::exists(folder.path("t")));
}

TEST(PlaneTexturingTool, HugePlanesAreRefusedForMemoryOrSize)
{
  const TemporaryFolder folder;
  const std::string planes =
      R"({"version":"0.1.0","unit":"m","planes":[{"id":0,"coefficients":[0,0,-1,3],)"
      R"("center":[0,0,3],"axes":[[1,0,0],[0,-1,0]],)"
      R"("covariance":[[0,0,0],[0,0,0],[0,0,0]],"support":9,"effective_support":9,)"
      R"("rmse":0,"area":1e12,"polygons":[{"outer":)"
      R"([[0,0,3],[0,1e6,3],[1e6,1e6,3],[1e6,0,3]],"holes":[]}]}]})";
  const ToolRun run = runTexturing(
      {folder.write("p.json", planes), corridor().session, "-o", folder.path("t")});
  expectRefused(run, 6, "painting the planes");
}

TEST(PlaneTexturingTool, BrokenObservationsStopOrAreSkipped)
{
  const TemporaryFolder folder;
  const std::string session = copyOfSession(folder.path("s"));
  const std::string whole = contentOf(observation(session, 2));
  folder.write("s/observation_0002.pcd", whole.substr(0, whole.size() - 100));
  expectRefused(paint(session, folder.path("t")), 3, "observation_0002.pcd");
  EXPECT_EQ(folder.count(), 1);
  const ToolRun run = paint(session, folder.path("t"), {"--skip-broken"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("left out: "));
  EXPECT_THAT(run.err, HasSubstr("observation_0002.pcd"));
  EXPECT_EQ(loadCompactMap(folder.path("t")).trajectory.poses.size(), 3u);
}

TEST(PlaneTexturingTool, PlacesThatCannotBeAreRefused)
{
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  expectRefused(paint(corridor().session, file), 5, "file");
  EXPECT_EQ(contentOf(file), "mine");
  expectRefused(paint(corridor().session, folder.path("no/t")), 5, "no/t");
  expectRefused(paint(folder.path("none"), folder.path("t")), 3, "none");
  expectRefused(paint(folder.path("none.pcd"), folder.path("t")), 3, "none.pcd");
  expectRefused(paint(corridor().session, folder.path("t"), {"--shiny"}), 2, "--help");
  expectRefused(paint(corridor().session, folder.path("t"), {"--quality", "101"}),
                2,
                "--quality");
  expectRefused(runTexturing({corridor().planes}), 2, "--help");
  EXPECT_EQ(folder.count(), 1);
}

TEST(PlaneTexturingTool, InterruptionLeavesNothing)
{
  const TemporaryFolder folder;
  RunSettings interrupted;
  interrupted.interrupt_after = 0.1;
  expectRefused(runTexturing({corridor().planes,
                              corridor().session,
                              "-o",
                              folder.path("t"),
                              "--texel",
                              "0.005"},
                             interrupted),
                130,
                "interrupted");
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
