#include "plan/plan_raster.h"

#include "plan/paper_line.h"
#include "plan/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Loop = std::vector<Vector2d>;

/** \brief Which places loops enclose. */
enum class FillRule { Odd, NotZero };

/** \brief Fills polygons in pixels, rows from the top. */
class Canvas {
public:
  Canvas(std::int32_t width, std::int32_t height)
  : image_{width,
           height,
           std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) *
                                         static_cast<std::size_t>(height),
                                     paper_color[0])}
  , coverage_(static_cast<std::size_t>(width))
  {}

  void
  fill(const std::vector<Loop>& loops, FillRule rule, const PlanColor& color)
  {
    edges_.clear();
    double top = image_.height, bottom = 0;
    for (const Loop& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vector2d &a = loop[k], &b = loop[(k + 1) % loop.size()];
        if (a.y() == b.y())
          continue;
        edges_.push_back(a.y() < b.y() ? Edge{a, b, 1} : Edge{b, a, -1});
        top = std::min(top, edges_.back().upper.y());
        bottom = std::max(bottom, edges_.back().lower.y());
      }
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
      return a.upper.y() < b.upper.y();
    });
    const auto first = static_cast<std::int32_t>(std::max(top, 0.0));
    const auto end = static_cast<std::int32_t>(
        std::min(std::ceil(bottom), static_cast<double>(image_.height)));
    std::vector<std::size_t> active;
    std::size_t next = 0;
    for (std::int32_t row = first; row < end; ++row) {
      while (next < edges_.size() && edges_[next].upper.y() < row + 1)
        active.push_back(next++);
      active.erase(std::remove_if(
                       active.begin(),
                       active.end(),
                       [&](std::size_t edge) { return edges_[edge].lower.y() <= row; }),
                   active.end());
      fillRow(row, active, rule, color);
    }
  }

  RgbImage
  finish()
  {
    return std::move(image_);
  }

private:
  struct Edge {
    Vector2d upper, lower;
    int turn; ///< 1 if it was drawn downwards
  };

  void
  fillRow(std::int32_t row,
          const std::vector<std::size_t>& active,
          FillRule rule,
          const PlanColor& color)
  {
    constexpr int parts = 4; // of the row
    std::fill(coverage_.begin(), coverage_.end(), 0.0);
    for (int part = 0; part < parts; ++part) {
      const double y = row + (part + 0.5) / parts;
      crossings_.clear();
      for (const std::size_t number : active) {
        const Edge& edge = edges_[number];
        if (edge.upper.y() <= y && edge.lower.y() > y)
          crossings_.emplace_back(edge.upper.x() +
                                      (y - edge.upper.y()) /
                                          (edge.lower.y() - edge.upper.y()) *
                                          (edge.lower.x() - edge.upper.x()),
                                  edge.turn);
      }
      std::sort(crossings_.begin(), crossings_.end());
      int turns = 0;
      for (std::size_t k = 0; k + 1 < crossings_.size(); ++k) {
        turns += crossings_[k].second;
        if (rule == FillRule::Odd ? k % 2 == 0 : turns != 0)
          cover(crossings_[k].first, crossings_[k + 1].first, 1.0 / parts);
      }
    }
    for (std::int32_t column = 0; column < image_.width; ++column)
      if (const double share = coverage_[static_cast<std::size_t>(column)]; share > 0) {
        std::uint8_t* const pixel = image_.at(column, row);
        for (std::size_t channel = 0; channel < 3; ++channel)
          pixel[channel] = static_cast<std::uint8_t>(
              std::lround(pixel[channel] +
                          std::min(share, 1.0) * (color[channel] - pixel[channel])));
      }
  }

  /** \brief Adds a part of a row to the pixels that it covers. */
  void
  cover(double from, double to, double height)
  {
    from = std::clamp(from, 0.0, static_cast<double>(image_.width));
    to = std::clamp(to, 0.0, static_cast<double>(image_.width));
    for (auto column = static_cast<std::size_t>(from); static_cast<double>(column) < to;
         ++column) {
      const auto left = static_cast<double>(column);
      coverage_[column] += height * (std::min(to, left + 1) - std::max(from, left));
    }
  }

  RgbImage image_;
  std::vector<double> coverage_; ///< of the pixels of a row
  std::vector<Edge> edges_;
  std::vector<std::pair<double, int>> crossings_;
};

/** \brief Adds polygons that cover a line with round ends, all turning the same way. */
void
addStroke(const Loop& points, double width, std::vector<Loop>& loops)
{
  constexpr int corners = 12;
  for (const Vector2d& point : points) {
    Loop& circle = loops.emplace_back();
    for (int k = 0; k < corners; ++k)
      circle.push_back(point + width / 2 *
                                   Vector2d(std::cos(2 * half_turn * k / corners),
                                            std::sin(2 * half_turn * k / corners)));
  }
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vector2d along = points[k + 1] - points[k];
    if (!(along.norm() > 0))
      continue;
    const Vector2d aside = width / 2 * Vector2d(-along.y(), along.x()).normalized();
    loops.push_back({points[k] + aside,
                     points[k] - aside,
                     points[k + 1] - aside,
                     points[k + 1] + aside});
  }
}

/** \brief Draws the shapes of a drawing. */
class Painter {
public:
  Painter(const PlanDrawing& drawing, double resolution)
  : drawing_(drawing)
  , resolution_(resolution)
  , pixels_(1000 * resolution / drawing.scale)
  , canvas_(sizeOf(drawing.sheet.sizes().x()), sizeOf(drawing.sheet.sizes().y()))
  {}

  void
  operator()(const PlanArea& area)
  {
    std::vector<Loop> loops;
    for (const Loop& loop : area.loops)
      loops.push_back(onImage(loop));
    canvas_.fill(loops, FillRule::Odd, area.color);
  }

  void
  operator()(const PlanLine& line)
  {
    std::vector<Loop> loops;
    for (const Loop& piece : piecesOf(line, drawing_.scale))
      addStroke(onImage(piece), resolution_ * line.pen.width, loops);
    canvas_.fill(loops, FillRule::NotZero, line.pen.color);
  }

  void
  operator()(const PlanArc& arc)
  {
    (*this)(lineOf(arc));
  }

  void
  operator()(const PlanText& text)
  {
    constexpr double pen = 0.13, halo = 0.5; // capital letters
    const StrokedText stroked = strokesOf(text.text);
    const double shift = text.align == PlanAlign::Left    ? 0
                         : text.align == PlanAlign::Right ? 1
                                                          : 0.5;
    const double height = drawing_.metres(text.height);
    const Vector2d along(std::cos(text.angle), std::sin(text.angle));
    const Vector2d upwards(-along.y(), along.x());
    std::vector<Loop> strokes;
    for (const Loop& stroke : stroked.strokes) {
      Loop& placed = strokes.emplace_back();
      for (const Vector2d& point : stroke)
        placed.push_back(text.place +
                         height * ((point.x() - shift * stroked.width) * along +
                                   point.y() * upwards));
    }
    const auto draw = [&](double width, const PlanColor& color) {
      std::vector<Loop> loops;
      for (const Loop& stroke : strokes)
        addStroke(onImage(stroke), width * text.height * resolution_, loops);
      canvas_.fill(loops, FillRule::NotZero, color);
    };
    draw(halo, paper_color);
    draw(pen, text.color);
  }

  RgbImage
  finish()
  {
    return canvas_.finish();
  }

private:
  std::int32_t
  sizeOf(double metres) const
  {
    return std::max(1, static_cast<std::int32_t>(std::lround(metres * pixels_)));
  }

  Loop
  onImage(const Loop& points) const
  {
    Loop placed;
    for (const Vector2d& point : points)
      placed.emplace_back((point.x() - drawing_.sheet.min().x()) * pixels_,
                          (drawing_.sheet.max().y() - point.y()) * pixels_);
    return placed;
  }

  const PlanDrawing& drawing_;
  double resolution_;
  double pixels_; ///< for a metre of the building
  Canvas canvas_;
};

} // namespace

RgbImage
rasterOf(const PlanDrawing& drawing, double resolution)
{
  Painter painter(drawing, resolution);
  for (const PlanItem& item : drawing.items)
    std::visit(painter, item.shape);
  return painter.finish();
}

} // namespace pcl::acmap
