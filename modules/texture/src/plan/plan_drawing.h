#pragma once

#include <pcl/texture/floor_plan.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace pcl::acmap {

/** \brief 180 degrees in radians. */
inline constexpr double half_turn = 3.14159265358979323846;

/** \brief Layers of a drawing, from the lowest one. */
enum class PlanLayer : std::uint8_t {
  Floor,
  Furniture,
  Walls,
  Windows,
  Doors,
  Rooms,
  Dimensions,
  North,
  Title
};

/** \brief Their names in CAD programs. */
inline constexpr std::array<const char*, 9> plan_layer_names{"FLOOR",
                                                             "FURNITURE",
                                                             "WALLS",
                                                             "WINDOWS",
                                                             "DOORS",
                                                             "ROOMS",
                                                             "DIMENSIONS",
                                                             "NORTH",
                                                             "TITLE"};

/** \brief Red, green, blue. */
using PlanColor = std::array<std::uint8_t, 3>;

inline constexpr PlanColor paper_color{255, 255, 255}, ink{24, 24, 24};

/** \brief A stroke with round ends. */
struct PlanPen {
  double width = 0.18; ///< millimetres of the paper
  PlanColor color = ink;
  bool is_dashed = false;
};

/** \brief An area without an outline: inside of an odd number of loops. */
struct PlanArea {
  std::vector<std::vector<Eigen::Vector2d>> loops;
  PlanColor color = ink;
};

/** \brief A line through two points or more. */
struct PlanLine {
  std::vector<Eigen::Vector2d> points;
  PlanPen pen;
  bool is_closed = false;
};

/** \brief A part of a circle, counter-clockwise; radians from the x axis. */
struct PlanArc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
  double begin = 0;
  double end = 0; ///< begin + 2 pi for a circle
  PlanPen pen;
};

/** \brief What of a text is at its place, halfway up its capital letters. */
enum class PlanAlign : std::uint8_t { Left, Middle, Right };

/** \brief A line of text, UTF-8. */
struct PlanText {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::string text;
  double height = 2; ///< of a capital letter, millimetres of the paper
  double angle = 0;  ///< counter-clockwise from the x axis, radians
  PlanAlign align = PlanAlign::Middle;
  PlanColor color = ink;
};

/** \brief A part of a drawing. Places are metres in the frame of the plan. */
struct PlanItem {
  PlanLayer layer = PlanLayer::Walls;
  std::variant<PlanArea, PlanLine, PlanArc, PlanText> shape;
};

/** \brief A floor plan as it is printed: what all formats of pictures show. */
struct PlanDrawing {
  double scale = 100;          ///< metres in the building for one on the paper
  Eigen::AlignedBox2d sheet;   ///< of the paper, metres in the frame of the plan
  std::string title;           ///< what the drawing is
  std::string note;            ///< where it is in the frame of the input; may be empty
  std::vector<PlanItem> items; ///< by layer

  /** \brief Metres in the building of some millimetres of the paper. */
  double
  metres(double millimetres) const
  {
    return millimetres * scale / 1000;
  }

  template <typename Shape>
  void
  add(PlanLayer layer, Shape shape)
  {
    PlanItem& item = items.emplace_back();
    item.layer = layer;
    item.shape = std::move(shape);
  }

  void
  addLine(PlanLayer layer,
          const Eigen::Vector2d& from,
          const Eigen::Vector2d& to,
          const PlanPen& pen)
  {
    add(layer, PlanLine{{from, to}, pen});
  }
};

/** \brief Draws a plan as an architect does: walls filled and joined, doors with the area
 * of their leaf, windows as double lines, dimensions, names and areas of rooms, a legend,
 * a scale bar and a title. The scale is 1 : 50 if the sheet fits A3 then, or the next one
 * of 1 : 100, 200, 500 and so on. */
PlanDrawing
drawPlan(const FloorPlan& plan);

} // namespace pcl::acmap
