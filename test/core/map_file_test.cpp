#include "json_file.h"
#include "messages.h"
#include "sample_map.h"
#include "temporary_folder.h"

#include <pcl/core/build_config.h>
#include <pcl/core/map_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** Planes only, as written by an older version. */
constexpr const char* old_file =
    R"({"version":"0.1.0","unit":"m","frame":"of the input","planes":[
{"id":0,"coefficients":[0.0,0.6,-0.8,1.5],"center":[0.1,0.2,2.0],"axes":[[1.0,0.0,0.0],[0.0,0.8,0.6]],"covariance":[[null,null,null],[null,null,null],[null,null,null]],"support":7,"effective_support":0.5,"rmse":null,"area":0.5,"polygons":[{"outer":[[0.1,0.2,1e-08],[1.0,0.0,0.0],[16777217.0,3.3333333,0.0]],"holes":[[[0.25,0.1,0.0],[0.0,0.0,0.0],[1.0,1.0,1.0]]]}]},
{"id":1,"coefficients":[0.0,0.0,1.0,0.0],"center":[0.0,0.0,0.0],"axes":[[1.0,0.0,0.0],[0.0,1.0,0.0]],"covariance":[[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0]],"support":0,"effective_support":0.0,"rmse":0.0,"area":0.0,"polygons":[]}
]}
)";

class MapFile : public testing::Test {
protected:
  CompactMap
  load(const std::string& text) const
  {
    return loadMapFile(folder_.write("map.json", text));
  }

  CompactMap
  reloaded(const CompactMap& map) const
  {
    saveMapFile(folder_.path("map.json"), map);
    return loadMapFile(folder_.path("map.json"));
  }

  std::string
  faultOf(const std::string& text) const
  {
    try {
      load(text);
    }
    catch (const InputFileException& exception) {
      EXPECT_THAT(exception.what(), HasSubstr(folder_.path("map.json") + ": "));
      return exception.what();
    }
    return "no fault";
  }

  /** Error message after replacing a value in the sample's file. */
  std::string
  faultAt(const std::string& pointer, const nlohmann::json& value) const
  {
    saveMapFile(folder_.path("map.json"), makeSampleMap());
    auto json = jsonOfFile(folder_.path("map.json"));
    json.at(nlohmann::json::json_pointer(pointer)) = value;
    return faultOf(json.dump());
  }

  const TemporaryFolder folder_;
};

TEST_F(MapFile, EverythingComesBack)
{
  const CompactMap map = makeSampleMap();
  const CompactMap back = reloaded(map);
  expectSamePlanes(back, map);
  expectSameCylinders(back, map);
  expectSameBoxes(back, map);
  expectSameRecesses(back, map);
  expectSameCharts(back, map, false);
  EXPECT_EQ(back.exposure, map.exposure);
  EXPECT_EQ(back.up, map.up);
  EXPECT_EQ(back.observations, map.observations);
  EXPECT_EQ(back.trajectory.stamps, map.trajectory.stamps);
  ASSERT_EQ(back.trajectory.poses.size(), map.trajectory.poses.size());
  for (std::size_t i = 0; i < map.trajectory.poses.size(); ++i) {
    EXPECT_EQ(back.trajectory.poses[i].translation(),
              map.trajectory.poses[i].translation());
    EXPECT_TRUE(back.trajectory.poses[i].isApprox(map.trajectory.poses[i], 1e-15));
  }
}

TEST_F(MapFile, RoomsComeBack)
{
  CompactMap map = makeSampleMap();
  const CompactMap back = reloaded(map);
  ASSERT_EQ(back.rooms.size(), map.rooms.size());
  for (std::size_t i = 0; i < map.rooms.size(); ++i) {
    EXPECT_EQ(back.rooms[i].center, map.rooms[i].center);
    EXPECT_EQ(back.rooms[i].area, map.rooms[i].area);
    EXPECT_EQ(back.rooms[i].seen_area, map.rooms[i].seen_area);
    EXPECT_EQ(back.rooms[i].planes, map.rooms[i].planes);
    EXPECT_EQ(back.rooms[i].openings, map.rooms[i].openings);
    expectSameLabel(back.rooms[i].label, map.rooms[i].label);
  }
  ASSERT_EQ(back.openings.size(), map.openings.size());
  for (std::size_t i = 0; i < map.openings.size(); ++i) {
    EXPECT_EQ(back.openings[i].from, map.openings[i].from);
    EXPECT_EQ(back.openings[i].to, map.openings[i].to);
    EXPECT_EQ(back.openings[i].bottom, map.openings[i].bottom);
    EXPECT_EQ(back.openings[i].kind, map.openings[i].kind);
    EXPECT_EQ(back.openings[i].planes, map.openings[i].planes);
    EXPECT_EQ(back.openings[i].rooms, map.openings[i].rooms);
    expectSameLabel(back.openings[i].label, map.openings[i].label);
  }
  EXPECT_EQ(back.openings[0].top, map.openings[0].top);
  EXPECT_TRUE(std::isnan(back.openings[1].top));
  map.openings.clear();
  map.rooms[0].openings.clear();
  EXPECT_EQ(reloaded(map).rooms.size(), map.rooms.size());
}

TEST_F(MapFile, FloatsComeBackToTheBit)
{
  CompactMap map = makeSampleMap();
  Random random(9);
  std::vector<Eigen::Vector3f>& loop = map.planes[0].polygons[0].outer;
  while (loop.size() < 3000) {
    const auto bits = static_cast<std::uint32_t>(random.bits());
    Eigen::Vector3f point(0, -0.0F, 1);
    std::memcpy(point.data(), &bits, sizeof(bits));
    if (point.allFinite())
      loop.push_back(point);
  }
  expectSamePlanes(reloaded(map), map);
}

TEST_F(MapFile, AnAssumedUpDirectionIsNone)
{
  CompactMap map = makeSampleMap();
  map.up.setZero();
  map.assumed_up = Eigen::Vector3d::UnitY();
  const CompactMap back = reloaded(map);
  EXPECT_EQ(back.up, Eigen::Vector3d::Zero());
  EXPECT_EQ(back.assumed_up, Eigen::Vector3d::UnitY());
  map.assumed_up *= 2;
  EXPECT_THROW(reloaded(map), BadArgumentException);
}

TEST_F(MapFile, PlanesAloneAreWrittenAsEverWithUpAndShift)
{
  CompactMap map = load(old_file);
  ASSERT_EQ(map.planes.size(), 2u);
  EXPECT_EQ(map.planes[0].coefficients, Eigen::Vector4d(0, 0.6, -0.8, 1.5));
  EXPECT_TRUE(map.planes[0].covariance.array().isNaN().all());
  EXPECT_TRUE(std::isnan(map.planes[0].rms));
  EXPECT_EQ(map.planes[0].polygons.at(0).outer.at(2).x(), 16777217.0F);
  EXPECT_TRUE(map.charts.empty());
  EXPECT_EQ(map.observations.size(), 2u);
  saveMapFile(folder_.path("again.json"), map);
  std::string wanted = old_file;
  wanted.replace(wanted.find("0.1.0"), 5, ACMAP_VERSION);
  wanted.insert(wanted.find(R"("planes")"), R"("up":null,"shift":[0.0,0.0,0.0],)");
  EXPECT_EQ(contentOf(folder_.path("again.json")), [&] {
    // The float closest to 16777217 is 16777216.
    return wanted.replace(wanted.find("16777217"), 8, "16777216");
  }());
}

TEST_F(MapFile, EmptyMap)
{
  const CompactMap back = reloaded({});
  EXPECT_TRUE(back.planes.empty());
  EXPECT_TRUE(back.charts.empty());
  EXPECT_TRUE(back.trajectory.poses.empty());
}

TEST_F(MapFile, FaultsAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Json = nlohmann::json;
  for (const auto& [pointer, value, word] :
       std::vector<std::tuple<std::string, Json, std::string>>{
           {"/format",
            3,
            "was written by a newer acmap (format 3; this one reads up to 2)"},
           {"/format", "one", "format is no whole number"},
           {"/unit", "mm", "unit is not \"m\""},
           {"/planes", 3, "planes is no array"},
           {"/planes/1", 3, "planes[1] is no object"},
           {"/planes/1/id", 7, "planes[1].id is not 1"},
           {"/planes/1/coefficients", {1, 0, 0}, "planes[1].coefficients has 3"},
           {"/planes/1/coefficients/0", 0.5, "length is not 1"},
           {"/planes/1/coefficients/3", nullptr, "coefficients[3] is no number"},
           {"/planes/0/center/1", "x", "planes[0].center[1] is no number"},
           {"/planes/0/axes/1", nan, "planes[0].axes[1] is no array"},
           {"/planes/0/covariance/2", {1, 2}, "planes[0].covariance[2] has 2"},
           {"/cylinders", 3, "cylinders is no array"},
           {"/cylinders/1/id", 7, "cylinders[1].id is not 1"},
           {"/cylinders/1/axis_point/0", 1e10, "cylinders[1] has an axis_point"},
           {"/cylinders/0/axis_direction", {0, 0, 1}, "no right-handed basis"},
           {"/cylinders/0/axis_direction", {0, 0, 0}, "no right-handed basis"},
           {"/cylinders/0/axes/1/2", nullptr, "cylinders[0].axes[1][2] is no number"},
           {"/cylinders/0/radius", 0, "cylinders[0] has a radius that is not above 0"},
           {"/cylinders/0/radius", 1e300, "cylinders[0] has a radius"},
           {"/cylinders/0/extent", {1, 0}, "cylinders[0] has an extent"},
           {"/cylinders/0/extent", {0, 1, 2}, "cylinders[0].extent has 3"},
           {"/cylinders/0/arc", 7, "cylinders[0] has an arc"},
           {"/cylinders/0/arc", 0, "cylinders[0] has an arc"},
           {"/cylinders/0/hollow", 1, "cylinders[0].hollow is neither true nor false"},
           {"/cylinders/0/covariance/4", {1, 2}, "cylinders[0].covariance[4] has 2"},
           {"/cylinders/0/area", -1, "cylinders[0] has an area"},
           {"/cylinders/0/saved_bits", "many", "saved_bits is no number"},
           {"/cylinders/0/template", 1, "cylinders[0] has template 1, at most 0"},
           {"/cylinders/1/texture", 3, "cylinders[1].texture is no object"},
           {"/cylinders/1/texture/width", 0, "cylinders[1].texture.width is outside"},
           {"/cylinders/1/texture/height", 1 << 28, "cylinders[1] brings the map"},
           {"/cylinders/1/texture/image", "\u00e9.png", "texture.image"},
           {"/cylinders/1/texture/halvings", 29, "is halved 29 times"},
           {"/boxes", 3, "boxes is no array"},
           {"/boxes/1/id", 7, "boxes[1].id is not 1"},
           {"/boxes/1/center/0", 1e10, "boxes[1] has a center"},
           {"/boxes/0/axes/2", {0, 0, 1}, "no right-handed basis"},
           {"/boxes/0/axes", {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, "no right-handed"},
           {"/boxes/0/size/1", 0, "boxes[0] has a size that is not above 0"},
           {"/boxes/1/size/1", 1e300, "boxes[1] has a size"},
           {"/boxes/2/size/1", 0.6, "boxes[2] has another size than number 0"},
           {"/boxes/2/template", 3, "boxes[2] has template 3"},
           {"/boxes/2/template", -1, "boxes[2].template is outside"},
           {"/boxes/0/faces/0/kind", "open", "is no kind of a face"},
           {"/boxes/0/faces/0/plane", 2, "boxes[0].faces[0].plane is outside"},
           {"/boxes/2/faces/1",
            {{"kind", "slanted"}, {"plane", 0}},
            "has a slant that"},
           {"/boxes/1/slant", {0, 0, 2, 0}, "has a slant that is not the plane"},
           {"/boxes/1/slant", {0, 0, 1}, "slant has 3"},
           {"/boxes/1/faces/5/kind", "slanted", "more than one slanted face"},
           {"/boxes/0/faces", {1, 2}, "boxes[0].faces has 2"},
           {"/boxes/0/covariance/8/0", nullptr, "covariance that is not finite"},
           {"/boxes/0/saved_bits", "many", "saved_bits is no number"},
           {"/recesses", 3, "recesses is no array"},
           {"/recesses/1/id", 7, "recesses[1].id is not 1"},
           {"/recesses/1/center/0", 1e10, "recesses[1] has a center"},
           {"/recesses/0/axes/2", {0, 0, 1}, "no right-handed basis"},
           {"/recesses/0/size/2", 0, "recesses[0] has a size that is not above 0"},
           {"/recesses/2/size/1", 0.6, "recesses[2] has another size than number 0"},
           {"/recesses/2/template", 3, "recesses[2] has template 3"},
           {"/recesses/0/wall", 2, "recesses[0].wall is outside"},
           {"/recesses/0/leaf", -1, "recesses[0].leaf is outside"},
           {"/recesses/0/wall", 0, "has its leaf in the plane of its wall"},
           {"/recesses/0/reaches_floor", "yes", "recesses[0].reaches_floor is"},
           {"/recesses/0/covariance/8/0", nullptr, "covariance that is not finite"},
           {"/recesses/0/saved_bits", "many", "saved_bits is no number"},
           {"/planes/0/covariance/2/1", "x", "planes[0].covariance[2][1] is no number"},
           {"/planes/0/support", -1, "planes[0].support is outside"},
           {"/planes/0/support", 1.5, "planes[0].support is no whole number"},
           {"/planes/0/support", 18446744073709551615u, "planes[0].support is outside"},
           {"/planes/0/effective_support", "x", "effective_support is no number"},
           {"/planes/0/rmse", true, "planes[0].rmse is no number"},
           {"/planes/0/area", nullptr, "planes[0].area is no number"},
           {"/planes/0/name", 7, "planes[0].name is no text"},
           {"/planes/0/role", "roof", "planes[0].role is no role"},
           {"/planes/0/size", {1}, "planes[0].size has 1 elements"},
           {"/planes/0/pose_modes/1", {1, 2}, "pose_modes[1] has 2 elements"},
           {"/planes/0/polygons/0/outer", {{1, 2, 3}}, "outer has 1 points"},
           {"/planes/0/polygons/0/outer/2", {1, 2}, "outer[2] has 2 elements"},
           {"/planes/0/polygons/0/outer/2/0", 1e39, "outer[2][0] is too large"},
           {"/planes/0/polygons/0/holes/0/0/1", nullptr, "holes[0][0][1] is no number"},
           {"/planes/0/observations/1", 0, "observations[1] is not above"},
           {"/planes/0/observations/1", 2, "observations[1] is outside of 0 to 1"},
           {"/planes/0/charts/0/polygon", 2, "charts[0].polygon is 2, the plane has 2"},
           {"/planes/0/charts/0/image", 2, "charts[0].image is no text"},
           {"/planes/0/charts/1/kinds", 2, "charts[1].kinds is no text"},
           {"/planes/0/charts/0/image", "\n.png", "image has letters that are not"},
           {"/planes/0/charts/1/kinds", "\u00fc.png", "kinds has letters that are not"},
           {"/planes/0/charts/1/at", {1}, "charts[1].at has 1 elements"},
           {"/planes/0/charts/1/at/0", -1, "charts[1].at[0] is outside"},
           {"/planes/0/charts/1/at/1", 268435457, "charts[1].at[1] is outside"},
           {"/planes/0/charts/1/halvings", 29, "charts[1] is halved 29 times"},
           {"/planes/0/charts/1/halvings", -1, "charts[1].halvings is outside"},
           {"/planes/0/charts/1/kinds_at/1", 1.5, "kinds_at[1] is no whole number"},
           {"/exposure", 0, "exposure is not within 0.001 and 1000"},
           {"/exposure", nullptr, "exposure is no number"},
           {"/up", {0, 2, 0}, "up is not of length 1"},
           {"/up", {0, 1}, "up has 2 elements"},
           {"/planes/0/charts/0/origin/0", nullptr, "origin[0] is no number"},
           {"/planes/0/charts/0/texel_u",
            {0, 0, 0},
            "charts[0] has texels with a side"},
           {"/planes/0/charts/0/texel_v",
            {0, 2e3, 0},
            "charts[0] has texels with a side"},
           {"/planes/0/charts/0/texel_u", {0, 1, 1e-5}, "has texels without an area"},
           {"/planes/0/charts/0/width",
            1 << 27,
            "charts[1] brings the map to 268435460"},
           {"/planes/0/charts/0/width", 0, "charts[0].width is outside"},
           {"/planes/0/charts/0/height", 200000000, "at most"},
           {"/rooms", 1, "rooms is no array"},
           {"/rooms/0", 1, "rooms[0] is no object"},
           {"/rooms/0/center/1", nullptr, "rooms[0].center[1] is no number"},
           {"/rooms/0/area", nullptr, "rooms[0].area is no number"},
           {"/rooms/0/seen_area", "x", "rooms[0].seen_area is no number"},
           {"/rooms/0/planes/1", 2, "rooms[0].planes[1] is outside of 0 to 1"},
           {"/rooms/0/planes/0", -1, "rooms[0].planes[0] is outside of 0 to 1"},
           {"/rooms/0/openings/0", 2, "rooms[0].openings[0] is outside of 0 to 1"},
           {"/rooms", Json::array(), "openings[0].rooms[0] is outside"},
           {"/openings", Json::array(), "rooms[0].openings[0] is outside"},
           {"/openings/0/from", {1, 2}, "openings[0].from has 2"},
           {"/openings/0/to/2", nullptr, "openings[0].to[2] is no number"},
           {"/openings/0/bottom", "x", "openings[0].bottom is no number"},
           {"/openings/0/kind", "gate", "openings[0].kind is no kind of an opening"},
           {"/openings/0/planes", Json::array(), "openings[0].planes are 0, 1 or 2"},
           {"/openings/0/planes/1", 2, "openings[0].planes[1] is outside of 0 to 1"},
           {"/openings/0/rooms", {0}, "openings[0].rooms has 1"},
           {"/openings/0/rooms/0", -2, "openings[0].rooms[0] is outside of -1 to 1"},
           {"/trajectory", 1, "trajectory is no array"},
           {"/trajectory/1/stamp", nullptr, "trajectory[1].stamp is no number"},
           {"/trajectory/1/position", {1, 2}, "trajectory[1].position has 2"},
           {"/trajectory/1/orientation", {0, 0, 0, 2}, "orientation is no rotation"}}) {
    const std::string wanted = word == "at most" ? "1 to 2^28 are legal" : word;
    EXPECT_THAT(faultAt(pointer, value), HasSubstr(wanted)) << pointer;
  }
}

TEST_F(MapFile, KeysThatAreMissingAreNamed)
{
  saveMapFile(folder_.path("map.json"), makeSampleMap());
  const auto whole = jsonOfFile(folder_.path("map.json"));
  for (const std::string place : {"",
                                  "/planes/0",
                                  "/planes/0/polygons/0",
                                  "/planes/0/proposed/0",
                                  "/planes/0/charts/0",
                                  "/rooms/0",
                                  "/openings/0",
                                  "/trajectory/0"}) {
    const nlohmann::json::json_pointer pointer(place);
    for (const auto& item : whole.at(pointer).items()) {
      auto json = whole;
      json.at(pointer).erase(item.key());
      static const std::set<std::string> optional = {
          "proposed", "charts", "observations", "name", "role", "size", "pose_modes"};
      const bool is_optional =
          place.empty() ? item.key() != "planes" : optional.count(item.key()) > 0;
      EXPECT_THAT(faultOf(json.dump()),
                  HasSubstr(is_optional ? "no fault" : "has no \"" + item.key() + "\""))
          << place;
    }
  }
}

TEST_F(MapFile, WhatIsNoMapIsRefused)
{
  EXPECT_THAT(faultOf(""), HasSubstr("is empty"));
  EXPECT_THAT(faultOf("{\"planes\":["), HasSubstr("is no JSON"));
  EXPECT_THAT(faultOf("[]"), HasSubstr("the file is no object"));
  EXPECT_THAT(faultOf("{\"planes\":[1e999]}"), HasSubstr("is no JSON"));
  EXPECT_THAT(faultOf("\xff\xfe{}"), HasSubstr("is no JSON"));
  EXPECT_THAT(faultOf(std::string(1000000, '[')), HasSubstr("is no JSON"));
  EXPECT_THAT(faultOf(std::string(300000, '[') + std::string(300000, ']')),
              HasSubstr("the file is no object"));
  EXPECT_THROW(loadMapFile(folder_.path("none.json")), InputFileException);
  EXPECT_THROW(loadMapFile(folder_.path("")), InputFileException);
}

TEST_F(MapFile, LongWordsAreNotRepeated)
{
  const std::string fault = faultOf("{\"" + std::string(1000000, 'y'));
  EXPECT_THAT(fault, HasSubstr("is no JSON"));
  EXPECT_LT(fault.size(), folder_.path("map.json").size() + 250);
}

TEST_F(MapFile, MutationsNeverCrash)
{
  saveMapFile(folder_.path("map.json"), makeSampleMap());
  const std::string whole = contentOf(folder_.path("map.json"));
  Random random(4);
  const auto below = [&](std::size_t maximum) {
    return static_cast<std::size_t>(random.bits() % maximum);
  };
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = whole;
    if (round % 4 == 0)
      text.resize(1 + below(whole.size() - 4));
    else if (round % 4 == 1)
      text[below(text.size())] = "0123456789{}[],:\"-e.nul"[below(23)];
    else if (round % 4 == 2)
      text.erase(below(text.size()), 1 + below(20));
    else
      text[below(text.size())] = static_cast<char>(random.bits());
    refused += faultOf(text) != "no fault";
  }
  EXPECT_GT(refused, 1000);
}

TEST_F(MapFile, NonsenseIsNotWritten)
{
  const auto expectRefused = [&](const auto& spoil) {
    CompactMap map = makeSampleMap();
    spoil(map);
    EXPECT_THROW(saveMapFile(folder_.path("none.json"), map), BadArgumentException);
  };
  expectRefused([](CompactMap& map) { map.charts[1].plane = 2; });
  expectRefused([](CompactMap& map) { map.charts[1].polygon = 2; });
  expectRefused([](CompactMap& map) { map.charts[1].colors.width = 0; });
  expectRefused([](CompactMap& map) { map.charts[1].colors.height = 1 << 30; });
  expectRefused([](CompactMap& map) { map.charts[0].texel_u.setZero(); });
  expectRefused([](CompactMap& map) { map.charts[0].origin.x() = NAN; });
  expectRefused([](CompactMap& map) { map.charts[0].image = "\xff.png"; });
  expectRefused([](CompactMap& map) { map.observations.pop_back(); });
  expectRefused([](CompactMap& map) { map.observations[0] = {1, 0}; });
  expectRefused([](CompactMap& map) { map.observations[0] = {-1}; });
  expectRefused([](CompactMap& map) { map.observations[0] = {2}; });
  expectRefused([](CompactMap& map) { map.cylinders[1].axis_point.x() = NAN; });
  expectRefused([](CompactMap& map) { map.cylinders[1].axis_u *= 2; });
  expectRefused([](CompactMap& map) { map.cylinders[1].axis_v *= -1; });
  expectRefused([](CompactMap& map) { map.cylinders[1].radius = NAN; });
  expectRefused([](CompactMap& map) { map.cylinders[1].high = -1; });
  expectRefused([](CompactMap& map) { map.cylinders[1].arc = 6.3; });
  expectRefused([](CompactMap& map) { map.cylinders[1].saved_bits = INFINITY; });
  expectRefused([](CompactMap& map) { map.cylinders[1].template_id = 2; });
  expectRefused([](CompactMap& map) { // another radius than the first one
    map.cylinders[1].template_id = 0;
    map.cylinders[1].radius = 1;
  });
  expectRefused([](CompactMap& map) { map.cylinder_pictures.pop_back(); });
  expectRefused([](CompactMap& map) { map.cylinder_pictures[0].colors.width = 1; });
  expectRefused([](CompactMap& map) { map.cylinder_pictures[1].halvings = -1; });
  expectRefused([](CompactMap& map) { map.cylinder_pictures[1].image = "\xff"; });
  expectRefused(
      [](CompactMap& map) { map.cylinder_pictures[1].colors.height = 1 << 28; });
  expectRefused([](CompactMap& map) { map.boxes[1].center.x() = NAN; });
  expectRefused([](CompactMap& map) { map.boxes[1].axes.col(0) *= -1; });
  expectRefused([](CompactMap& map) { map.boxes[1].size.x() = NAN; });
  expectRefused([](CompactMap& map) { map.boxes[1].faces[0].plane = 2; });
  expectRefused([](CompactMap& map) { map.boxes[1].faces[0].plane = -1; });
  expectRefused([](CompactMap& map) { map.boxes[1].faces[1].plane = 0; });
  expectRefused([](CompactMap& map) { map.boxes[1].slant.setZero(); });
  expectRefused([](CompactMap& map) { map.boxes[0].slant.x() = 1; });
  expectRefused([](CompactMap& map) { map.boxes[1].covariance(3, 3) = NAN; });
  expectRefused([](CompactMap& map) { map.boxes[2].size.x() = 3; });
  expectRefused([](CompactMap& map) { map.boxes[2].template_id = 3; });
  expectRefused([](CompactMap& map) { map.boxes[1].saved_bits = INFINITY; });
  expectRefused([](CompactMap& map) { map.recesses[1].center.x() = NAN; });
  expectRefused([](CompactMap& map) { map.recesses[1].axes.col(0) *= -1; });
  expectRefused([](CompactMap& map) { map.recesses[1].size.z() = 0; });
  expectRefused([](CompactMap& map) { map.recesses[1].wall = 2; });
  expectRefused([](CompactMap& map) { map.recesses[1].leaf = -1; });
  expectRefused([](CompactMap& map) { map.recesses[1].leaf = 1; });
  expectRefused([](CompactMap& map) { map.recesses[1].covariance(3, 3) = NAN; });
  expectRefused([](CompactMap& map) { map.recesses[2].size.x() = 3; });
  expectRefused([](CompactMap& map) { map.recesses[2].template_id = 3; });
  expectRefused([](CompactMap& map) { map.recesses[1].saved_bits = INFINITY; });
  expectRefused([](CompactMap& map) { map.rooms[0].center.x() = NAN; });
  expectRefused([](CompactMap& map) { map.rooms[0].seen_area = INFINITY; });
  expectRefused([](CompactMap& map) { map.rooms[0].planes = {2}; });
  expectRefused([](CompactMap& map) { map.rooms[0].planes = {-1}; });
  expectRefused([](CompactMap& map) { map.rooms[0].openings = {2}; });
  expectRefused([](CompactMap& map) { map.openings[0].to.z() = NAN; });
  expectRefused([](CompactMap& map) { map.openings[0].planes = {-1, 0}; });
  expectRefused([](CompactMap& map) { map.openings[0].planes = {0, 2}; });
  expectRefused([](CompactMap& map) { map.openings[0].rooms = {-2, 0}; });
  expectRefused([](CompactMap& map) { map.openings[0].rooms = {0, 2}; });
  expectRefused([](CompactMap& map) { map.trajectory.stamps.pop_back(); });
  expectRefused([](CompactMap& map) { map.trajectory.poses[0].linear() *= 2; });
  expectRefused([](CompactMap& map) {
    map.charts[0].colors.width = 1 << 27;
    map.charts[0].colors.height = 2;
  });
  EXPECT_EQ(folder_.count(), 0);
  EXPECT_THROW(saveMapFile(folder_.path("none/p.json"), {}), OutputFileException);
  EXPECT_THROW(saveMapFile("/dev/full", makeSampleMap()), OutputFileException);
}

TEST_F(MapFile, PlanesThatCouldNotBeReadAreNotWritten)
{
  const auto faultOfPlane = [&](const auto& spoil) -> std::string {
    CompactMap map = makeSampleMap();
    spoil(map.planes[0]);
    return messageOf<BadArgumentException>(
        [&] { saveMapFile(folder_.path("none.json"), map); }, "no fault");
  };
  using Plane = PlanePatch;
  const auto scale = [](double factor) {
    return [factor](Plane& plane) { plane.coefficients.head<3>() *= factor; };
  };
  const std::string begin = "plane 0 of a map is unsound: ";
  for (const double factor : {0.0, 2.0, 1 - 2e-6, 1 + 2e-6})
    EXPECT_THAT(faultOfPlane(scale(factor)),
                HasSubstr(begin + "coefficients have a normal whose length is not 1"));
  EXPECT_EQ(faultOfPlane(scale(1 + 1e-7)), "no fault");
  EXPECT_THAT(faultOfPlane(scale(NAN)),
              HasSubstr(begin + "coefficients are not finite"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.coefficients[3] = INFINITY; }),
              HasSubstr(begin + "coefficients are not finite"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.center.y() = NAN; }),
              HasSubstr(begin + "center is not finite"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.axis_v.z() = NAN; }),
              HasSubstr(begin + "an axis is not finite"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.area = NAN; }),
              HasSubstr(begin + "area is not finite"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.support = std::size_t(-1); }),
              HasSubstr(begin + "support is above 2^63 - 1"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.polygons[1].outer.resize(2); }),
              HasSubstr(begin + "polygons[1].outer has 2 points, 3 are needed"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.polygons[1].outer.clear(); }),
              HasSubstr(begin + "polygons[1].outer has 0 points"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.polygons[1].outer[3].x() = NAN; }),
              HasSubstr(begin + "polygons[1].outer has point 3, which is not finite"));
  EXPECT_THAT(faultOfPlane([](Plane& plane) { plane.polygons[0].holes[0].resize(1); }),
              HasSubstr(begin + "polygons[0].holes[0] has 1 points"));
}

TEST_F(MapFile, WhatIsNotKnownOfAPlaneIsWritten)
{
  CompactMap map = makeSampleMap();
  map.planes[0].rms = map.planes[0].effective_support = NAN;
  map.planes[0].covariance.setConstant(INFINITY);
  const PlanePatch back = reloaded(map).planes[0];
  EXPECT_TRUE(std::isnan(back.rms) && std::isnan(back.effective_support));
  EXPECT_TRUE(back.covariance.array().isNaN().all());
}

} // namespace
} // namespace pcl::acmap::test
