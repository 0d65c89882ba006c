#include "export/floor_plan_writers.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

// on the drawing, metres of the building
constexpr double plan_margin = 1, wall_width = 0.06, opening_width = 0.04,
                 text_height = 0.4;

/** \brief Writes the elements of a drawing. Its y axis points down. */
class SvgDrawing {
public:
  explicit SvgDrawing(const Eigen::AlignedBox2d& box)
  : corner_(box.min().x() - plan_margin, box.max().y() + plan_margin)
  {
    constexpr double paper = 10; // mm for a metre: 1 : 100
    const Vector2d size = box.sizes() + Vector2d::Constant(2 * plan_margin);
    text_.imbue(std::locale::classic());
    text_.setf(std::ios::fixed);
    text_.precision(3);
    text_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          << "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\""
          << paper * size.x() << "mm\" height=\"" << paper * size.y()
          << "mm\" viewBox=\"0 0 " << size.x() << ' ' << size.y() << "\">\n"
          << "<title>Floor plan, 1 : 100</title>\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }

  void
  addDescription(const std::string& text)
  {
    text_ << "<desc>" << text << "</desc>\n";
  }

  /** \brief Begins a group of elements of one style. */
  void
  begin(const std::string& id, const std::string& style)
  {
    text_ << "<g id=\"" << id << "\" " << style << ">\n";
  }

  void
  end()
  {
    text_ << "</g>\n";
  }

  void
  addLine(const Vector2d& from, const Vector2d& to)
  {
    const Vector2d a = onPaper(from), b = onPaper(to);
    text_ << "<line x1=\"" << a.x() << "\" y1=\"" << a.y() << "\" x2=\"" << b.x()
          << "\" y2=\"" << b.y() << "\"/>\n";
  }

  void
  addPolygon(const std::vector<std::vector<Vector2d>>& loops)
  {
    text_ << "<path d=\"";
    for (const std::vector<Vector2d>& loop : loops) {
      char command = 'M';
      for (const Vector2d& place : loop) {
        const Vector2d at = onPaper(place);
        text_ << command << at.x() << ' ' << at.y();
        command = 'L';
      }
      text_ << 'Z';
    }
    text_ << "\"/>\n";
  }

  void
  addText(const Vector2d& place, const std::string& text)
  {
    const Vector2d at = onPaper(place);
    text_ << "<text x=\"" << at.x() << "\" y=\"" << at.y() << "\">" << text
          << "</text>\n";
  }

  std::string
  finish()
  {
    text_ << "</svg>\n";
    return text_.str();
  }

private:
  Vector2d
  onPaper(const Vector2d& place) const
  {
    return {place.x() - corner_.x(), corner_.y() - place.y()};
  }

  Vector2d corner_; ///< upper left, frame of the plan
  std::ostringstream text_;
};

std::string
stroke(const std::string& color, double width, const std::string& more = {})
{
  std::ostringstream style;
  style.imbue(std::locale::classic());
  style << "stroke=\"" << color << "\" stroke-width=\"" << width << "\" " << more;
  return style.str();
}

/** \brief A bar of 1, 5 or 25 m in the lower left corner. */
void
addScaleBar(const Eigen::AlignedBox2d& box, SvgDrawing& drawing)
{
  const double extent = box.sizes().maxCoeff();
  const double length = extent < 8 ? 1 : extent < 60 ? 5 : 25;
  const Vector2d from = box.min() - Vector2d(0, 0.6 * plan_margin);
  const Vector2d to = from + Vector2d(length, 0), tick(0, 0.1);
  drawing.begin("scale", stroke("#000000", 0.02));
  drawing.addLine(from, to);
  drawing.addLine(from - tick, from + tick);
  drawing.addLine(to - tick, to + tick);
  drawing.end();
  drawing.begin("scale_text", "font-family=\"sans-serif\" font-size=\"0.3\"");
  drawing.addText(to + Vector2d(0.15, -0.1),
                  std::to_string(static_cast<int>(length)) + " m");
  drawing.end();
}

/** \brief An arrow beside the upper right corner. */
void
addNorth(const Eigen::AlignedBox2d& box, const PlanNorth& north, SvgDrawing& drawing)
{
  constexpr double length = 0.6, head = 0.15;
  const Vector2d ahead = north.direction, aside(-ahead.y(), ahead.x());
  const Vector2d middle = box.max() + Vector2d(0.5, -0.5) * plan_margin;
  const Vector2d from = middle - length / 2 * ahead;
  const Vector2d to = from + length * ahead;
  drawing.begin("north", stroke("#000000", 0.02));
  drawing.addLine(from, to);
  for (const double side : {-0.5, 0.5})
    drawing.addLine(to, to - head * (ahead + side * aside));
  drawing.end();
  drawing.begin("north_text", "font-family=\"sans-serif\" font-size=\"0.3\"");
  drawing.addText(to + Vector2d(0.1, -0.1), north.axis);
  drawing.end();
}

} // namespace

std::string
svgOf(const FloorPlan& plan)
{
  const Eigen::AlignedBox2d box = boxOf(plan);
  SvgDrawing drawing(box);
  if (!plan.shift.isZero(0)) {
    const Vector2d corner = box.min() + offsetOf(plan);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.setf(std::ios::fixed);
    text.precision(3);
    text << "The lower left corner of the plan, " << plan_margin
         << " m from the edges of the drawing, is at " << corner.x() << ' '
         << corner.y();
    drawing.addDescription(text.str());
  }
  drawing.begin("floor", "fill=\"#eeeae0\" fill-rule=\"evenodd\" stroke=\"none\"");
  for (const auto& polygon : plan.floors)
    drawing.addPolygon(polygon);
  drawing.end();
  drawing.begin("walls", stroke("#202020", wall_width, "stroke-linecap=\"round\""));
  for (const PlanWall& wall : plan.walls)
    drawing.addLine(wall.from, wall.to);
  drawing.end();
  for (const bool is_window : {false, true}) {
    drawing.begin(
        is_window ? "windows" : "doors",
        is_window ? stroke("#3a7ebf", opening_width)
                  : stroke("#b05020", opening_width, "stroke-dasharray=\"0.15 0.1\""));
    for (const PlanOpening& opening : plan.openings)
      if (opening.is_window == is_window)
        drawing.addLine(opening.from, opening.to);
    drawing.end();
  }
  std::ostringstream style;
  style.imbue(std::locale::classic());
  style << "font-family=\"sans-serif\" font-size=\"" << text_height
        << "\" text-anchor=\"middle\" dominant-baseline=\"middle\"";
  drawing.begin("rooms", style.str());
  for (const PlanRoom& room : plan.rooms)
    drawing.addText(room.center, areaText(room.area) + " m²");
  drawing.end();
  addScaleBar(box, drawing);
  addNorth(box, northOf(plan), drawing);
  return drawing.finish();
}

} // namespace pcl::acmap
