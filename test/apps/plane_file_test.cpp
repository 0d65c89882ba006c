#include "plane_file.h"

#include "temporary_folder.h"

#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace pcl::acmap {
namespace {

PlanePatch
makePlane()
{
  PlanePatch plane;
  plane.coefficients = {1.0 / 3, -2.0 / 3, 2.0 / 3, 1e-17};
  plane.center = {0.1, 1e6 + 0.1, -1.0 / 7};
  plane.covariance << 1e-9, 2, 3, 4, 5, 6, 7, 8, 9;
  plane.covariance(0, 2) = std::numeric_limits<double>::quiet_NaN();
  plane.support = 12345678901u;
  plane.effective_support = 0.3;
  plane.rms = 0.0123;
  plane.area = 4.5;
  plane.polygons = {{{{0.1F, 0.2F, 1e-8F}, {1, 0, 0}, {16777217.0F, 3.3333333F, 0}},
                     {{{0.25F, 0.1F, 0}, {0, 0, 0}, {1, 1, 1}}}},
                    {}};
  return plane;
}

TEST(PlaneFile, NumbersComeBack)
{
  const test::TemporaryFolder folder;
  const PlanePatch plane = makePlane();
  savePlanes(folder.path("p.json"), {PlanePatch(), plane});
  const auto json = nlohmann::json::parse(test::contentOf(folder.path("p.json")));
  EXPECT_EQ(json["version"], ACMAP_VERSION);
  EXPECT_EQ(json["unit"], "m");
  ASSERT_EQ(json["planes"].size(), 2u);
  EXPECT_TRUE(json["planes"][0]["polygons"].empty());
  const auto& back = json["planes"][1];
  EXPECT_EQ(back["id"], 1);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(back["coefficients"][i].get<double>(), plane.coefficients[i]);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(back["center"][i].get<double>(), plane.center[i]);
    EXPECT_EQ(back["axes"][0][i].get<double>(), plane.axis_u[i]);
    EXPECT_EQ(back["axes"][1][i].get<double>(), plane.axis_v[i]);
  }
  EXPECT_TRUE(back["covariance"][0][2].is_null());
  EXPECT_EQ(back["covariance"][0][0], 1e-9);
  EXPECT_EQ(back["covariance"][2][0], 7.0);
  EXPECT_EQ(back["support"], plane.support);
  EXPECT_EQ(back["effective_support"], 0.3);
  EXPECT_EQ(back["rmse"], 0.0123);
  EXPECT_EQ(back["area"], 4.5);
}

TEST(PlaneFile, PolygonsComeBackAsTheSameFloats)
{
  const test::TemporaryFolder folder;
  const PlanePatch plane = makePlane();
  savePlanes(folder.path("p.json"), {plane});
  const std::string text = test::contentOf(folder.path("p.json"));
  EXPECT_NE(text.find("[0.1,0.2,1e-08]"), std::string::npos) << text;
  const auto polygons = nlohmann::json::parse(text)["planes"][0]["polygons"];
  ASSERT_EQ(polygons.size(), 2u);
  ASSERT_EQ(polygons[0]["holes"].size(), 1u);
  EXPECT_TRUE(polygons[1]["outer"].empty());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<int>(axis);
      EXPECT_EQ(polygons[0]["outer"][i][axis].get<float>(),
                plane.polygons[0].outer[i][k]);
      EXPECT_EQ(polygons[0]["holes"][0][i][axis].get<float>(),
                plane.polygons[0].holes[0][i][k]);
    }
}

TEST(PlaneFile, PlacesThatCannotBeAreNamed)
{
  const test::TemporaryFolder folder;
  EXPECT_THROW(savePlanes(folder.path("none/p.json"), {}), OutputFileException);
}

} // namespace
} // namespace pcl::acmap
