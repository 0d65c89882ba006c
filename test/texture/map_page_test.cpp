#include "run_tool.h"
#include "temporary_folder.h"
#include "textured_map.h"

#include <pcl/core/image_file.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/map_page.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class MapPage : public testing::Test {
protected:
  MapPage()
  {
    CompactMap map = makeTexturedMap();
    map.trajectory.stamps = {0, 1};
    map.trajectory.poses.assign(2, Eigen::Isometry3d::Identity());
    saveCompactMap(folder_.path("map"), map);
    page_ = folder_.path("map.html");
    saveMapPage(page_, folder_.path("map"), map.trajectory);
  }

  TemporaryFolder folder_;
  std::string page_;
};

TEST_F(MapPage, HoldsAllThatItShows)
{
  const std::string text = contentOf(page_);
  std::size_t map_bytes = std::filesystem::file_size(folder_.path("map/map.json"));
  map_bytes += (std::filesystem::file_size(folder_.path("map/map.glb")) + 2) / 3 * 4;
  EXPECT_LT(text.size() - map_bytes, 1000000U);
  EXPECT_EQ(text.find("{{"), std::string::npos) << "a part is missing";
  for (const char* outside : {"src=\"http", "href=\"http", "@import"})
    EXPECT_EQ(text.find(outside), std::string::npos) << outside;
  saveMapPage(page_, folder_.path("map"), {});
  EXPECT_THAT(contentOf(page_), HasSubstr("id=\"before_json\">[]<"));
}

TEST_F(MapPage, NeedsAMap)
{
  EXPECT_THROW(saveMapPage(page_, folder_.path("none")), InputFileException);
  EXPECT_THROW(saveMapPage(folder_.path("none/page.html"), folder_.path("map")),
               OutputFileException);
  std::filesystem::remove(folder_.path("map/map.glb"));
  EXPECT_THROW(saveMapPage(page_, folder_.path("map")), InputFileException);
}

/** A browser shows the page, and its middle is clicked. */
TEST_F(MapPage, IsShownAndClickedInABrowser)
{
  constexpr const char* browser = "/usr/bin/chromium";
  if (!std::filesystem::exists(browser))
    GTEST_SKIP() << "there is no " << browser;
  constexpr const char* click = R"(<script>
setInterval(() => {
  if (document.body.dataset.state !== 'shown' || document.body.dataset.clicked)
    return;
  const canvas = document.querySelector('canvas');
  const at = {clientX: window.innerWidth / 2, clientY: window.innerHeight / 2};
  canvas.dispatchEvent(new PointerEvent('pointerdown', at));
  canvas.dispatchEvent(new PointerEvent('pointerup', at));
  document.body.dataset.clicked = document.getElementById('name').textContent;
}, 50);
</script>)";
  std::ofstream(page_, std::ios::app) << click;
  const auto browse = [&](const std::string& what) {
    RunSettings settings;
    settings.time_limit = 100;
    return runTool(browser,
                   {"--headless=new",
                    "--no-sandbox",
                    "--disable-dev-shm-usage",
                    "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader",
                    "--user-data-dir=" + folder_.path("profile"),
                    "--window-size=400,300",
                    "--virtual-time-budget=10000",
                    what,
                    "file://" + page_},
                   settings);
  };
  const ToolRun run = browse("--dump-dom");
  EXPECT_THAT(run.out, HasSubstr("data-state=\"shown\"")) << run.err;
  EXPECT_THAT(run.out, HasSubstr("data-clicked=\"plane ")) << run.err;
  EXPECT_THAT(run.out, HasSubstr("root mean square"));
  browse("--screenshot=" + folder_.path("page.png"));
  const RgbImage picture = loadRgbImage(folder_.path("page.png"));
  std::set<std::uint8_t> levels(picture.values.begin(), picture.values.end());
  EXPECT_GT(levels.size(), 50U) << "the picture is empty";
}

} // namespace
} // namespace pcl::acmap::test
