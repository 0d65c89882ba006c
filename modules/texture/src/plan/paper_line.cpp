#include "plan/paper_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

PlanLine
lineOf(const PlanArc& arc)
{
  constexpr double step = 0.05; // radians
  const int steps =
      std::max(1, static_cast<int>(std::ceil((arc.end - arc.begin) / step)));
  PlanLine line{{}, arc.pen};
  for (int k = 0; k <= steps; ++k) {
    const double angle = arc.begin + (arc.end - arc.begin) * k / steps;
    line.points.push_back(
        arc.center + arc.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return line;
}

std::vector<std::vector<Eigen::Vector2d>>
piecesOf(const PlanLine& line, double scale)
{
  std::vector<Eigen::Vector2d> points = line.points;
  if (line.is_closed && !points.empty())
    points.push_back(points.front());
  if (!line.pen.is_dashed || points.empty())
    return {points};
  const double dash = dash_length * scale / 1000, gap = dash_gap * scale / 1000;
  std::vector<std::vector<Eigen::Vector2d>> pieces{{points.front()}};
  double left = dash; // of the dash or gap
  bool is_dash = true;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    Eigen::Vector2d at = points[k];
    for (double length = (points[k + 1] - at).norm(); length > 0;) {
      const double part = std::min(length, left);
      at += part / length * (points[k + 1] - at);
      length -= part;
      left -= part;
      if (is_dash)
        pieces.back().push_back(at);
      if (left > 0)
        continue;
      is_dash = !is_dash;
      left = is_dash ? dash : gap;
      if (is_dash)
        pieces.push_back({at});
    }
  }
  return pieces;
}

} // namespace pcl::acmap
