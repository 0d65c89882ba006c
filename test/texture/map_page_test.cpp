#include "run_tool.h"
#include "temporary_folder.h"
#include "textured_map.h"

#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/map_page.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class MapPage : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!hasMapPage())
      GTEST_SKIP() << "acmap was built without the modules of its page";
    map_ = makeTexturedMap();
    map_.trajectory.stamps = {0, 1};
    map_.trajectory.poses.assign(2, Eigen::Isometry3d::Identity());
    saveCompactMap(folder_.path("map"), map_);
    page_ = folder_.path("map.html");
    saveMapPage(page_, folder_.path("map"), map_.trajectory);
  }

  CompactMap map_;
  TemporaryFolder folder_;
  std::string page_;
};

TEST_F(MapPage, HoldsAllThatItShows)
{
  const std::string text = contentOf(page_);
  std::size_t map_bytes = std::filesystem::file_size(folder_.path("map/map.json"));
  map_bytes += (std::filesystem::file_size(folder_.path("map/map.glb")) + 2) / 3 * 4;
  EXPECT_LT(text.size() - map_bytes, 1000000U);
  for (const char* mark :
       {"{{map}}", "{{script}}", "{{glb}}", "{{kinds}}", "{{style}}"})
    EXPECT_EQ(text.find(mark), std::string::npos) << mark << " is missing";
  for (const char* outside : {"src=\"http", "href=\"http", "@import"})
    EXPECT_EQ(text.find(outside), std::string::npos) << outside;
  EXPECT_THAT(text, HasSubstr("id=\"kinds_json\">{\"kinds_0.png\":\"iVBORw0KGgo"));
  EXPECT_THAT(text, HasSubstr("Permission is hereby granted, free of charge"));
  saveMapPage(page_, folder_.path("map"), {});
  EXPECT_THAT(contentOf(page_), HasSubstr("id=\"before_json\">[]<"));
}

/** What a map says can neither end an element nor be taken for a mark of the page. */
TEST_F(MapPage, TextOfTheMapStaysText)
{
  const std::string file = folder_.path("map/map.json");
  std::string json = contentOf(file);
  json.insert(json.find('{') + 1, R"("note":"</script>{{glb}} {{none}} \"&",)");
  std::ofstream(file) << json;
  saveMapPage(page_, folder_.path("map"));
  const std::string text = contentOf(page_);
  EXPECT_THAT(text, HasSubstr(R"("note":"\u003c/script>{{glb}} {{none}} \"&")"));
  EXPECT_THAT(text, HasSubstr("id=\"map_glb\">Z2xURg"));
}

TEST_F(MapPage, NeedsAMap)
{
  EXPECT_THROW(saveMapPage(page_, folder_.path("none")), InputFileException);
  EXPECT_THROW(saveMapPage(folder_.path("none/page.html"), folder_.path("map")),
               OutputFileException);
  std::filesystem::remove(folder_.path("map/kinds_0.png"));
  EXPECT_THROW(saveMapPage(page_, folder_.path("map")), InputFileException);
  saveCompactMap(folder_.path("map"), map_);
  std::filesystem::remove(folder_.path("map/map.glb"));
  EXPECT_THROW(saveMapPage(page_, folder_.path("map")), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
