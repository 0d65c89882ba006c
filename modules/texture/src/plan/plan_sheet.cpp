#include "plan/plan_sheet.h"

#include "plan/plan_style.h"
#include "plan/plan_text.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

// millimetres of the paper
constexpr double block_height = 38, min_width = 200, rim = 4;
constexpr double a4[] = {287, 200}, a3[] = {410, 287}; // what printers print of them

/** \brief 1, 2, 5, 10, 20 and so on, the largest that is at most a value. */
double
roundedDown(double value)
{
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value)
      return digit * power;
  return power;
}

bool
fits(const Vector2d& size, const double (&paper)[2])
{
  return size.maxCoeff() <= paper[0] && size.minCoeff() <= paper[1];
}

Vector2d
sheetSize(const Eigen::AlignedBox2d& box, double band, double scale)
{
  const Vector2d plan =
      1000 / scale * box.sizes() + Vector2d::Constant(2 * (band + rim));
  return {std::max(plan.x(), min_width), plan.y() + block_height};
}

/** \brief Draws the block below the plan, with places in millimetres from its lower left
 * corner. */
class Block {
public:
  explicit Block(PlanDrawing& drawing)
  : drawing_(drawing)
  , corner_(drawing.sheet.min() + Vector2d::Constant(drawing.metres(rim)))
  {}

  double
  width() const
  {
    return drawing_.sheet.sizes().x() / drawing_.metres(1) - 2 * rim;
  }

  Vector2d
  at(double x, double y) const
  {
    return corner_ + drawing_.metres(1) * Vector2d(x, y);
  }

  void
  addLine(double x0,
          double y0,
          double x1,
          double y1,
          const PlanPen& pen,
          PlanLayer layer = PlanLayer::Title)
  {
    drawing_.addLine(layer, at(x0, y0), at(x1, y1), pen);
  }

  void
  addArea(double x0, double y0, double x1, double y1, const PlanColor& color)
  {
    drawing_.add(PlanLayer::Title,
                 PlanArea{{{at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}}, color});
  }

  void
  addBox(double x0, double y0, double x1, double y1, const PlanPen& pen)
  {
    drawing_.add(PlanLayer::Title,
                 PlanLine{{at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}, pen, true});
  }

  void
  addText(double x,
          double y,
          const std::string& text,
          double height,
          PlanAlign align = PlanAlign::Left,
          PlanLayer layer = PlanLayer::Title)
  {
    drawing_.add(layer, PlanText{at(x, y), text, height, 0, align, ink});
  }

  void
  addArc(
      double x, double y, double radius, double begin, double end, const PlanPen& pen)
  {
    drawing_.add(PlanLayer::Title,
                 PlanArc{at(x, y), drawing_.metres(radius), begin, end, pen});
  }

private:
  PlanDrawing& drawing_;
  Vector2d corner_;
};

void
addLegend(Block& block)
{
  constexpr double left = 3, sample = 12, row = 5.5, top = 32, column = 54, text = 1.8;
  const auto label = [&](double x, double y, const char* name) {
    block.addText(x + sample + 2, y, name, text);
  };
  double x = left, y = top;
  block.addArea(x, y - 1, x + sample, y + 1, wall_color);
  label(x, y, "wall, seen from both sides");
  y -= row;
  block.addArea(x, y - 0.8, x + sample, y + 0.8, half_wall_color);
  block.addLine(x, y + 0.8, x + sample, y + 0.8, face_pen);
  label(x, y, "wall, thickness not seen");
  y -= row;
  block.addLine(x, y, x + sample, y, unseen_pen);
  label(x, y, "border or wall, not seen");
  y -= row;
  block.addArea(x, y - 1.2, x + sample, y + 1.2, floor_color);
  label(x, y, "floor, where it was seen");
  x = left + column;
  y = top;
  block.addLine(x + 3, y - 2, x + 3, y + 2.5, leaf_pen);
  block.addArc(x + 3, y - 2, 4.5, 0, half_turn / 2, swing_pen);
  label(x, y, "door or passage, leaf assumed");
  y -= row;
  block.addBox(x, y - 0.8, x + sample, y + 0.8, window_pen);
  block.addLine(x, y, x + sample, y, window_pen);
  label(x, y, "window, width \u00D7 height");
  y -= row;
  block.addArea(x, y - 1.2, x + sample, y + 1.2, furniture_color);
  block.addBox(x, y - 1.2, x + sample, y + 1.2, furniture_pen);
  label(x, y, "furniture");
}

void
addScaleBar(Block& block, double x, double y, double scale)
{
  constexpr double longest = 45, height = 1.4, text = 1.8;   // millimetres
  const double length = roundedDown(longest * scale / 1000); // metres
  const bool is_two =
      std::lround(length / std::pow(10, std::floor(std::log10(length)))) == 2;
  const int parts = is_two ? 4 : 5;
  const double part = length / parts * 1000 / scale;
  for (int k = 0; k < parts; ++k)
    block.addArea(x + k * part,
                  y,
                  x + (k + 1) * part,
                  y + height,
                  k % 2 == 0 ? ink : paper_color);
  block.addBox(x, y, x + parts * part, y + height, PlanPen{0.13});
  block.addText(x, y + 3.5, "0", text, PlanAlign::Middle);
  const int decimals = length < 5 ? 1 : 0;
  block.addText(
      x + part, y + 3.5, fixed(length / parts, decimals), text, PlanAlign::Middle);
  block.addText(x + parts * part,
                y + 3.5,
                fixed(length, length < 1 ? 1 : 0) + " m",
                text,
                PlanAlign::Middle);
}

void
addAxis(Block& block, double x, double y, const Vector2d& axis, const std::string& name)
{
  constexpr double half = 5, head = 2.2, text = 1.8; // millimetres
  const Vector2d aside(-axis.y(), axis.x());
  const PlanPen pen{0.25};
  const auto from = -half * axis, to = half * axis;
  block.addLine(
      x + from.x(), y + from.y(), x + to.x(), y + to.y(), pen, PlanLayer::North);
  for (const double side : {-0.4, 0.4}) {
    const Vector2d end = to - head * (axis + side * aside);
    block.addLine(
        x + to.x(), y + to.y(), x + end.x(), y + end.y(), pen, PlanLayer::North);
  }
  const Vector2d label = (half + 2) * axis;
  block.addText(
      x + label.x(), y + label.y(), name, text, PlanAlign::Middle, PlanLayer::North);
}

} // namespace

void
chooseSheet(const Eigen::AlignedBox2d& box, double band, PlanDrawing& drawing)
{
  drawing.scale = 50;
  for (int step = 0; !fits(sheetSize(box, band, drawing.scale), a3); ++step)
    drawing.scale *= step % 3 == 2 ? 2.5 : 2; // 50, 100, 200, 500
  const Vector2d size = drawing.metres(1) * sheetSize(box, band, drawing.scale);
  const Vector2d low(box.center().x() - size.x() / 2,
                     box.min().y() - drawing.metres(band + rim + block_height));
  drawing.sheet = {low, low + size};
}

void
addTitleBlock(const Vector2d& axis,
              const std::string& axis_name,
              const std::vector<std::string>& notes,
              PlanDrawing& drawing)
{
  constexpr double legend = 114, left = 118, row = 4; // millimetres
  constexpr double title_height = 3.5, scale_height = 2, note_height = 1.8;
  const PlanPen frame{0.35};
  Block block(drawing);
  const Vector2d size = drawing.sheet.sizes() / drawing.metres(1);
  block.addBox(0, 0, block.width(), size.y() - 2 * rim, frame);
  block.addLine(0, block_height, block.width(), block_height, frame);
  block.addLine(legend, 0, legend, block_height, frame);
  addLegend(block);
  double y = block_height - 5;
  block.addText(left, y, drawing.title, title_height);
  y -= 5.5;
  block.addText(left,
                y,
                "1 : " + fixed(drawing.scale, 0) +
                    (fits(size, a4) ? " on A4" : " on A3") + ", lengths in metres",
                scale_height);
  for (const std::string& note : notes)
    block.addText(left, y -= row, note, note_height);
  addScaleBar(block, left, 3, drawing.scale);
  addAxis(block, left + 62, 9, axis, axis_name);
}

} // namespace pcl::acmap
