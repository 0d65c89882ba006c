#include "plan/plan_dimensions.h"

#include "plan/opening_faces.h"
#include "plan/plan_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

// millimetres of the paper
constexpr double inner_chain = 9, outer_chain = 18, tick = 1.2, text_height = 1.8,
                 text_off = 1.8, overhang = 1.5;
constexpr double shortest_wall = 0.4; // metres, of those that have dimensions
constexpr PlanPen dimension_pen{0.13, {70, 70, 70}};

/** \brief A side of a building, in a frame of its own: x along the side, to the right as one
 * sees the building from there, y away from the building. */
class BuildingSide {
public:
  BuildingSide(const FloorPlan& plan, const Vector2d& outwards)
  : along_(-outwards.y(), outwards.x())
  , outwards_(outwards)
  {
    for (const PlanWall& wall : plan.walls)
      if (wall.role == SurfaceRole::Wall)
        walls_.push_back({flat(wall.from), flat(wall.to)});
    closed_ = walls_;
    for (const PlanWall& wall : plan.unseen_walls)
      closed_.push_back({flat(wall.from), flat(wall.to)});
    for (const PlanOpening& opening : plan.openings)
      closed_.push_back({flat(opening.from), flat(opening.to)});
  }

  Vector2d
  flat(const Vector2d& place) const
  {
    return {along_.dot(place), outwards_.dot(place)};
  }

  Vector2d
  lifted(double along, double away) const
  {
    return along * along_ + away * outwards_;
  }

  const Vector2d&
  direction() const
  {
    return along_;
  }

  /** \brief Of the walls, without reveals. */
  Eigen::AlignedBox2d
  extent() const
  {
    Eigen::AlignedBox2d box;
    for (const Segment& wall : walls_)
      if ((wall.to - wall.from).norm() >= shortest_wall)
        box.extend(wall.from).extend(wall.to);
    return box;
  }

  /** \brief Where the next walls and openings begin and end along the side, ascending. */
  std::vector<double>
  marks(const std::vector<DrawnOpening>& openings) const
  {
    constexpr double max_sine = 0.05, same = 0.05; // metres
    std::vector<double> marks;
    for (const Segment& wall : walls_) {
      const Vector2d way = wall.to - wall.from;
      const Vector2d& end = wall.from.y() > wall.to.y() ? wall.from : wall.to;
      if (std::abs(way.x()) <= max_sine * way.norm() && way.norm() >= shortest_wall &&
          isNext(end))
        marks.push_back(end.x());
    }
    for (const DrawnOpening& opening : openings) {
      const Vector2d from = flat(opening.face.from), to = flat(opening.face.to);
      if (std::abs((to - from).y()) <= max_sine * (to - from).norm() &&
          isNext((from + to) / 2)) {
        marks.push_back(from.x());
        marks.push_back(to.x());
      }
    }
    std::sort(marks.begin(), marks.end());
    std::vector<double> distinct;
    for (const double mark : marks)
      if (distinct.empty() || mark - distinct.back() > same)
        distinct.push_back(mark);
    return distinct;
  }

private:
  struct Segment {
    Vector2d from, to;
  };

  /** \brief Is no wall or opening between a place and the side, except for the one that it is
   * in? */
  bool
  isNext(const Vector2d& place) const
  {
    constexpr double beside = 0.02; // metres
    const auto isHidden = [&](double x) {
      return std::any_of(closed_.begin(), closed_.end(), [&](const Segment& wall) {
        if ((wall.from.x() > x) == (wall.to.x() > x))
          return false;
        const double share = (x - wall.from.x()) / (wall.to.x() - wall.from.x());
        return wall.from.y() + share * (wall.to.y() - wall.from.y()) >
               place.y() + thickest_wall;
      });
    };
    return !isHidden(place.x() - beside) || !isHidden(place.x() + beside);
  }

  Vector2d along_, outwards_;
  std::vector<Segment> walls_;
  std::vector<Segment> closed_; ///< and what is not seen of them, and their openings
};

/** \brief Draws chains on one side. */
class ChainDrawer {
public:
  ChainDrawer(const BuildingSide& side, PlanDrawing& drawing, TextPlaces& places)
  : side_(side)
  , drawing_(drawing)
  , places_(places)
  , angle_(readableAngle(side.direction()))
  {
    const Vector2d up(-std::sin(angle_), std::cos(angle_));
    above_ = side_.flat(up).y() > 0 ? 1 : -1;
  }

  /** \param[in] away of the chain, metres
   * \param[in] from of the lines from the building to it */
  void
  draw(const std::vector<double>& marks, double from, double away)
  {
    const double more = drawing_.metres(overhang), slash = drawing_.metres(tick);
    addLine({marks.front() - more, away}, {marks.back() + more, away});
    for (const double mark : marks) {
      addLine({mark, from}, {mark, away + more});
      addLine({mark - slash, away - slash}, {mark + slash, away + slash}, 0.3);
    }
    for (std::size_t k = 0; k + 1 < marks.size(); ++k)
      addLength(marks[k], marks[k + 1], away);
  }

private:
  void
  addLine(const Vector2d& from, const Vector2d& to, double width = dimension_pen.width)
  {
    PlanPen pen = dimension_pen;
    pen.width = width;
    drawing_.addLine(PlanLayer::Dimensions,
                     side_.lifted(from.x(), from.y()),
                     side_.lifted(to.x(), to.y()),
                     pen);
  }

  /** \brief Adds a length where there is none yet: above the chain, below it, in the rows
   * after these, or beside its part; otherwise it is left out. */
  void
  addLength(double begin, double end, double away)
  {
    PlanText text{{}, fixed(end - begin, 2), text_height, angle_};
    text.color = dimension_pen.color;
    const double middle = (begin + end) / 2, beside = end - begin + drawing_.metres(6);
    for (const double aside : {0.0, 0.5, -0.5})
      for (const int row : {1, -1, 2, -2}) {
        const double off = text_off + (std::abs(row) - 1) * 1.6 * text_height;
        const double at = away + (row > 0 ? above_ : -above_) * drawing_.metres(off);
        text.place = side_.lifted(middle + aside * beside, at);
        if (!places_.areFree({text}, drawing_.scale))
          continue;
        if (std::abs(row) > 1 || aside != 0)
          addLine({middle, away}, {middle + aside * beside, at});
        places_.take(text, drawing_.scale);
        drawing_.add(PlanLayer::Dimensions, text);
        return;
      }
  }

  const BuildingSide& side_;
  PlanDrawing& drawing_;
  TextPlaces& places_;
  double angle_;
  double above_; ///< 1 if a text stands upright on the outer side of a chain, else -1
};

} // namespace

void
addDimensions(const FloorPlan& plan,
              const std::vector<DrawnOpening>& openings,
              const Vector2d& x_axis,
              const std::vector<Vector2d>& contents,
              PlanDrawing& drawing,
              TextPlaces& places)
{
  const Vector2d y_axis(-x_axis.y(), x_axis.x());
  for (const Vector2d& outwards :
       {Vector2d(-y_axis), x_axis, y_axis, Vector2d(-x_axis)}) {
    const BuildingSide side(plan, outwards);
    const Eigen::AlignedBox2d extent = side.extent();
    constexpr double shortest = 0.5; // metres
    if (extent.isEmpty() || extent.sizes().x() < shortest)
      continue;
    double edge = extent.max().y();
    for (const Vector2d& place : contents)
      edge = std::max(edge, side.flat(place).y());
    const double from = edge + drawing.metres(4);
    const std::vector<double> marks = side.marks(openings);
    const bool has_parts = marks.size() > 2;
    ChainDrawer chain(side, drawing, places);
    if (has_parts)
      chain.draw(marks, from, edge + drawing.metres(inner_chain));
    chain.draw({extent.min().x(), extent.max().x()},
               from,
               edge + drawing.metres(has_parts ? outer_chain : inner_chain));
  }
}

} // namespace pcl::acmap
