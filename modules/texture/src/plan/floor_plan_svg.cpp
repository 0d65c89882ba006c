#include "plan/floor_plan_writers.h"
#include "plan/paper_line.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

std::string
lowerCase(std::string text)
{
  for (char& sign : text)
    sign = static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
  return text;
}

std::string
escaped(const std::string& text)
{
  std::string safe;
  for (const char sign : text)
    if (sign == '&')
      safe += "&amp;";
    else if (sign == '<')
      safe += "&lt;";
    else if (sign == '>')
      safe += "&gt;";
    else
      safe += sign;
  return safe;
}

std::string
hexOf(const PlanColor& color)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t value : color) {
    text += digits[value >> 4];
    text += digits[value & 15];
  }
  return text;
}

/** \brief Writes the shapes of a drawing. Its y axis points down. */
class SvgWriter {
public:
  explicit SvgWriter(const PlanDrawing& drawing)
  : drawing_(drawing)
  , paper_(1000 / drawing.scale)
  {
    constexpr int decimals = 3; // micrometres of the paper
    text_.imbue(std::locale::classic());
    text_.setf(std::ios::fixed);
    text_.precision(decimals);
    const Vector2d size = paper_ * drawing.sheet.sizes();
    const auto scale = std::lround(drawing.scale);
    text_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          << "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"100%\" "
             "viewBox=\"0 0 "
          << size.x() << ' ' << size.y() << "\">\n"
          << "<title>" << escaped(drawing.title) << ", 1 : " << scale << "</title>\n";
    if (!drawing.note.empty())
      text_ << "<desc>" << escaped(drawing.note) << "</desc>\n";
    text_ << "<style>@media print { @page { size: " << size.x() << "mm " << size.y()
          << "mm; margin: 0 } svg { width: " << size.x() << "mm; height: " << size.y()
          << "mm } } text { font-family: Arial, Helvetica, sans-serif; paint-order: "
             "stroke; stroke: #ffffff; stroke-linejoin: round }</style>\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"" << hexOf(paper_color)
          << "\"/>\n"
          << "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  }

  std::string
  write()
  {
    for (auto item = drawing_.items.begin(); item != drawing_.items.end();) {
      const PlanLayer layer = item->layer;
      text_ << "<g id=\""
            << lowerCase(plan_layer_names[static_cast<std::size_t>(layer)]) << "\">\n";
      for (; item != drawing_.items.end() && item->layer == layer; ++item)
        std::visit(*this, item->shape);
      text_ << "</g>\n";
    }
    text_ << "</g>\n</svg>\n";
    return text_.str();
  }

  void
  operator()(const PlanArea& area)
  {
    text_ << "<path d=\"";
    for (const std::vector<Vector2d>& loop : area.loops)
      addPath(loop, true);
    text_ << "\" fill=\"" << hexOf(area.color) << "\" fill-rule=\"evenodd\"/>\n";
  }

  void
  operator()(const PlanLine& line)
  {
    text_ << "<path d=\"";
    addPath(line.points, line.is_closed);
    text_ << "\"";
    addPen(line.pen);
  }

  void
  operator()(const PlanArc& arc)
  {
    if (arc.end - arc.begin > 2 * half_turn - 1e-6) {
      const Vector2d at = onPaper(arc.center);
      text_ << "<circle cx=\"" << at.x() << "\" cy=\"" << at.y() << "\" r=\""
            << paper_ * arc.radius << "\"";
      addPen(arc.pen);
      return;
    }
    const auto placeAt = [&](double angle) {
      return onPaper(arc.center +
                     arc.radius * Vector2d(std::cos(angle), std::sin(angle)));
    };
    const Vector2d from = placeAt(arc.begin), to = placeAt(arc.end);
    text_ << "<path d=\"M" << from.x() << ' ' << from.y() << 'A' << paper_ * arc.radius
          << ' ' << paper_ * arc.radius << " 0 "
          << (arc.end - arc.begin > half_turn ? 1 : 0) << " 0 " << to.x() << ' '
          << to.y() << "\"";
    addPen(arc.pen);
  }

  void
  operator()(const PlanText& text)
  {
    constexpr double capital = 0.716,
                     halo = 0.5; // of the size of Arial, of a capital letter
    constexpr double degrees = 180 / half_turn;
    const Vector2d at = onPaper(text.place);
    text_ << "<text transform=\"translate(" << at.x() << ' ' << at.y() << ')';
    if (text.angle != 0)
      text_ << " rotate(" << -degrees * text.angle << ')';
    text_ << "\" y=\"" << text.height / 2 << "\" font-size=\"" << text.height / capital
          << "\" stroke-width=\"" << halo * text.height << "\" fill=\""
          << hexOf(text.color) << '"';
    if (text.align != PlanAlign::Left)
      text_ << " text-anchor=\"" << (text.align == PlanAlign::Middle ? "middle" : "end")
            << '"';
    text_ << '>' << escaped(text.text) << "</text>\n";
  }

private:
  void
  addPath(const std::vector<Vector2d>& points, bool is_closed)
  {
    char command = 'M';
    for (const Vector2d& point : points) {
      const Vector2d at = onPaper(point);
      text_ << command << at.x() << ' ' << at.y();
      command = 'L';
    }
    if (is_closed && !points.empty())
      text_ << 'Z';
  }

  void
  addPen(const PlanPen& pen)
  {
    text_ << " stroke=\"" << hexOf(pen.color) << "\" stroke-width=\"" << pen.width
          << '"';
    if (pen.is_dashed)
      text_ << " stroke-dasharray=\"" << dash_length << ' ' << dash_gap << '"';
    text_ << "/>\n";
  }

  Vector2d
  onPaper(const Vector2d& place) const
  {
    return {paper_ * (place.x() - drawing_.sheet.min().x()),
            paper_ * (drawing_.sheet.max().y() - place.y())};
  }

  const PlanDrawing& drawing_;
  double paper_; ///< millimetres of a metre
  std::ostringstream text_;
};

} // namespace

std::string
svgOf(const PlanDrawing& drawing)
{
  return SvgWriter(drawing).write();
}

} // namespace pcl::acmap
