#include "plan/plan_drawing.h"

#include "plan/drawn_openings.h"
#include "plan/floor_plan_writers.h"
#include "plan/paper_line.h"
#include "plan/plan_dimensions.h"
#include "plan/plan_sheet.h"
#include "plan/plan_style.h"
#include "plan/plan_text.h"
#include "plan/text_places.h"
#include "plan/unseen_borders.h"
#include "plan/wall_bodies.h"

#include <pcl/core/impl/planar_geometry.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Loop = std::vector<Vector2d>;

/** \brief What is drawn of a wall whose thickness was not seen, metres. */
constexpr double strip = 0.08;

/** \brief The direction, within 45 degrees of the x axis, of most walls or of those at right
 * angles to it. */
Vector2d
directionOf(const std::vector<PlanWall>& walls)
{
  std::complex<double> sum = 0;
  for (const PlanWall& wall : walls)
    if (const Vector2d way = wall.to - wall.from; way.norm() > 0)
      sum += way.norm() * std::polar(1.0, 4 * std::atan2(way.y(), way.x()));
  const double angle = std::arg(sum) / 4;
  constexpr double aligned = 1e-3; // radians
  return std::abs(angle) < aligned ? Vector2d(Vector2d::UnitX())
                                   : Vector2d(std::cos(angle), std::sin(angle));
}

/** \brief Draws a plan. */
class PlanDrawer {
public:
  explicit PlanDrawer(const FloorPlan& plan)
  : plan_(plan)
  , bodies_(wallBodiesOf(plan, strip))
  , openings_(drawnOpeningsOf(plan, bodies_, strip))
  {
    drawing_.title = "Floor plan";
    if (!plan.shift.isZero(0)) {
      const Vector2d corner = boxOf(plan).min() + offsetOf(plan);
      drawing_.note = "The lower left corner of the building is at " +
                      fixed(corner.x(), 3) + " " + fixed(corner.y(), 3);
    }
    chooseSheet(boxOf(plan), dimension_band, drawing_);
  }

  PlanDrawing
  draw()
  {
    addFloors();
    addFurniture();
    addWalls();
    for (const DrawnOpening& opening : openings_)
      if (opening.face.is_window)
        addWindow(opening);
      else
        addDoor(opening);
    addRoomTexts();
    addDimensions(
        plan_, openings_, directionOf(plan_.walls), pointsOf(plan_), drawing_, places_);
    for (const DrawnOpening& opening : openings_)
      addSize(opening);
    const PlanNorth north = northOf(plan_);
    addTitleBlock(north.direction, north.axis, notes(), drawing_);
    std::stable_sort(
        drawing_.items.begin(),
        drawing_.items.end(),
        [](const PlanItem& a, const PlanItem& b) { return a.layer < b.layer; });
    return std::move(drawing_);
  }

private:
  void
  addFloors()
  {
    for (const PlanRoom& room : plan_.rooms)
      drawing_.add(PlanLayer::Floor, PlanArea{{room.outline}, room_color});
    for (const auto& polygon : plan_.floors)
      drawing_.add(PlanLayer::Floor, PlanArea{polygon, floor_color});
  }

  void
  addFurniture()
  {
    for (const PlanFurniture& one : plan_.furniture) {
      drawing_.add(PlanLayer::Furniture, PlanArea{{one.outline}, furniture_color});
      drawing_.add(PlanLayer::Furniture, PlanLine{one.outline, furniture_pen, true});
    }
    for (const PlanWall& wall : plan_.walls)
      if (wall.role == SurfaceRole::Furniture)
        drawing_.addLine(PlanLayer::Furniture, wall.from, wall.to, furniture_pen);
  }

  void
  addWalls()
  {
    for (const WallBody& body : bodies_) {
      drawing_.add(PlanLayer::Walls,
                   PlanArea{{Loop(body.corners.begin(), body.corners.end())},
                            body.is_measured ? wall_color : half_wall_color});
      places_.block(body.corners);
    }
    for (const WallBody& body : bodies_)
      if (body.has_face)
        drawing_.addLine(PlanLayer::Walls, body.corners[0], body.corners[1], face_pen);
    for (const PlanColumn& column : plan_.columns)
      addColumn(column);
    const std::vector<Loop> unseen = unseenBordersOf(plan_);
    for (const Loop& border : unseen)
      drawing_.add(PlanLayer::Walls, PlanLine{border, unseen_pen});
    for (const Loop& border : unseen)
      for (std::size_t k = 0; k + 1 < border.size(); ++k)
        unseen_length_ += (border[k + 1] - border[k]).norm();
  }

  /** \brief Fills what is behind the seen side of a cylinder: a column whole, else a strip. */
  void
  addColumn(const PlanColumn& column)
  {
    const PlanArc face{
        column.center, column.radius, column.begin, column.end, face_pen};
    const bool is_column = !column.is_hollow && column.radius < 0.5;
    const double back =
        column.is_hollow ? column.radius + strip : std::max(column.radius - strip, 0.0);
    PlanArc whole = face;
    if (is_column)
      whole.end = whole.begin + 2 * half_turn;
    Loop area = lineOf(whole).points;
    if (!is_column) {
      const Loop other =
          lineOf({column.center, back, column.begin, column.end, face_pen}).points;
      area.insert(area.end(), other.rbegin(), other.rend());
    }
    drawing_.add(PlanLayer::Walls,
                 PlanArea{{area}, is_column ? wall_color : half_wall_color});
    drawing_.add(PlanLayer::Walls, face);
  }

  void
  addWindow(const DrawnOpening& opening)
  {
    const Vector2d &from = opening.face.from, &to = opening.face.to;
    const Vector2d back_from = opening.onBack(from), back_to = opening.onBack(to);
    drawing_.add(PlanLayer::Windows,
                 PlanArea{{{from, to, back_to, back_from}}, paper_color});
    drawing_.add(PlanLayer::Windows,
                 PlanLine{{from, to, back_to, back_from}, window_pen, true});
    for (const double share : {0.4, 0.6})
      drawing_.addLine(PlanLayer::Windows,
                       from + share * (back_from - from),
                       to + share * (back_to - to),
                       window_pen);
    places_.block({from, to, back_to, back_from});
  }

  /** \brief Adds the threshold of a door, and its leaves with what they sweep. A wide opening is
   * a passage. */
  void
  addDoor(const DrawnOpening& opening)
  {
    constexpr double widest_leaf = 1.3, widest_door = 2.4; // metres
    const PlanOpening& face = opening.face;
    for (const auto& [from, to] :
         {std::pair(face.from, face.to),
          std::pair(opening.onBack(face.from), opening.onBack(face.to))})
      drawing_.addLine(PlanLayer::Doors, from, to, passage_pen);
    if (opening.width() > widest_door)
      return;
    if (opening.width() <= widest_leaf)
      addLeaf(opening, opening.hinge, opening.lock - opening.hinge);
    else {
      addLeaf(opening, opening.hinge, (opening.lock - opening.hinge) / 2);
      addLeaf(opening, opening.lock, (opening.hinge - opening.lock) / 2);
    }
  }

  void
  addLeaf(const DrawnOpening& opening, const Vector2d& hinge, const Vector2d& closed)
  {
    const Vector2d along = (opening.face.to - opening.face.from).normalized();
    const Vector2d front(-along.y(), along.x());
    const Vector2d open = closed.norm() * (opening.opens_to_front ? front : -front);
    const Vector2d pivot = opening.opens_to_front ? hinge : opening.onBack(hinge);
    drawing_.addLine(PlanLayer::Doors, pivot, pivot + open, leaf_pen);
    const bool turns_left = closed.x() * open.y() - closed.y() * open.x() > 0;
    const Vector2d& first = turns_left ? closed : open;
    const double begin = std::atan2(first.y(), first.x());
    drawing_.add(
        PlanLayer::Doors,
        PlanArc{pivot, closed.norm(), begin, begin + half_turn / 2, swing_pen});
    const Vector2d on_arc = closed.norm() * (closed + open).normalized();
    places_.block({pivot, pivot + closed, pivot + on_arc, pivot + open});
  }

  /** \brief Width and height, beside the opening. */
  void
  addSize(const DrawnOpening& opening)
  {
    constexpr double height = 1.6, off = 1.6; // millimetres of the paper
    const PlanOpening& face = opening.face;
    std::string size = fixed(opening.width(), 2);
    if (std::isfinite(face.top))
      size += " \u00D7 " + fixed(face.top - face.bottom, 2);
    const Vector2d along = (face.to - face.from).normalized(),
                   front(-along.y(), along.x());
    const Vector2d middle = (face.from + face.to) / 2;
    const double row = drawing_.metres(off);
    PlanText text{middle, size, height, readableAngle(along)};
    text.color = face.is_window ? window_ink : ink;
    const bool prefers_front = face.is_window || !opening.opens_to_front;
    for (const double aside : {0.0, 0.8, -0.8})
      for (const int step : {1, -1, 2, -2, 3, -3}) {
        const bool is_front = (step > 0) == prefers_front;
        const double away = (0.5 + std::abs(step)) * row - row / 2;
        text.place = middle + aside * opening.width() * along +
                     (is_front ? away : -away - opening.depth) * front;
        if (!places_.areFree({text}, drawing_.scale))
          continue;
        places_.take(text, drawing_.scale);
        drawing_.add(face.is_window ? PlanLayer::Windows : PlanLayer::Doors, text);
        return;
      }
  }

  /** \brief The name and the area of each room, as large as it has a place for them; otherwise
   * in its middle. */
  void
  addRoomTexts()
  {
    constexpr double smallest = 1.6; // millimetres of the paper
    for (std::size_t r = 0; r < plan_.rooms.size(); ++r) {
      const PlanRoom& room = plan_.rooms[r];
      const std::string name =
          room.name.empty() ? "Room " + std::to_string(r + 1) : room.name;
      const std::vector<std::string> lines{name, areaText(room.area) + " m\u00B2"};
      std::optional<std::vector<PlanText>> texts;
      for (const double height : {3.0, 2.2, smallest})
        if (!texts)
          texts = freeTexts(room, lines, height);
      for (const PlanText& text :
           texts ? *texts : textsAt(room.center, lines, smallest, 0)) {
        places_.take(text, drawing_.scale);
        drawing_.add(PlanLayer::Rooms, text);
      }
    }
  }

  /** \brief Lines below each other, the first one larger. */
  std::vector<PlanText>
  textsAt(const Vector2d& middle,
          const std::vector<std::string>& lines,
          double height,
          double angle) const
  {
    constexpr double smaller = 0.8;
    const Vector2d up(-std::sin(angle), std::cos(angle));
    std::vector<PlanText> texts;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const double rows =
          (static_cast<double>(lines.size()) - 1) / 2 - static_cast<double>(k);
      texts.push_back({middle + rows * drawing_.metres(1.8 * height) * up,
                       lines[k],
                       k == 0 ? height : smaller * height,
                       angle});
    }
    return texts;
  }

  /** \brief The place in a room that is nearest to its middle and free of walls and other
   * texts, if there is one. */
  std::optional<std::vector<PlanText>>
  freeTexts(const PlanRoom& room,
            const std::vector<std::string>& lines,
            double height) const
  {
    const auto isFree = [&](const std::vector<PlanText>& texts) {
      return std::all_of(texts.begin(),
                         texts.end(),
                         [&](const PlanText& text) {
                           const auto quad = quadOf(text, drawing_.scale);
                           return std::all_of(
                               quad.begin(), quad.end(), [&](const Vector2d& corner) {
                                 return isInside(room.outline, corner);
                               });
                         }) &&
             places_.areFree(texts, drawing_.scale);
    };
    for (const Vector2d& place : placesIn(room))
      for (const double angle : {0.0, half_turn / 2})
        if (auto texts = textsAt(place, lines, height, angle); isFree(texts))
          return texts;
    return {};
  }

  /** \brief The middle of a room, and places around it, by their distance. */
  static std::vector<Vector2d>
  placesIn(const PlanRoom& room)
  {
    constexpr int across = 12; // places
    Eigen::AlignedBox2d box;
    for (const Vector2d& corner : room.outline)
      box.extend(corner);
    std::vector<Vector2d> places{room.center};
    for (int i = 1; i < across && !box.isEmpty(); ++i)
      for (int j = 1; j < across; ++j)
        places.emplace_back(box.min() +
                            box.sizes().cwiseProduct(Vector2d(i, j)) / across);
    std::stable_sort(
        places.begin(), places.end(), [&](const Vector2d& a, const Vector2d& b) {
          return (a - room.center).norm() < (b - room.center).norm();
        });
    return places;
  }

  std::vector<std::string>
  notes() const
  {
    double area = 0, seen = 0;
    for (const PlanRoom& room : plan_.rooms) {
      area += room.area;
      seen += room.seen_area;
    }
    const std::string cut = "cut " + fixed(plan_.cut - plan_.floor, 2) +
                            " m above the floor; acmap " ACMAP_VERSION;
    if (plan_.rooms.empty())
      return {cut, "no room is enclosed by walls or a ceiling"};
    return {cut,
            std::to_string(plan_.rooms.size()) +
                (plan_.rooms.size() == 1 ? " room, " : " rooms, ") + areaText(area) +
                " m\u00B2 of floor",
            "not seen: " + areaText(area - seen) + " m\u00B2 of it, " +
                areaText(unseen_length_) + " m of borders"};
  }

  const FloorPlan& plan_;
  std::vector<WallBody> bodies_;
  std::vector<DrawnOpening> openings_;
  PlanDrawing drawing_;
  TextPlaces places_;
  double unseen_length_ = 0;
};

} // namespace

PlanDrawing
drawPlan(const FloorPlan& plan)
{
  return PlanDrawer(plan).draw();
}

} // namespace pcl::acmap
