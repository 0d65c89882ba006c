#include "messages.h"
#include "sample_map.h"
#include "temporary_folder.h"
#include "textured_map.h"

#include <pcl/core/map_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <csignal>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class CompactMapFolder : public testing::Test {
protected:
  std::string
  path(const std::string& name = "") const
  {
    return folder_.path("map" + (name.empty() ? "" : "/" + name));
  }

  std::ptrdiff_t
  count() const
  {
    return std::distance(std::filesystem::directory_iterator(path()), {});
  }

  /** Saves the map with all its texels. */
  std::vector<std::string>
  save()
  {
    CompactMapOutputs outputs;
    outputs.color_tolerance = 0;
    return saveCompactMap(path(), map_, outputs);
  }

  /** The text of the place of a chart in map.json. */
  std::string
  placeOf(std::size_t chart) const
  {
    const Eigen::Vector2i place = map_.charts[chart].image_place.value();
    return "\"at\":[" + std::to_string(place.x()) + "," + std::to_string(place.y()) +
           "]";
  }

  /** Replaces a text in map.json and returns the reader's message. */
  std::string
  faultAfter(const std::string& words, const std::string& others)
  {
    save();
    std::string text = contentOf(path("map.json"));
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words;
    folder_.write("map/map.json", text.replace(at, words.size(), others));
    return fault();
  }

  std::string
  fault() const
  {
    return messageOf<InputFileException>([&] { loadCompactMap(path()); }, "no fault");
  }

  std::string
  faultOfSaving(const std::string& folder)
  {
    const CompactMap before = map_;
    try {
      saveCompactMap(folder, map_);
    }
    catch (const OutputFileException& error) {
      expectSameCharts(map_, before, true); // even the names are unchanged
      return error.what();
    }
    return "no fault";
  }

  const TemporaryFolder folder_;
  CompactMap map_ = makeTexturedMap();
};

TEST_F(CompactMapFolder, WhatWasSavedIsLoaded)
{
  map_.exposure = 1.5;
  const std::vector<std::string> names = save();
  EXPECT_EQ(names,
            (std::vector<std::string>{"map.json",
                                      "texture_0.png",
                                      "kinds_0.png",
                                      "map.obj",
                                      "map.mtl",
                                      "map.glb"}));
  EXPECT_EQ(count(), 6);
  EXPECT_EQ(map_.charts[1].image, "texture_0.png");
  EXPECT_EQ(map_.charts[1].kinds_image, "kinds_0.png");
  EXPECT_EQ(map_.charts[2].kinds_image, "");
  const CompactMap back = loadCompactMap(path());
  expectSamePlanes(back, map_);
  expectSameCharts(back, map_, true);
  EXPECT_EQ(back.exposure, 1.5);
  EXPECT_EQ(back.observations, map_.observations);
  EXPECT_EQ(back.trajectory.stamps, map_.trajectory.stamps);
}

TEST_F(CompactMapFolder, SameBytesAndOldFilesAreReplaced)
{
  const std::vector<std::string> names = saveCompactMap(path(), map_);
  std::vector<std::string> before;
  for (const std::string& name : names)
    before.push_back(contentOf(path(name)));
  folder_.write("map/map.glb", "old");
  saveCompactMap(path() + "/", map_);
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_TRUE(contentOf(path(names[i])) == before[i]) << names[i];
  EXPECT_EQ(count(), 6);
}

TEST_F(CompactMapFolder, ThePagesHaveTheExposedColours)
{
  map_.exposure =
      1.9; // the brightest value of the charts is 156: 100 texels are clipped
  save();
  const RgbImage page = loadRgbImage(path("texture_0.png"));
  for (const TextureChart& chart : map_.charts)
    for (const auto& [column, row] : {std::pair{0, 0}, {7, 3}, {29, 14}})
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(
            page.at(chart.image_place->x() + column, chart.image_place->y() + row)[k],
            std::min(255L, std::lround(1.9 * chart.colors.at(column, row)[k])));
  const CompactMap back = loadCompactMap(path());
  for (std::size_t i = 0; i < map_.charts.size(); ++i)
    for (std::size_t k = 0; k < map_.charts[i].colors.values.size(); ++k)
      EXPECT_EQ(back.charts[i].colors.values[k],
                std::min(map_.charts[i].colors.values[k],
                         static_cast<std::uint8_t>(std::lround(255 / 1.9))));
}

TEST_F(CompactMapFolder, ColoursStayWithinTheTolerance)
{
  saveCompactMap(path(), map_);
  EXPECT_GT(map_.charts[0].halvings, 0);
  const CompactMap back = loadCompactMap(path());
  for (std::size_t i = 0; i < map_.charts.size(); ++i) {
    double sum = 0;
    const std::vector<std::uint8_t>& values = map_.charts[i].colors.values;
    for (std::size_t k = 0; k < values.size(); ++k)
      sum += std::pow(double(values[k]) - back.charts[i].colors.values[k], 2);
    EXPECT_LE(std::sqrt(sum / static_cast<double>(values.size())), 1.5) << i;
    EXPECT_EQ(back.charts[i].kinds, map_.charts[i].kinds);
  }
}

TEST_F(CompactMapFolder, UnknownTexelsAreGrey)
{
  map_.charts[0].kinds.assign(map_.charts[0].kinds.size(), TexelKind::None);
  saveCompactMap(path(), map_);
  const CompactMap back = loadCompactMap(path());
  EXPECT_THAT(back.charts[0].colors.values, testing::Each(128));
  EXPECT_THAT(back.charts[0].kinds, testing::Each(TexelKind::None));
}

TEST_F(CompactMapFolder, NamesThatClimbOutAreRefused)
{
  save();
  std::filesystem::copy_file(path("texture_0.png"), folder_.path("x.png"));
  for (const std::string& name : {std::string("../x.png"),
                                  folder_.path("x.png"),
                                  std::string("..\\\\x.png"),
                                  std::string(".."),
                                  std::string("a/../../x.png")})
    EXPECT_THAT(faultAfter("texture_0.png", name),
                HasSubstr("is no name of an image in the folder"));
  EXPECT_THAT(faultAfter("kinds_0.png", "../x.png"), HasSubstr("no name"));
  const std::string fault = faultAfter("texture_0.png", std::string(1000000, 'n'));
  EXPECT_THAT(fault, HasSubstr("is no name of an image in the folder"));
  EXPECT_LT(fault.size(), path().size() + 400);
}

TEST_F(CompactMapFolder, ConstMapIsSavedAndStaysAsItIs)
{
  const CompactMap map = map_;
  const std::vector<std::string> names = saveCompactMap(path(), map);
  EXPECT_EQ(map.charts[0].image, map_.charts[0].image);
  EXPECT_FALSE(map.charts[0].image_place);
  const std::string text = contentOf(path("map.json"));
  EXPECT_EQ(saveCompactMap(path(), map_), names);
  EXPECT_TRUE(map_.charts[0].image_place);
  EXPECT_EQ(contentOf(path("map.json")), text);
}

TEST_F(CompactMapFolder, LinksThatLeadOutAreRefused)
{
  namespace fs = std::filesystem;
  saveCompactMap(path(), map_);
  fs::rename(path("texture_0.png"), path("same.png"));
  fs::create_symlink("same.png", path("texture_0.png"));
  EXPECT_EQ(fault(), "no fault");
  fs::rename(path("same.png"), folder_.path("x.png"));
  fs::remove(path("texture_0.png"));
  fs::create_symlink("../x.png", path("texture_0.png"));
  EXPECT_THAT(fault(), HasSubstr("texture_0.png: is a link to outside"));
  fs::create_directory_symlink(path(), folder_.path("alias"));
  fs::remove(path("texture_0.png"));
  fs::rename(folder_.path("x.png"), path("texture_0.png"));
  EXPECT_NO_THROW(loadCompactMap(folder_.path("alias")));
}

TEST_F(CompactMapFolder, AChartWithoutAnImageHasNoColours)
{
  save();
  const std::string words = "\"image\":\"texture_0.png\"";
  std::string text = contentOf(path("map.json"));
  const std::size_t at = text.find(words, text.find(words) + 1); // of the second chart
  folder_.write("map/map.json", text.replace(at, words.size(), "\"image\":\"\""));
  EXPECT_EQ(fault(), "no fault");
  const CompactMap back = loadCompactMap(path());
  EXPECT_THAT(back.charts[1].colors.values, testing::IsEmpty());
  EXPECT_THAT(back.charts[1].kinds, testing::IsEmpty());
  EXPECT_EQ(back.charts[1].colors.width, 30);
  EXPECT_EQ(back.charts[2].colors.values, map_.charts[2].colors.values);
}

TEST_F(CompactMapFolder, TooManyTexelsAreRefusedBeforeAnyImageIsRead)
{
  save();
  std::filesystem::remove(path("texture_0.png"));
  EXPECT_THAT(fault(), HasSubstr("texture_0.png: No such"));
  std::string text = contentOf(path("map.json"));
  for (const auto& [size, huge] :
       {std::pair{R"("width":30,"height":25)", R"("width":16384,"height":8192)"},
        {R"("width":30,"height":15)", R"("width":16384,"height":8192)"}}) {
    const std::size_t at = text.find(size);
    ASSERT_NE(at, std::string::npos) << text;
    text.replace(at, std::string(size).size(), huge);
  }
  folder_.write("map/map.json", text);
  EXPECT_THAT(fault(),
              HasSubstr("planes[1].charts[1] brings the map to 268436056 texels"));
}

TEST_F(CompactMapFolder, UnsoundPlanesAreNamed)
{
  const auto expectRefused = [&](const std::string& word, const auto& spoil) {
    CompactMap map = makeTexturedMap();
    spoil(map.planes[2]); // a plane without a chart
    EXPECT_THAT([&] { saveCompactMap(path(), map); },
                testing::ThrowsMessage<BadArgumentException>(
                    HasSubstr("plane 2 of a map is unsound: " + word)))
        << word;
    EXPECT_FALSE(std::filesystem::exists(path()));
  };
  using Plane = PlanePatch;
  expectRefused("coefficients", [](Plane& plane) { plane.coefficients[0] = NAN; });
  expectRefused("coefficients", [](Plane& plane) { plane.coefficients.setZero(); });
  expectRefused("area", [](Plane& plane) { plane.area = NAN; });
  expectRefused("polygons[0].outer has point 1",
                [](Plane& plane) { plane.polygons[0].outer[1].y() = NAN; });
  expectRefused("polygons[0].outer has 2 points",
                [](Plane& plane) { plane.polygons[0].outer.resize(2); });
}

TEST_F(CompactMapFolder, FaultyImagesAreNamed)
{
  EXPECT_THAT(faultAfter("texture_0.png", "none.png"), HasSubstr("none.png: No such"));
  EXPECT_THAT(faultAfter("texture_0.png", "map.obj"), HasSubstr("is no PNG"));
  EXPECT_THAT(faultAfter("kinds_0.png", "texture_0.png"), HasSubstr("texture_0.png"));
  save();
  const std::vector<std::uint8_t> bytes =
      encodePng(64, 64, std::vector<std::uint8_t>(64 * 64, 3));
  folder_.write("map/kinds_0.png", {bytes.begin(), bytes.end()});
  EXPECT_THAT(fault(), HasSubstr("3 is no kind of a texel"));
  EXPECT_THROW(loadCompactMap(folder_.path("nowhere")), InputFileException);
}

TEST_F(CompactMapFolder, PlacesOutsideOfThePageAreNamed)
{
  save();
  const RgbImage page = loadRgbImage(path("texture_0.png"));
  const std::string has = "texture_0.png: has " + std::to_string(page.width) + " x " +
                          std::to_string(page.height) + " pixels, the map says 30 x 20";
  // one column too far, and as far as a number can be
  for (const int column : {page.width - 29, 268435456})
    EXPECT_THAT(faultAfter(placeOf(0), "\"at\":[" + std::to_string(column) + ",0]"),
                HasSubstr(has + " of them at (" + std::to_string(column) + ", 0)"));
  EXPECT_EQ(faultAfter(placeOf(0),
                       "\"at\":[" + std::to_string(page.width - 30) + "," +
                           std::to_string(page.height - 20) + "]"),
            "no fault");
  EXPECT_THAT(faultAfter(placeOf(0), "\"at\":[-1,0]"), HasSubstr("at[0] is outside"));
  EXPECT_THAT(
      faultAfter("\"kinds_at\":[0,0]", "\"kinds_at\":[3,0]"),
      HasSubstr("kinds_0.png: has 32 x 32 pixels, the map says 30 x 25 of them"));
  // without a place, a chart is the whole image
  EXPECT_THAT(faultAfter("," + placeOf(0), ""), HasSubstr(has));
}

/** A chart that is said to be large, but is stored as one texel. */
TEST_F(CompactMapFolder, LyingSizesAreOfNoHarm)
{
  EXPECT_THAT(
      faultAfter("\"width\":30,\"height\":20", "\"width\":3000,\"height\":2000"),
      HasSubstr("pixels, the map says 3000 x 2000 of them at"));
  EXPECT_THAT(faultAfter("\"width\":30,\"height\":20,",
                         "\"width\":3000,\"height\":2000,\"halvings\":29,"),
              HasSubstr("is halved 29 times"));
  EXPECT_EQ(faultAfter("\"width\":30,\"height\":20,",
                       "\"width\":3000,\"height\":2000,\"halvings\":12,"),
            "no fault");
}

/** A map of format 1, with one image per chart. */
TEST_F(CompactMapFolder, MapsWithOneImagePerChartAreRead)
{
  saveCompactMap(path(), map_);
  for (std::size_t i = 0; i < map_.charts.size(); ++i) {
    TextureChart& chart = map_.charts[i];
    chart.image = "texture_000" + std::to_string(i) + ".png";
    chart.image_place.reset();
    chart.halvings = 0;
    savePng(path(chart.image), chart.colors);
    if (chart.kinds_image.empty())
      continue;
    chart.kinds_image = "texture_000" + std::to_string(i) + "_kinds.png";
    chart.kinds_place.reset();
    std::vector<std::uint8_t> kinds;
    for (const TexelKind kind : chart.kinds)
      kinds.push_back(static_cast<std::uint8_t>(kind));
    savePng(path(chart.kinds_image), chart.colors.width, chart.colors.height, kinds);
  }
  saveMapFile(path("map.json"), map_);
  expectSameCharts(loadCompactMap(path()), map_, true);
}

TEST_F(CompactMapFolder, NonsenseIsRefused)
{
  const auto expectRefused = [&](const auto& spoil) {
    CompactMap map = makeTexturedMap();
    CompactMapOutputs outputs;
    spoil(map, outputs);
    EXPECT_THROW(saveCompactMap(path(), map, outputs), BadArgumentException);
    EXPECT_FALSE(std::filesystem::exists(path()));
  };
  using Outputs = CompactMapOutputs;
  expectRefused([](CompactMap&, Outputs& outputs) { outputs.jpeg_quality = 0; });
  expectRefused([](CompactMap&, Outputs& outputs) { outputs.jpeg_quality = 101; });
  expectRefused([](CompactMap&, Outputs& outputs) { outputs.color_tolerance = -1; });
  expectRefused([](CompactMap&, Outputs& outputs) { outputs.color_tolerance = NAN; });
  expectRefused([](CompactMap& map, Outputs&) { map.exposure = 0; });
  expectRefused([](CompactMap& map, Outputs&) { map.exposure = NAN; });
  expectRefused([](CompactMap& map, Outputs&) { map.charts[0].kinds.pop_back(); });
  expectRefused([](CompactMap& map, Outputs&) {
    map.charts[0].colors.values.clear();
    map.charts[0].kinds.clear();
  });
  expectRefused([](CompactMap& map, Outputs&) { map.charts[0].plane = 9; });
  expectRefused([](CompactMap& map, Outputs&) { map.charts[0].texel_u.setZero(); });
  expectRefused([](CompactMap& map, Outputs&) { map.charts[0].colors.width = 31; });
  expectRefused(
      [](CompactMap& map, Outputs&) { map.planes[0].coefficients.setZero(); });
}

TEST_F(CompactMapFolder, PlacesThatCannotBeAreNamed)
{
  EXPECT_THAT(faultOfSaving(folder_.path("no/map")), HasSubstr("no/map: No such"));
  EXPECT_THAT(faultOfSaving(folder_.write("file", "x")), HasSubstr("is a file"));
  EXPECT_THAT(faultOfSaving(""), HasSubstr("names no folder"));
  EXPECT_EQ(folder_.count(), 1);
  std::filesystem::create_directories(path("map.glb"));
  EXPECT_THAT(faultOfSaving(path()), HasSubstr("map.glb: is a folder"));
  EXPECT_EQ(count(), 1);
}

TEST_F(CompactMapFolder, ReadOnlyFolder)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "the superuser may write everywhere";
  std::filesystem::create_directory(path());
  ::chmod(path().c_str(), 0500);
  EXPECT_THAT(faultOfSaving(path()), HasSubstr("Permission denied"));
  ::chmod(path().c_str(), 0700);
  EXPECT_EQ(count(), 0);
}

TEST_F(CompactMapFolder, FullDiskLeavesTheFolderAsItWas)
{
  std::filesystem::create_directory(path());
  folder_.write("map/map.json", "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  for (const rlim_t bytes : {0U, 100U, 1500U, 2500U}) {
    const rlimit limit{bytes, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string text = faultOfSaving(path());
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(text, HasSubstr(path("")));
    EXPECT_THAT(text, HasSubstr("File too large"));
    EXPECT_THAT(text, testing::Not(HasSubstr(".acmap")));
    EXPECT_EQ(contentOf(path("map.json")), "old");
    EXPECT_EQ(count(), 1);
  }
  std::signal(SIGXFSZ, SIG_DFL);
}

} // namespace
} // namespace pcl::acmap::test
