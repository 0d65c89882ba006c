#include "outline_picture.h"

#include "drawing.h"
#include "map_outlines.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

constexpr int columns = 4, rows = 3;
constexpr int side = 420;  // pixels of a picture
constexpr int margin = 24; // pixels around an outline
const Color green(20, 150, 60);

void
drawOutline(const PlaneOutline& outline, std::size_t index, cv::Mat3b image)
{
  Eigen::AlignedBox2d box;
  double area = 0;
  for (const std::vector<FlatLoop>& polygon : outline.polygons)
    box.extend(boxOf(polygon));
  area = countOutlines({outline}).area;
  const double scale = (side - 2 * margin) / std::max(box.sizes().maxCoeff(), 1e-3);
  const auto pixelOf = [&](const Eigen::Vector2d& place) {
    const Eigen::Vector2d off = scale * (place - box.center());
    return Eigen::Vector2d(side / 2 + off.x(), side / 2 - off.y());
  };
  std::size_t edge = 0;
  for (const std::vector<FlatLoop>& polygon : outline.polygons)
    for (std::size_t l = 0; l < polygon.size(); ++l)
      for (std::size_t k = 0; k < polygon[l].size(); ++k, ++edge) {
        const Eigen::Vector2d at = pixelOf(polygon[l][k]);
        const bool is_shared = !outline.edges[edge].partners.empty();
        const Color& color = is_shared ? green : l > 0 ? blue : red;
        drawLine(image, at, pixelOf(polygon[l][(k + 1) % polygon[l].size()]), 2, color);
        drawDot(image, at, 3, color);
      }
  std::ostringstream title;
  title.precision(3);
  title << "plane " << index << ": " << area << " m2, " << outline.edges.size()
        << " vertices, " << box.sizes().x() << " x " << box.sizes().y() << " m";
  drawText(image, {4, margin / 2}, title.str(), black);
}

} // namespace

void
saveOutlinePicture(const std::string& path, const std::vector<PlanePatch>& planes)
{
  const std::vector<PlaneOutline> outlines = makeOutlines(planes);
  std::vector<double> areas;
  for (const PlaneOutline& outline : outlines)
    areas.push_back(countOutlines({outline}).area);
  std::vector<std::size_t> order(outlines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return areas[a] > areas[b];
  });
  cv::Mat3b sheet(rows * side, columns * side, white);
  for (int k = 0; k < columns * rows && k < static_cast<int>(order.size()); ++k) {
    const cv::Rect part(k % columns * side, k / columns * side, side - 1, side - 1);
    sheet(cv::Rect(part.x, part.y, side, side)) = gray;
    sheet(part) = white;
    const std::size_t plane = order[static_cast<std::size_t>(k)];
    if (areas[plane] > 0)
      drawOutline(outlines[plane], plane, sheet(part));
  }
  savePng(path, rgbImageOf(sheet));
}

} // namespace pcl::acmap::bench
