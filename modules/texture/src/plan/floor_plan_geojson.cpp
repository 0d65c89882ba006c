#include "plan/floor_plan_writers.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace pcl::acmap {

namespace {

/** \brief Writes features one after the other. */
class FeatureList {
public:
  /** \param[in] offset is added to all places */
  explicit FeatureList(const Eigen::Vector2d& offset)
  : offset_(offset)
  {
    text_.imbue(std::locale::classic());
    text_.precision(offset.isZero(0) ? 10 : 13); // micrometres of a national grid
  }

  std::ostringstream&
  text()
  {
    return text_;
  }

  void
  begin(const char* type)
  {
    text_ << (is_first_ ? "\n" : ",\n") << R"({"type":"Feature","geometry":{"type":")"
          << type << R"(","coordinates":)";
    is_first_ = false;
  }

  /** \brief Ends the geometry, and begins the properties. */
  std::ostringstream&
  properties(const char* kind)
  {
    text_ << R"(},"properties":{"kind":")" << kind << '"';
    return text_;
  }

  void
  end()
  {
    text_ << "}}";
  }

  void
  addPlace(const Eigen::Vector2d& place)
  {
    text_ << '[' << place.x() + offset_.x() << ',' << place.y() + offset_.y() << ']';
  }

  void
  addLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    begin("LineString");
    text_ << '[';
    addPlace(from);
    text_ << ',';
    addPlace(to);
    text_ << ']';
  }

  /** \brief Adds a loop, whose last place is its first one again. */
  void
  addLoop(const std::vector<Eigen::Vector2d>& loop)
  {
    text_ << '[';
    for (const Eigen::Vector2d& place : loop) {
      addPlace(place);
      text_ << ',';
    }
    addPlace(loop.front());
    text_ << ']';
  }

private:
  Eigen::Vector2d offset_;
  std::ostringstream text_;
  bool is_first_ = true;
};

void
addAxis(const char* name, const Eigen::Vector3d& axis, std::ostringstream& text)
{
  text << ",\n\"" << name << "\":[" << axis.x() << ',' << axis.y() << ',' << axis.z()
       << ']';
}

/** \brief null for what is unknown. */
void
addNumber(const char* name, double value, std::ostringstream& text)
{
  text << ",\"" << name << "\":";
  if (std::isfinite(value))
    text << value;
  else
    text << "null";
}

/** \brief A name in quotes; control characters become blanks. */
void
addName(const std::string& name, std::ostringstream& text)
{
  text << ",\"name\":\"";
  for (const char c : name) {
    if (c == '"' || c == '\\')
      text << '\\';
    text << (static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  }
  text << '"';
}

void
addFloors(const FloorPlan& plan, FeatureList& features)
{
  for (const auto& polygon : plan.floors) {
    features.begin("Polygon");
    features.text() << '[';
    bool is_first = true;
    for (const std::vector<Eigen::Vector2d>& loop : polygon) {
      if (loop.empty())
        continue;
      features.text() << (is_first ? "" : ",");
      features.addLoop(loop);
      is_first = false;
    }
    features.text() << ']';
    features.properties("floor");
    features.end();
  }
}

} // namespace

std::string
geoJsonOf(const FloorPlan& plan)
{
  FeatureList features(offsetOf(plan));
  std::ostringstream& text = features.text();
  text << R"({"type":"FeatureCollection","name":"floor_plan","units":"metres")";
  addAxis("x_axis", plan.x_axis, text);
  addAxis("y_axis", plan.y_axis, text);
  addAxis("up", plan.up, text);
  addNumber("floor", plan.floor + plan.shift.dot(plan.up), text);
  addNumber("cut", plan.cut + plan.shift.dot(plan.up), text);
  const PlanNorth north = northOf(plan);
  text << ",\n\"north\":[" << north.direction.x() << ',' << north.direction.y()
       << "],\"north_axis\":\"" << north.axis << "\",\n\"features\":[";
  addFloors(plan, features);
  for (const PlanWall& wall : plan.walls) {
    features.addLine(wall.from, wall.to);
    features.properties("wall") << ",\"plane\":" << wall.plane;
    features.end();
  }
  for (const PlanOpening& opening : plan.openings) {
    features.addLine(opening.from, opening.to);
    features.properties(opening.is_window ? "window" : "door")
        << ",\"plane\":" << opening.plane << ",\"rooms\":[" << opening.rooms[0] << ','
        << opening.rooms[1] << ']';
    addNumber("bottom", opening.bottom, text);
    addNumber("top", opening.top, text);
    features.end();
  }
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    features.begin("Point");
    features.addPlace(plan.rooms[i].center);
    features.properties("room") << ",\"room\":" << i;
    addName(plan.rooms[i].name, text);
    addNumber("area", plan.rooms[i].area, text);
    addNumber("seen_area", plan.rooms[i].seen_area, text);
    features.end();
  }
  text << "\n]}\n";
  return text.str();
}

} // namespace pcl::acmap
