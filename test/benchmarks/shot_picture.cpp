#include "shot_picture.h"

#include "picture_sheet.h"

#include <array>

namespace pcl::acmap::bench {

void
saveShotPicture(const std::string& path, const RigSimulation& simulation)
{
  constexpr std::uint64_t seed = 1;
  constexpr std::size_t place = 8;
  constexpr std::array<std::size_t, 2> other_places = {21, 60};
  constexpr std::size_t off = 0, first_pattern = 1;
  constexpr int columns = 4, smaller = 3;
  const auto reference =
      [&](const LitViews& views, std::size_t view, std::size_t shot) {
        return simulation.shoot(views, view, shot, seed)->image(RigCamera::Reference);
      };
  const LitViews here = simulation.cast(place);
  PictureSheet sheet(columns, 2, here[0].width, here[0].height, smaller);
  for (int column = 0; column < columns; ++column)
    sheet.put(column, 0, reference(here, place, static_cast<std::size_t>(column)));
  const auto lit = simulation.shoot(here, place, first_pattern, seed);
  sheet.put(0, 1, lit->image(RigCamera::Horizontal));
  sheet.put(1, 1, lit->image(RigCamera::Vertical));
  for (std::size_t i = 0; i < other_places.size(); ++i)
    sheet.put(2 + static_cast<int>(i),
              1,
              reference(simulation.cast(other_places[i]), other_places[i], off));
  sheet.save(path);
}

void
savePatternPicture(const std::string& path, const RgbImage& pattern)
{
  PictureSheet sheet(1, 1, pattern.width, pattern.height, 2);
  sheet.put(0, 0, {pattern.width, pattern.height, 3, pattern.values});
  sheet.save(path);
}

} // namespace pcl::acmap::bench
