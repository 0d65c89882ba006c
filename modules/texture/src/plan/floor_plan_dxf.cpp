#include "plan/floor_plan_writers.h"
#include "plan/paper_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

/** \brief Numbers of the layers in AutoCAD's index of colours. */
constexpr std::array<int, 9> layer_colors{8, 8, 7, 5, 30, 3, 9, 1, 7};
static_assert(layer_colors.size() == plan_layer_names.size());

/** \brief A text in the characters of release 12. */
std::string
plain(const std::string& text)
{
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto sign = static_cast<unsigned char>(text[k]);
    if (text.compare(k, 2, "\u00B2") == 0)
      result += '2';
    else if (text.compare(k, 2, "\u00D7") == 0)
      result += 'x';
    else if (sign >= 0xC0)
      result += '?';
    else if (sign >= ' ' && sign < 0x7F)
      result += text[k];
  }
  return result;
}

/** \brief Writes the shapes of a drawing as pairs of a group code and a value, one per
 * line. */
class DxfWriter {
public:
  DxfWriter(const PlanDrawing& drawing, const Vector2d& offset)
  : drawing_(drawing)
  , offset_(offset)
  {
    text_.imbue(std::locale::classic());
    text_.setf(std::ios::fixed);
    text_.precision(6); // micrometres
  }

  std::string
  write()
  {
    addHeader();
    addTables();
    add(0, "SECTION");
    add(2, "ENTITIES");
    for (const PlanItem& item : drawing_.items) {
      layer_ = item.layer;
      std::visit(*this, item.shape);
    }
    add(0, "ENDSEC");
    add(0, "EOF");
    return text_.str();
  }

  /** \brief Parts of walls and of the scale bar are filled, floors are outlined; what only hides
   * what is below it is left out. */
  void
  operator()(const PlanArea& area)
  {
    if (layer_ == PlanLayer::Floor)
      for (const std::vector<Vector2d>& loop : area.loops)
        addPolyline(loop, true, {});
    const std::vector<Vector2d>& corners = area.loops.front();
    const bool is_filled = layer_ == PlanLayer::Walls || layer_ == PlanLayer::Title;
    if (!is_filled || corners.size() != 4 || area.color == paper_color)
      return;
    begin("SOLID");
    addColor(area.color);
    addPoint(10, corners[0]); // in the order of a Z
    addPoint(11, corners[1]);
    addPoint(12, corners[3]);
    addPoint(13, corners[2]);
  }

  void
  operator()(const PlanLine& line)
  {
    if (line.points.size() == 2) {
      begin("LINE");
      addStyle(line.pen);
      addPoint(10, line.points[0]);
      addPoint(11, line.points[1]);
    }
    else
      addPolyline(line.points, line.is_closed, line.pen);
  }

  void
  operator()(const PlanArc& arc)
  {
    constexpr double degrees = 180 / half_turn;
    const bool is_circle = (arc.end - arc.begin) * degrees > 360 - 1e-6;
    begin(is_circle ? "CIRCLE" : "ARC");
    addStyle(arc.pen);
    addPoint(10, arc.center);
    add(40, arc.radius);
    if (is_circle)
      return;
    add(50, degrees * arc.begin);
    add(51, degrees * arc.end);
  }

  void
  operator()(const PlanText& text)
  {
    constexpr double degrees = 180 / half_turn;
    constexpr int middle = 2;
    begin("TEXT");
    addPoint(10, text.place);
    add(40, drawing_.metres(text.height));
    add(1, plain(text.text));
    add(50, degrees * text.angle);
    add(72, static_cast<int>(text.align)); // 0 left, 1 middle, 2 right
    addPoint(11, text.place);
    add(73, middle);
  }

private:
  template <typename Value>
  void
  add(int code, const Value& value)
  {
    text_ << code << '\n' << value << '\n';
  }

  void
  addPoint(int code, const Vector2d& place)
  {
    add(code, place.x() + offset_.x());
    add(code + 10, place.y() + offset_.y());
    add(code + 20, 0.0);
  }

  void
  begin(const char* entity)
  {
    add(0, entity);
    add(8, plan_layer_names[static_cast<std::size_t>(layer_)]);
  }

  void
  addStyle(const PlanPen& pen)
  {
    if (pen.is_dashed)
      add(6, "DASHED");
  }

  /** \brief Grey instead of the colour of the layer, for what is not dark. */
  void
  addColor(const PlanColor& color)
  {
    constexpr int grey = 9, dark = 128;
    if (color[0] >= dark)
      add(62, grey);
  }

  void
  addPolyline(const std::vector<Vector2d>& points, bool is_closed, const PlanPen& pen)
  {
    if (points.size() < 2)
      return;
    begin("POLYLINE");
    addStyle(pen);
    add(66, 1); // vertices follow
    add(70, is_closed ? 1 : 0);
    addPoint(10, -offset_); // the format wants zeros
    for (const Vector2d& place : points) {
      begin("VERTEX");
      addPoint(10, place);
    }
    begin("SEQEND");
  }

  void
  addHeader()
  {
    constexpr int metres = 6;
    add(0, "SECTION");
    add(2, "HEADER");
    add(9, "$ACADVER");
    add(1, "AC1009");
    add(9, "$INSUNITS");
    add(70, metres);
    add(9, "$EXTMIN");
    addPoint(10, drawing_.sheet.min());
    add(9, "$EXTMAX");
    addPoint(10, drawing_.sheet.max());
    add(0, "ENDSEC");
  }

  void
  addTables()
  {
    add(0, "SECTION");
    add(2, "TABLES");
    add(0, "TABLE");
    add(2, "LTYPE");
    add(70, 2);
    addLineType("CONTINUOUS", "Solid line", {});
    addLineType("DASHED",
                "Dashed line",
                {drawing_.metres(dash_length), -drawing_.metres(dash_gap)});
    add(0, "ENDTAB");
    add(0, "TABLE");
    add(2, "LAYER");
    add(70, plan_layer_names.size());
    for (std::size_t layer = 0; layer < plan_layer_names.size(); ++layer) {
      add(0, "LAYER");
      add(2, plan_layer_names[layer]);
      add(70, 0);
      add(62, layer_colors[layer]);
      add(6, "CONTINUOUS");
    }
    add(0, "ENDTAB");
    add(0, "ENDSEC");
  }

  /** \param[in] dashes lengths of dashes and, negative, of gaps, metres */
  void
  addLineType(const char* name, const char* title, const std::vector<double>& dashes)
  {
    add(0, "LTYPE");
    add(2, name);
    add(70, 0);
    add(3, title);
    add(72, 65); // an "A", as the format wants
    add(73, dashes.size());
    double length = 0;
    for (const double dash : dashes)
      length += std::abs(dash);
    add(40, length);
    for (const double dash : dashes)
      add(49, dash);
  }

  const PlanDrawing& drawing_;
  Vector2d offset_;
  std::ostringstream text_;
  PlanLayer layer_ = PlanLayer::Floor;
};

} // namespace

std::string
dxfOf(const PlanDrawing& drawing, const Vector2d& offset)
{
  return DxfWriter(drawing, offset).write();
}

} // namespace pcl::acmap
