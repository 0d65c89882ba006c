#include "painted_maps.h"

#include <pcl/core/cylinder_facets.h>

#include <gtest/gtest.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/texture/impl/plane_texturing.hpp>
#endif

#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double radius = 0.4, distance_of_axis = 1.5; // metres

/** An upright column before the camera, or the inside of a niche around it; y is down. */
CylinderPatch
makeUpright(bool is_hollow, double arc)
{
  CylinderPatch cylinder;
  cylinder.axis_point = {0.1, 0.2, distance_of_axis};
  cylinder.axis_direction = -Eigen::Vector3d::UnitY();
  const double side = is_hollow ? 1 : -1;
  cylinder.axis_u = side * Eigen::Vector3d::UnitZ();
  cylinder.axis_v = cylinder.axis_direction.cross(cylinder.axis_u);
  cylinder.radius = radius;
  cylinder.is_hollow = is_hollow;
  cylinder.low = -0.5;
  cylinder.high = 0.6;
  cylinder.arc = arc;
  return cylinder;
}

/** Stripes that turn about the axis: colours change by no more than four levels a
 * texel. */
Rgb
colorAt(const Eigen::Vector3d& place)
{
  const double angle = std::atan2(place.x() - 0.1, place.z() - distance_of_axis);
  return {128 + 90 * std::sin(2 * angle),
          128 + 90 * std::cos(3 * angle + 2 * place.y()),
          128 + 90 * std::sin(4 * place.y())};
}

/** Narrow screens in place of the cylinder, before a wall in a colour that it has not. */
std::vector<Screen>
screensOf(const CylinderPatch& cylinder)
{
  std::vector<Screen> screens{{{-10, -10, 4}, {20, 0, 0}, {0, 20, 0}, [](const auto&) {
                                 return Rgb{255, 0, 255};
                               }}};
  for (const PlanePatch& facet : facetsOfCylinder(cylinder, 1e-5)) {
    const auto& outer = facet.polygons[0].outer;
    const Eigen::Vector3d corner = outer[0].cast<double>();
    screens.push_back({corner,
                       outer[1].cast<double>() - corner,
                       outer[3].cast<double>() - corner,
                       colorAt});
  }
  return screens;
}

/** The map of a cylinder seen by two cameras. */
CompactMap
seen(const CylinderPatch& cylinder, Texturing& texturing)
{
  const std::vector<Screen> screens = screensOf(cylinder);
  texturing =
      texturingOf({}, {lookAt(screens), lookAt(screens, {{-0.5, 0, 0.2}, 0.4})});
  texturing.setCylinders({cylinder});
  CompactMap map;
  texturing.texture(map);
  return map;
}

Eigen::Vector3d
middleOf(const CylinderPatch& cylinder, const RgbImage& image, int column, int row)
{
  // from left to right as seen from the front
  const double share = (column + 0.5) / image.width - 0.5;
  const double angle = (cylinder.is_hollow ? -1 : 1) * cylinder.arc * share;
  const double height =
      cylinder.high - (cylinder.high - cylinder.low) * (row + 0.5) / image.height;
  return cylinder.axis_point + height * cylinder.axis_direction +
         cylinder.radius *
             (std::cos(angle) * cylinder.axis_u + std::sin(angle) * cylinder.axis_v);
}

/** Checks all seen texels. \return their share */
double
expectColors(const CylinderPatch& cylinder,
             const TexturePicture& picture,
             double max_off = 8)
{
  double count = 0;
  for (int row = 0; row < picture.colors.height; ++row)
    for (int column = 0; column < picture.colors.width; ++column) {
      const auto texel = static_cast<std::size_t>(row * picture.colors.width + column);
      if (picture.kinds[texel] != TexelKind::Seen)
        continue;
      count += 1;
      const Rgb wanted = colorAt(middleOf(cylinder, picture.colors, column, row));
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(picture.colors.at(column, row)[k], wanted[k], max_off)
            << column << ' ' << row;
    }
  return count / static_cast<double>(picture.kinds.size());
}

TEST(CylinderTexturing, TexelsHaveTheColoursOfTheirPlaces)
{
  for (const bool is_hollow : {false, true}) {
    const CylinderPatch cylinder = makeUpright(is_hollow, 2.2);
    Texturing texturing;
    const CompactMap map = seen(cylinder, texturing);
    ASSERT_EQ(map.cylinders.size(), 1U);
    ASSERT_EQ(map.cylinder_pictures.size(), 1U);
    const TexturePicture& picture = map.cylinder_pictures[0];
    EXPECT_EQ(picture.colors.width, std::ceil(2.2 * radius / 0.02));
    EXPECT_EQ(picture.colors.height, 55);
    EXPECT_GT(expectColors(cylinder, picture), 0.7) << is_hollow;
    EXPECT_EQ(texturing.getReport().charts, 1U);
    EXPECT_GT(texturing.getReport().seen, 1500U);
  }
}

TEST(CylinderTexturing, TheBackOfAColumnStaysUnknown)
{
  const CylinderPatch column = makeUpright(false, 2 * M_PI);
  Texturing texturing;
  const CompactMap map = seen(column, texturing);
  const TexturePicture& picture = map.cylinder_pictures[0];
  const double share = expectColors(column, picture);
  EXPECT_GT(share, 0.25);
  EXPECT_LT(share, 0.55);
  const auto kindAt = [&](std::int32_t column_of) {
    return picture
        .kinds[static_cast<std::size_t>(27 * picture.colors.width + column_of)];
  };
  EXPECT_EQ(kindAt(0), TexelKind::None);
  EXPECT_EQ(kindAt(picture.colors.width - 1), TexelKind::None);
  EXPECT_EQ(kindAt(picture.colors.width / 2), TexelKind::Seen);
}

TEST(CylinderTexturing, PointsWithoutACameraColourToo)
{
  const CylinderPatch column = makeUpright(false, 2.2);
  Texturing texturing = texturingOf({}, {scattered(lookAt(screensOf(column)))});
  texturing.setCylinders({column});
  const CompactMap map = painted(texturing);
  EXPECT_GT(expectColors(column, map.cylinder_pictures[0], 40), 0.4);
}

TEST(CylinderTexturing, LargeOnesHaveLargerTexels)
{
  const CylinderPatch column = makeUpright(false, 2.2);
  Texturing texturing;
  texturing = texturingOf({}, {lookAt(screensOf(column))});
  texturing.setCylinders({column});
  texturing.setMaximumTextureSize(20);
  const CompactMap map = painted(texturing);
  EXPECT_EQ(map.cylinder_pictures[0].colors.width, 20);
  EXPECT_EQ(map.cylinder_pictures[0].colors.height, 20);
}

TEST(CylinderTexturing, ThoseWithoutAnAreaAreLeftOut)
{
  std::vector<CylinderPatch> bad(3, makeUpright(false, 1));
  bad[0].radius = 0;
  bad[1].high = bad[1].low;
  bad[2].axis_point.x() = NAN;
  Texturing texturing = texturingOf({}, {});
  texturing.setCylinders(bad);
  CompactMap map;
  texturing.texture(map);
  EXPECT_EQ(map.cylinder_pictures.size(), 3U);
  EXPECT_EQ(texturing.getReport().charts, 0U);
  ASSERT_FALSE(texturing.getReport().remarks.empty());
  EXPECT_NE(texturing.getReport().remarks[0].find("left out: 3"), std::string::npos);
}

} // namespace
} // namespace pcl::acmap::test
