#include "painted_maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {

Texturing
texturingOf(const std::vector<PlanePatch>& planes, const std::vector<View>& views)
{
  Texturing texturing;
  texturing.setTexelSize(0.02);
  texturing.setPlanes(planes);
  for (const View& view : views)
    texturing.addObservation(view.cloud, view.T_map_camera);
  return texturing;
}

CompactMap
painted(Texturing texturing)
{
  CompactMap map;
  texturing.texture(map);
  return map;
}

TexturingReport
reportOf(Texturing texturing)
{
  CompactMap map;
  texturing.texture(map);
  return texturing.getReport();
}

Eigen::Vector3d
middleOfTexel(const TextureChart& chart, int column, int row)
{
  return chart.origin + (column + 0.5) * chart.texel_u + (row + 0.5) * chart.texel_v;
}

TexelKind
kindOf(const TextureChart& chart, int column, int row)
{
  return chart.kinds.at(static_cast<std::size_t>(row * chart.colors.width + column));
}

void
forTexels(const CompactMap& map,
          TexelKind kind,
          const std::function<void(const TextureChart&,
                                   const std::uint8_t* color,
                                   const Eigen::Vector3d& place)>& call)
{
  for (const TextureChart& chart : map.charts)
    for (int row = 0; row < chart.colors.height; ++row)
      for (int column = 0; column < chart.colors.width; ++column)
        if (kindOf(chart, column, row) == kind)
          call(chart, chart.colors.at(column, row), middleOfTexel(chart, column, row));
}

std::size_t
countOf(const CompactMap& map, TexelKind kind)
{
  std::size_t count = 0;
  forTexels(map, kind, [&](const auto&, const auto*, const auto&) { ++count; });
  return count;
}

ComparedSquares
compareSquares(const CompactMap& map, double max_off)
{
  const auto isInside = [](double along) {
    return std::abs(along / square - std::floor(along / square) - 0.5) < 0.2;
  };
  ComparedSquares result;
  forTexels(
      map,
      TexelKind::Seen,
      [&](const TextureChart& chart, const std::uint8_t* color, const auto& place) {
        const bool is_wall = chart.plane == 0;
        if (!isInside(place.x()) || !isInside(is_wall ? place.y() : place.z()))
          return;
        const Rgb truth = is_wall ? wallColor(place) : floorColor(place);
        ++result.texels;
        for (std::size_t k = 0; k < 3; ++k)
          result.wrong += std::abs(color[k] - truth[k]) > max_off ? 1 : 0;
      });
  return result;
}

std::size_t
expectSquares(const CompactMap& map, double max_off)
{
  const ComparedSquares compared = compareSquares(map, max_off);
  EXPECT_EQ(compared.wrong, 0u) << "of " << compared.texels;
  return compared.texels;
}

void
expectSame(const CompactMap& a, const CompactMap& b)
{
  EXPECT_EQ(a.observations, b.observations);
  ASSERT_EQ(a.charts.size(), b.charts.size());
  for (std::size_t c = 0; c < a.charts.size(); ++c) {
    EXPECT_EQ(a.charts[c].origin, b.charts[c].origin);
    EXPECT_EQ(a.charts[c].texel_u, b.charts[c].texel_u);
    EXPECT_EQ(a.charts[c].texel_v, b.charts[c].texel_v);
    EXPECT_EQ(a.charts[c].colors.values, b.charts[c].colors.values);
    EXPECT_EQ(a.charts[c].kinds, b.charts[c].kinds);
  }
}

} // namespace pcl::acmap::test
