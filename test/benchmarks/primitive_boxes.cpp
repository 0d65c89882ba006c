#include "bench.h"
#include "primitive_scenes.h"

#include <pcl/core/random.h>
#include <pcl/segmentation/box_fitting.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Geometry>

#include <array>
#include <utility>
#include <variant>

namespace pcl::acmap::bench {
namespace {

/** How boxes were found. */
struct BoxFigures {
  std::size_t found = 0;
  double size_error = 0;       ///< metres, largest
  double closed_error = 0;     ///< the same, between two sides that are planes
  std::size_t wrong_sides = 0; ///< seen where there is no face, or snapped to nothing

  void
  judge(const BoxPatch& box, const Eigen::Matrix3d& axes, const SceneBox& truth)
  {
    ++found;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      Eigen::Index along = 0;
      axes.col(axis).cwiseAbs().maxCoeff(&along);
      const double error = std::abs(box.size[axis] - truth.place.sizes()[along]);
      size_error = std::max(size_error, error);
      bool is_closed = true;
      for (std::size_t end = 0; end < 2; ++end) {
        const bool is_low = (axes(along, axis) < 0) != (end == 1);
        const bool has_face =
            truth.has_face[2 * static_cast<std::size_t>(along) + (is_low ? 1 : 0)];
        const BoxFaceKind kind =
            box.faces[2 * static_cast<std::size_t>(axis) + end].kind;
        is_closed = is_closed && kind != BoxFaceKind::Free;
        wrong_sides += kind == (has_face ? BoxFaceKind::Snapped : BoxFaceKind::Seen);
      }
      if (is_closed)
        closed_error = std::max(closed_error, error);
    }
  }
};

constexpr double near_center = 0.1; // metres

void
printBoxes(const std::string& name,
           const SimulatedScene& scene,
           const std::vector<PlanePatch>& planes,
           double reach = 0.01)
{
  BoxFitting fitting;
  std::vector<BoxPatch> boxes;
  fitting.setPlanes(planes);
  const double seconds = measureCost([&] { fitting.segment(boxes); }).cpu;
  const Eigen::Isometry3d T_scene_map = scene.views.front();
  std::size_t in_sight = 0;
  BoxFigures figures;
  for (const SceneBox& truth : boxesOf(scene)) {
    if (!isInSight(scene, truth.place.center()))
      continue;
    ++in_sight;
    for (const BoxPatch& box : boxes)
      if ((T_scene_map * box.center - truth.place.center()).norm() <= near_center)
        figures.judge(box, T_scene_map.linear() * box.axes, truth);
  }
  std::int32_t templates = 0;
  for (const BoxPatch& box : boxes)
    templates = std::max(templates, box.template_id + 1);
  Row() << name << planes.size() << atLeast(figures.found, in_sight, 0)
        << atMost(boxes.size() - figures.found, 0, 0)
        << atMost(milli * figures.size_error, milli * reach, 1)
        << figure(milli * figures.closed_error, 1) << atMost(figures.wrong_sides, 0, 0)
        << templates << figure(seconds, 3);
}

void
printCylinders(const SimulatedScene& scene, const std::vector<CylinderPatch>& patches)
{
  constexpr double reach = 0.3; // millimetres
  const Eigen::Isometry3d T_map_scene = scene.views.front().inverse();
  printHead("cylinder | radius mm | found | radius error mm | length m");
  std::size_t found = 0;
  for (const SimulatedSurface& surface : scene.geometry.surfaces())
    if (const auto* const truth = std::get_if<SimulatedCylinder>(&surface.shape)) {
      const CylinderPatch* const patch =
          patchOf(T_map_scene * truth->base,
                  T_map_scene.linear() * truth->axis.normalized(),
                  truth->radius,
                  patches);
      found += patch ? 1 : 0;
      Row row;
      row << surface.name << figure(milli * truth->radius, 0)
          << atLeast(patch ? 1 : 0, 1, 0);
      if (patch)
        row << atMost(milli * std::abs(patch->radius - truth->radius), reach, 2)
            << figure(patch->high - patch->low, 2);
      else
        row << no_value << no_value;
    }
  std::cout << "\nWrong cylinders: " << patches.size() - std::min(found, patches.size())
            << "\n";
}

const Section boxes_section("boxes", [] {
  printHead("scene | planes | boxes found | wrong | largest size error mm | between "
            "two planes mm | wrong sides | sizes | CPU s");
  const SimulatedScene room = standardScene("room");
  const MappedPlanes mapped = mapScene(room, true);
  printBoxes("room", room, mapped.planes, 0.005);
  for (const std::string name : {"office",
                                 "corridor",
                                 "corridor_drive",
                                 "corridor_survey",
                                 "l_corridor",
                                 "loop"}) {
    const SimulatedScene scene = standardScene(name);
    printBoxes(name, scene, mapScene(scene, false).planes);
  }
  for (const std::string name : {"office", "corridor_drive", "loop"}) {
    const SimulatedScene scene = withoutBoxes(standardScene(name));
    printBoxes(name + " without boxes", scene, mapScene(scene, false).planes);
  }
  printCylinders(room, mapped.cylinders);
});

/** A piece of furniture with a slanted side, in its own frame: x right, y down from the
 * level of the camera, z from the front to the back. */
struct SlantedPiece {
  std::string name;
  Eigen::Isometry3d T_scene_piece = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< of the cuboid
  double rise = 0;      ///< of the slanted side, from the front to the back, metres
  bool is_desk = false; ///< its top is slanted; otherwise its front, below the top

  Eigen::Vector3d
  slantedNormal() const
  {
    const Eigen::Vector3d normal = is_desk ? Eigen::Vector3d(0, -size.z(), -rise)
                                           : Eigen::Vector3d(0, -rise, -size.y());
    return T_scene_piece.linear() * normal.normalized();
  }

  Eigen::Vector3d
  center() const
  {
    return T_scene_piece * Eigen::Vector3d(0, floor - size.y() / 2, size.z() / 2);
  }

  static constexpr double floor = 1.25; ///< y, metres
};

/** Adds rectangles of a piece to a scene. */
class PieceBuilder {
public:
  PieceBuilder(const SlantedPiece& piece, SceneGeometry& geometry)
  : piece_(piece)
  , geometry_(geometry)
  {}

  void
  add(const std::string& plane,
      const Eigen::Vector3d& corner,
      const Eigen::Vector3d& edge_u,
      const Eigen::Vector3d& edge_v)
  {
    const Eigen::Matrix3d turn = piece_.T_scene_piece.linear();
    geometry_.addRectangle(
        piece_.name + " " + plane + " " + std::to_string(number_++),
        piece_.name + " " + plane,
        {piece_.T_scene_piece * corner, turn * edge_u, turn * edge_v},
        look_);
  }

  /** The sides left and right: rectangles whose union, with what floor and wall hide, is
   * a trapezoid.
   * \param[in] from, along edge at the slanted side, in the plane x = 0
   * \param[in] depth of the rectangle at this edge, metres */
  void
  addSlantedFlanks(const Eigen::Vector3d& from,
                   const Eigen::Vector3d& along,
                   double depth)
  {
    const Eigen::Vector3d inward =
        depth * along.cross(Eigen::Vector3d::UnitX()).normalized();
    addFlanks(from + inward, along, -inward);
  }

  void
  addFlanks(const Eigen::Vector3d& corner,
            const Eigen::Vector3d& edge_u,
            const Eigen::Vector3d& edge_v)
  {
    const Eigen::Vector3d half(piece_.size.x() / 2, 0, 0);
    add("right", corner + half, edge_u, edge_v);
    add("left", corner - half, edge_v, edge_u);
  }

private:
  const SlantedPiece& piece_;
  SceneGeometry& geometry_;
  SurfaceLook look_{{158, 128, 88}, 12};
  int number_ = 0;
};

/** A desk at a wall, which is behind it. */
void
addDesk(const SlantedPiece& piece, SceneGeometry& geometry)
{
  const double width = piece.size.x(), high = piece.size.y(), depth = piece.size.z(),
               low = high - piece.rise, floor = SlantedPiece::floor;
  PieceBuilder builder(piece, geometry);
  builder.add("front", {-width / 2, floor, 0}, {width, 0, 0}, {0, -low, 0});
  const Eigen::Vector3d slope(0, -piece.rise, depth);
  builder.add("top", {-width / 2, floor - low, 0}, {width, 0, 0}, slope);
  builder.addFlanks({0, floor, 0}, {0, 0, depth}, {0, -low, 0});
  builder.addSlantedFlanks({0, floor - low, 0}, slope, high);
}

/** A pedestal whose front leans backwards; it stands free. */
void
addPedestal(const SlantedPiece& piece, SceneGeometry& geometry)
{
  const double width = piece.size.x(), high = piece.size.y(), depth = piece.size.z(),
               rise = piece.rise, floor = SlantedPiece::floor;
  PieceBuilder builder(piece, geometry);
  const Eigen::Vector3d slope(0, -high, rise);
  builder.add("front", {-width / 2, floor, 0}, {width, 0, 0}, slope);
  builder.add("back", {width / 2, floor, depth}, {-width, 0, 0}, {0, -high, 0});
  builder.add(
      "top", {-width / 2, floor - high, rise}, {width, 0, 0}, {0, 0, depth - rise});
  builder.addFlanks({0, floor, rise}, {0, 0, depth - rise}, {0, -high, 0});
  builder.addSlantedFlanks({0, floor, 0}, slope, rise * high / slope.norm());
}

Eigen::Isometry3d
poseAt(double x, double z, double degrees)
{
  Eigen::Isometry3d pose(Eigen::Translation3d(x, 0, z));
  pose.rotate(Eigen::AngleAxisd(degrees * degree, Eigen::Vector3d::UnitY()));
  return pose;
}

/** Two equal desks at two walls, a flat one at a third, and a free pedestal; sizes and
 * slopes are random. */
std::vector<SlantedPiece>
randomPieces(Random& random)
{
  SlantedPiece desk;
  desk.is_desk = true;
  desk.size << random.uniform(0.7, 1.1), random.uniform(0.7, 0.9),
      random.uniform(0.5, 0.8);
  desk.rise = random.uniform(0.12, 0.3);
  std::vector<SlantedPiece> pieces(4, desk);
  pieces[0].T_scene_piece = poseAt(-1.1, 8.5 - desk.size.z(), 0);
  pieces[1].T_scene_piece = poseAt(-5 + desk.size.z(), 3, -90);
  pieces[2].T_scene_piece = poseAt(0, -1.5 + desk.size.z(), 180);
  pieces[2].rise = random.uniform(0.07, 0.1);
  pieces[3].T_scene_piece = poseAt(-0.6, 2.6, 20);
  pieces[3].is_desk = false;
  pieces[3].size << random.uniform(0.5, 0.7), random.uniform(0.5, 0.8),
      random.uniform(0.6, 0.8);
  pieces[3].rise = random.uniform(0.1, 0.3);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces[i].name = "piece " + std::to_string(i);
  return pieces;
}

/** How the slanted boxes of a scene were found. */
struct SlantFigures {
  std::size_t pieces = 0, found = 0, wrong = 0, equal_pairs = 0;
  double size_error = 0;  ///< metres, largest
  double slope_error = 0; ///< radians, largest
};

void
judge(const BoxPatch& box,
      const Eigen::Isometry3d& T_scene_map,
      const SlantedPiece& piece,
      SlantFigures& figures)
{
  const Eigen::Matrix3d axes =
      (piece.T_scene_piece.inverse() * T_scene_map).linear() * box.axes;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::Index along = 0;
    axes.col(axis).cwiseAbs().maxCoeff(&along);
    figures.size_error =
        std::max(figures.size_error, std::abs(box.size[axis] - piece.size[along]));
  }
  const Eigen::Vector3d normal = T_scene_map.linear() * box.slant.head<3>();
  figures.slope_error = std::max(figures.slope_error,
                                 std::asin(normal.cross(piece.slantedNormal()).norm()));
}

void
findPieces(Random& random, SlantFigures& figures)
{
  SimulatedScene scene = withoutBoxes(standardScene("room"));
  const std::vector<SlantedPiece> pieces = randomPieces(random);
  for (const SlantedPiece& piece : pieces)
    (piece.is_desk ? addDesk : addPedestal)(piece, scene.geometry);
  BoxFitting fitting;
  fitting.setPlanes(mapScene(scene, false).planes);
  std::vector<BoxPatch> boxes;
  fitting.segment(boxes);
  const Eigen::Isometry3d T_scene_map = scene.views.front();
  std::vector<std::int32_t> templates(pieces.size(), -1);
  std::size_t right = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const BoxPatch& box : boxes)
      if ((T_scene_map * box.center - pieces[i].center()).norm() < near_center &&
          !box.slant.isZero(0)) {
        ++right;
        templates[i] = box.template_id;
        judge(box, T_scene_map, pieces[i], figures);
      }
  figures.pieces += pieces.size();
  figures.found += right;
  figures.wrong += boxes.size() - right;
  figures.equal_pairs += templates[0] >= 0 && templates[0] == templates[1] ? 1 : 0;
}

const Section slants_section("slants", [] {
  constexpr std::size_t rooms = 5;
  constexpr double size_reach = 0.01; // metres
  Random random(20);
  SlantFigures figures;
  for (std::size_t room = 0; room < rooms; ++room)
    findPieces(random, figures);
  printHead("rooms | boxes | found | wrong | equal ones share their size | largest "
            "size error mm | largest error of the slope degrees");
  Row() << rooms << figures.pieces << atLeast(figures.found, figures.pieces, 0)
        << atMost(figures.wrong, 0, 0) << atLeast(figures.equal_pairs, rooms, 0)
        << atMost(milli * figures.size_error, milli * size_reach, 1)
        << figure(figures.slope_error / degree, 2);
});

} // namespace
} // namespace pcl::acmap::bench
