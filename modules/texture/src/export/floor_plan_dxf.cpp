#include "export/floor_plan_writers.h"

#include <locale>
#include <sstream>

namespace pcl::acmap {

namespace {

/** \brief Writes a drawing as pairs of a group code and a value, one per line. */
class DxfDrawing {
public:
  /** \param[in] offset is added to all places */
  explicit DxfDrawing(const Eigen::Vector2d& offset)
  : offset_(offset)
  {
    text_.imbue(std::locale::classic());
    text_.setf(std::ios::fixed);
    text_.precision(6); // micrometres
  }

  template <typename Value>
  void
  add(int code, const Value& value)
  {
    text_ << code << '\n' << value << '\n';
  }

  void
  addPoint(int code, const Eigen::Vector2d& place)
  {
    add(code, place.x() + offset_.x());
    add(code + 10, place.y() + offset_.y());
    add(code + 20, 0.0);
  }

  void
  begin(const char* entity, const char* layer)
  {
    add(0, entity);
    add(8, layer);
  }

  void
  addLine(const char* layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    begin("LINE", layer);
    addPoint(10, from);
    addPoint(11, to);
  }

  void
  addLoop(const char* layer, const std::vector<Eigen::Vector2d>& loop)
  {
    begin("POLYLINE", layer);
    add(66, 1);             // vertices follow
    add(70, 1);             // closed
    addPoint(10, -offset_); // the format wants zeros
    for (const Eigen::Vector2d& place : loop) {
      begin("VERTEX", layer);
      addPoint(10, place);
    }
    begin("SEQEND", layer);
  }

  void
  addText(const char* layer, const Eigen::Vector2d& place, const std::string& text)
  {
    constexpr double height = 0.3; // metres
    begin("TEXT", layer);
    addPoint(10, place);
    add(40, height);
    add(1, text);
  }

  std::string
  finish()
  {
    add(0, "EOF");
    return text_.str();
  }

private:
  Eigen::Vector2d offset_;
  std::ostringstream text_;
};

struct Layer {
  const char* name;
  int color; ///< number in AutoCAD's index of colours
};

constexpr Layer layers[] = {{"FLOOR", 8},
                            {"WALLS", 7},
                            {"DOORS", 30},
                            {"WINDOWS", 5},
                            {"ROOMS", 3},
                            {"NORTH", 1}};

void
addHeader(const Eigen::AlignedBox2d& box, DxfDrawing& drawing)
{
  constexpr int metres = 6;
  drawing.add(0, "SECTION");
  drawing.add(2, "HEADER");
  drawing.add(9, "$ACADVER");
  drawing.add(1, "AC1009");
  drawing.add(9, "$INSUNITS");
  drawing.add(70, metres);
  drawing.add(9, "$EXTMIN");
  drawing.addPoint(10, box.min());
  drawing.add(9, "$EXTMAX");
  drawing.addPoint(10, box.max());
  drawing.add(0, "ENDSEC");
}

void
addLayers(DxfDrawing& drawing)
{
  drawing.add(0, "SECTION");
  drawing.add(2, "TABLES");
  drawing.add(0, "TABLE");
  drawing.add(2, "LAYER");
  drawing.add(70, std::size(layers));
  for (const Layer& layer : layers) {
    drawing.add(0, "LAYER");
    drawing.add(2, layer.name);
    drawing.add(70, 0);
    drawing.add(62, layer.color);
    drawing.add(6, "CONTINUOUS");
  }
  drawing.add(0, "ENDTAB");
  drawing.add(0, "ENDSEC");
}

} // namespace

std::string
dxfOf(const FloorPlan& plan)
{
  DxfDrawing drawing(offsetOf(plan));
  const Eigen::AlignedBox2d box = boxOf(plan);
  addHeader(box, drawing);
  addLayers(drawing);
  drawing.add(0, "SECTION");
  drawing.add(2, "ENTITIES");
  for (const auto& polygon : plan.floors)
    for (const std::vector<Eigen::Vector2d>& loop : polygon)
      drawing.addLoop("FLOOR", loop);
  for (const PlanWall& wall : plan.walls)
    drawing.addLine("WALLS", wall.from, wall.to);
  for (const PlanOpening& opening : plan.openings)
    drawing.addLine(opening.is_window ? "WINDOWS" : "DOORS", opening.from, opening.to);
  for (const PlanRoom& room : plan.rooms)
    drawing.addText("ROOMS", room.center, areaText(room.area) + " m2");
  const PlanNorth north = northOf(plan);
  const Eigen::Vector2d from(box.max().x(), box.min().y() - 1);
  drawing.addLine("NORTH", from, from + north.direction);
  drawing.addText("NORTH", from + north.direction, north.axis);
  drawing.add(0, "ENDSEC");
  return drawing.finish();
}

} // namespace pcl::acmap
