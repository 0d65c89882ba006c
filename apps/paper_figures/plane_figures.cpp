#include "figures.h"

#include "drawing.h"
#include "figure_sheet.h"
#include "figure_views.h"

#include <string>
#include <utility>

namespace pcl::acmap {

namespace {

RgbImage
pictureOf(const CompactMap& map, const MapView& view, const OutputFolder& folder)
{
  return drawn(folder,
               [&](const std::string& path) { saveMapSnapshot(path, map, view); });
}

/** Draws a picture with a white frame into the upper right corner of another one. */
void
inset(const RgbImage& small, RgbImage& large)
{
  constexpr int frame = 4; // px
  paste(whiteImage(small.width + frame, small.height + frame),
        large.width - small.width - frame,
        0,
        large);
  paste(small, large.width - small.width, 0, large);
}

} // namespace

void
drawPlanes(CompactMap map, const FigurePlan& plan, const OutputFolder& folder)
{
  for (TextureChart& chart : map.charts)
    chart.colors = lightened(std::move(chart.colors));
  const int height = plan.width * 3 / 4;
  constexpr int part = 3; // the inset has 1 / 3 of the figure's side
  auto view = viewFrom<MapView>(plan.inside, plan.width, height);
  view.place = MapView::Place::Inside;
  RgbImage inside = pictureOf(map, view, folder);
  view.paint = MapView::Paint::PlaneColors;
  inset(resized(pictureOf(map, view, folder), plan.width / part, height / part),
        inside);
  constexpr int fine_step = 4; // textures are smooth
  savePng(folder.path("fig8.png"), withFewLevels(inside, fine_step));
  for (std::size_t i = 0; i < plan.outside.size(); ++i) {
    const auto outside = viewFrom<MapView>(plan.outside[i], plan.width, height);
    savePng(folder.path("fig" + std::to_string(9 + i) + ".png"),
            pictureOf(map, outside, folder));
  }
}

} // namespace pcl::acmap
