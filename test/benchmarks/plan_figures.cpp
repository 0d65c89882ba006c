#include "bench.h"
#include "plan_scenes.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"

#include <pcl/core/map_file.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/pipeline/surface_names.h>
#include <pcl/texture/floor_plan.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief A line or a filled quadrilateral of a drawing. */
struct DrawnShape {
  std::string kind, layer, line_type;
  int color = 0; ///< 0: that of its layer
  std::array<Vector2d, 4> points{
      Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero()};
};

/** \brief Reads a drawing as a CAD program would. */
std::vector<DrawnShape>
readDxf(const std::string& text)
{
  std::vector<DrawnShape> shapes;
  std::istringstream lines(text);
  for (std::string code, value;
       std::getline(lines, code) && std::getline(lines, value);) {
    const int number = std::stoi(code);
    if (number == 0)
      shapes.push_back({value});
    else if (shapes.empty())
      continue;
    else if (number == 8)
      shapes.back().layer = value;
    else if (number == 6)
      shapes.back().line_type = value;
    else if (number == 62)
      shapes.back().color = std::stoi(value);
    else if (number >= 10 && number < 14)
      shapes.back().points[static_cast<std::size_t>(number - 10)].x() =
          std::stod(value);
    else if (number >= 20 && number < 24)
      shapes.back().points[static_cast<std::size_t>(number - 20)].y() =
          std::stod(value);
  }
  return shapes;
}

/** \brief Path of a file that is kept, if the environment variable ACMAP_PLANS names a folder:
 * drawings, and maps, which the next run takes from there. */
std::string
keptPath(const std::string& name)
{
  const char* const folder = std::getenv("ACMAP_PLANS");
  return folder ? std::string(folder) + "/" + name : std::string();
}

/** \brief Tells what is wrong with a plan that is kept. */
void
tell(const PlanScene& truth,
     const std::string& what,
     const Vector2d& from,
     const Vector2d& to)
{
  if (!keptPath("").empty())
    std::cerr << truth.name << ": " << what << " from " << from.transpose() << " to "
              << to.transpose() << "\n";
}

/** \brief The map of all views with their true poses, as the chain makes it. */
CompactMap
mapOf(const SimulatedScene& scene)
{
  const SimulatedCloud all = makeSceneCloud(scene);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(all.merged);
  PlaneMapping mapping;
  mapping.setInputCloud(file);
  mapping.setViewpoints(all.sensorOrigins());
  mapping.setComputeCylinders(true);
  mapping.setComputeBoxes(true);
  MappedPlanes found;
  mapping.compute(found);
  CompactMap map;
  map.planes = found.planes;
  map.cylinders = found.cylinders;
  map.boxes = found.boxes;
  map.recesses = found.recesses;
  map.trajectory = all.merged.trajectory;
  return map;
}

/** \brief A plan in the coordinates of its scene: x and z. */
class JudgedPlan {
public:
  explicit JudgedPlan(const PlanScene& truth)
  : T_scene_map_(truth.scene.views.front())
  {
    const std::string kept = keptPath(truth.name + ".json");
    if (std::filesystem::exists(kept))
      map = loadMapFile(kept);
    else
      map = mapOf(truth.scene);
    if (!kept.empty())
      saveMapFile(kept, map);
    setRooms(makeFloorPlan(map), map);
    nameSurfaces(makeFloorPlan(map), map);
    plan = makeFloorPlan(map);
    const test::TemporaryFolder folder;
    saveFloorPlan(folder.path("plan.dxf"), plan);
    drawing = readDxf(test::contentOf(folder.path("plan.dxf")));
    if (!kept.empty())
      for (const char* ending : {".png", ".svg"})
        saveFloorPlan(keptPath(truth.name + ending), plan);
  }

  Vector2d
  inScene(const Vector2d& place) const
  {
    const Vector3d in_map =
        place.x() * plan.x_axis + place.y() * plan.y_axis + plan.cut * plan.up;
    const Vector3d moved = T_scene_map_ * in_map;
    return {moved.x(), moved.z()};
  }

  Vector2d
  inScene(const Vector3d& place) const
  {
    const Vector3d moved = T_scene_map_ * place;
    return {moved.x(), moved.z()};
  }

  CompactMap map;
  FloorPlan plan;
  std::vector<DrawnShape> drawing; ///< places of the plan

private:
  Eigen::Isometry3d T_scene_map_;
};

/** \brief A segment, seen from the left. */
struct Segment {
  Vector2d from, to;

  Vector2d
  along() const
  {
    return (to - from).normalized();
  }

  Vector2d
  front() const
  {
    return {-along().y(), along().x()};
  }

  double
  length() const
  {
    return (to - from).norm();
  }
};

/** \brief How a plan agrees with the truth. */
struct PlanScores {
  double seen = 0, drawn = 0, wrong = 0; ///< of walls, metres
  std::set<int> walls, found_walls;      ///< numbers of walls
  std::size_t doors = 0, found_doors = 0, windows = 0, found_windows = 0;
  std::size_t wrong_openings = 0;
  std::vector<double> offsets; ///< of walls, metres
  std::vector<double>
      dimensions; ///< errors: widths and heights, thicknesses, spans of rooms
};

constexpr double sample_step = 0.05, same_wall = 0.03, min_cosine = 0.98;

constexpr double max_error = 0.02; // metres

/** \brief Adds the error of a dimension. \param[in] place of it */
void
addError(const PlanScene& truth,
         const std::string& kind,
         double found,
         double real,
         const Vector2d& place,
         PlanScores& scores)
{
  scores.dimensions.push_back(found - real);
  if (!(std::abs(found - real) <= max_error))
    tell(truth,
         kind + " " + std::to_string(found) + " instead of " + std::to_string(real),
         place,
         place);
}

/** \brief Distance from a face to the nearest one of the others there, along its normal; NaN if
 * none is within a reach. */
template <typename Faces>
double
offsetAt(const Vector2d& place, const Vector2d& front, const Faces& faces, double reach)
{
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for (const Segment& other : faces) {
    const double aside = other.along().dot(place - other.from);
    const double offset =
        front.dot(other.from - place) + aside * front.dot(other.along());
    if (other.front().dot(front) > min_cosine && aside > -same_wall &&
        aside < other.length() + same_wall && std::abs(offset) < reach &&
        !(std::abs(offset) > std::abs(nearest)))
      nearest = offset;
  }
  return nearest;
}

template <typename Visitor>
void
forEachSample(const Segment& face, const Visitor& visit)
{
  for (double at = sample_step / 2; at < face.length(); at += sample_step)
    visit(face.from + at * face.along());
}

void
scoreWalls(const PlanScene& truth, const JudgedPlan& judged, PlanScores& scores)
{
  std::vector<Segment> drawn, exists;
  for (const DrawnShape& shape : judged.drawing)
    if (shape.kind == "LINE" && shape.layer == "WALLS" && shape.line_type.empty())
      drawn.push_back(
          {judged.inScene(shape.points[0]), judged.inScene(shape.points[1])});
  std::map<int, std::pair<double, double>> of_walls; // seen and drawn, metres
  for (const TrueFace& face : truth.faces) {
    const Segment segment{face.from, face.to};
    exists.push_back(segment);
    if (face.wall >= 0)
      forEachSample(segment, [&](const Vector2d& place) {
        if (!truth.isSeen(place, segment.front()))
          return;
        const double offset = offsetAt(place, segment.front(), drawn, same_wall);
        const double part = std::isnan(offset) ? 0 : sample_step;
        scores.seen += sample_step;
        scores.drawn += part;
        of_walls[face.wall].first += sample_step;
        of_walls[face.wall].second += part;
        if (part > 0)
          scores.offsets.push_back(std::abs(offset));
      });
  }
  constexpr double smallest = 0.3, min_share = 0.8; // metres, of a wall that was seen
  for (const auto& [wall, lengths] : of_walls)
    if (lengths.first >= smallest) {
      scores.walls.insert(wall);
      if (lengths.second >= min_share * lengths.first)
        scores.found_walls.insert(wall);
    }
  constexpr double near = 0.1; // metres
  for (const Segment& face : drawn) {
    double wrong = 0;
    forEachSample(face, [&](const Vector2d& place) {
      if (std::isnan(offsetAt(place, face.front(), exists, near)))
        wrong += sample_step;
    });
    scores.wrong += wrong;
    if (wrong > smallest)
      tell(truth, "wrong wall", face.from, face.to);
  }
}

bool
isSeen(const PlanScene& truth, const TrueOpening& opening)
{
  const Segment segment{opening.from, opening.to};
  const Vector2d middle = (opening.from + opening.to) / 2;
  return truth.isSeen(middle, segment.front()) ||
         truth.isSeen(middle, -segment.front());
}

void
scoreOpenings(const PlanScene& truth, const JudgedPlan& judged, PlanScores& scores)
{
  constexpr double beside = 0.25, across = 0.45; // metres
  std::vector<bool> is_true(judged.map.openings.size());
  for (const TrueOpening& opening : truth.openings) {
    const Segment segment{opening.from, opening.to};
    const Vector2d middle = (opening.from + opening.to) / 2;
    bool is_found = false;
    for (std::size_t k = 0; k < judged.map.openings.size(); ++k) {
      const MapOpening& other = judged.map.openings[k];
      const Segment drawn{judged.inScene(other.from), judged.inScene(other.to)};
      const Vector2d off = (drawn.from + drawn.to) / 2 - middle;
      if (std::abs(drawn.along().dot(segment.along())) < min_cosine ||
          std::abs(off.dot(segment.along())) > beside ||
          std::abs(off.dot(segment.front())) > across)
        continue;
      is_true[k] = true;
      if (is_found || (other.kind == OpeningKind::Window) != opening.is_window)
        continue;
      is_found = true;
      if (isSeen(truth, opening)) {
        addError(truth, "width", drawn.length(), segment.length(), middle, scores);
        if (std::isfinite(other.top)) // otherwise the drawing states none
          addError(truth,
                   "height",
                   other.top - other.bottom,
                   opening.top - opening.bottom,
                   middle,
                   scores);
      }
    }
    if (isSeen(truth, opening)) {
      ++(opening.is_window ? scores.windows : scores.doors);
      (opening.is_window ? scores.found_windows : scores.found_doors) += is_found;
      if (!is_found)
        tell(truth,
             opening.is_window ? "missing window" : "missing door",
             opening.from,
             opening.to);
    }
  }
  for (std::size_t k = 0; k < is_true.size(); ++k)
    if (!is_true[k]) {
      ++scores.wrong_openings;
      tell(truth,
           "wrong opening",
           judged.inScene(judged.map.openings[k].from),
           judged.inScene(judged.map.openings[k].to));
    }
}

/** \brief Distance to the first face that looks back, in a direction. */
double
spanTo(const Vector2d& from,
       const Vector2d& direction,
       const std::vector<Segment>& faces)
{
  double nearest = std::numeric_limits<double>::quiet_NaN();
  const Vector2d aside(-direction.y(), direction.x());
  for (const Segment& face : faces) {
    const double a = aside.dot(face.from - from), b = aside.dot(face.to - from);
    if ((a > 0) == (b > 0) || face.front().dot(direction) > -min_cosine)
      continue;
    const double distance =
        direction.dot(face.from + a / (a - b) * (face.to - face.from) - from);
    if (distance > 0 && !(distance > nearest))
      nearest = distance;
  }
  return nearest;
}

/** \brief Compares the spans of rooms along both axes, and the thicknesses of filled walls. */
void
scoreLengths(const PlanScene& truth, const JudgedPlan& judged, PlanScores& scores)
{
  std::vector<Segment> drawn, exists;
  for (const PlanWall& wall : judged.plan.walls)
    if (wall.role == SurfaceRole::Wall)
      drawn.push_back({judged.inScene(wall.from), judged.inScene(wall.to)});
  for (const TrueFace& face : truth.faces)
    if (face.wall >= 0)
      exists.push_back({face.from, face.to});
  constexpr double other_wall = 0.1; // metres: then it is not the same one
  const auto compare =
      [&](const char* kind, double found, double real, const Vector2d& place) {
        if (std::abs(found - real) < other_wall)
          addError(truth, kind, found, real, place, scores);
      };
  for (const PlanRoom& room : judged.plan.rooms) {
    const Vector2d center = judged.inScene(room.center);
    for (const Vector2d& way : {Vector2d(1, 0), Vector2d(0, 1)})
      compare("span",
              spanTo(center, way, drawn) + spanTo(center, -way, drawn),
              spanTo(center, way, exists) + spanTo(center, -way, exists),
              center);
  }
  for (const DrawnShape& shape : judged.drawing)
    if (shape.kind == "SOLID" && shape.layer == "WALLS" && shape.color == 0) {
      const Segment face{judged.inScene(shape.points[0]),
                         judged.inScene(shape.points[1])};
      constexpr double shortest = 0.3; // metres
      const Vector2d middle = (face.from + face.to) / 2, inwards = -face.front();
      if (face.length() < shortest)
        continue;
      const double thickness = inwards.dot(
          (judged.inScene(shape.points[2]) + judged.inScene(shape.points[3])) / 2 -
          middle);
      std::vector<Segment> backs;
      for (const Segment& one : exists)
        backs.push_back({one.to, one.from}); // seen from inside of the wall
      const double off = offsetAt(middle, face.front(), exists, other_wall);
      compare("thickness",
              thickness,
              spanTo(middle + off * face.front() + 1e-4 * inwards, inwards, backs) +
                  1e-4,
              middle);
    }
}

void
print(const PlanScene& truth)
{
  const JudgedPlan judged(truth);
  PlanScores scores;
  scoreWalls(truth, judged, scores);
  scoreOpenings(truth, judged, scores);
  scoreLengths(truth, judged, scores);
  std::vector<double> errors;
  for (const double error : scores.dimensions)
    errors.push_back(std::abs(error));
  const auto within = std::count_if(
      errors.begin(), errors.end(), [](double e) { return e <= max_error; });
  const auto shareOf = [](std::size_t found, std::size_t all) {
    return std::to_string(found) + " of " + std::to_string(all);
  };
  Row() << truth.name << judged.plan.rooms.size() << figure(scores.seen, 1)
        << atLeast(100 * scores.drawn / scores.seen, 95, 1)
        << shareOf(scores.found_walls.size(), scores.walls.size())
        << figure(scores.wrong, 1) << shareOf(scores.found_doors, scores.doors)
        << shareOf(scores.found_windows, scores.windows) << scores.wrong_openings
        << figure(milli * median(scores.offsets), 1) << errors.size()
        << atLeast(percent(static_cast<std::size_t>(within), errors.size()), 95, 1)
        << figure(centi * quantile(errors, 0.95), 1)
        << figure(centi * largest(errors), 1);
}

void
printHeadOfPlans()
{
  printHead(
      "scene | rooms | walls seen, m | of it drawn % | walls | drawn, not there, m | "
      "doors | windows | wrong openings | walls off, median, mm | dimensions | within "
      "2 cm % | 95 %, cm | worst, cm");
}

const Section scenes_section("scenes", [] {
  printHeadOfPlans();
  for (const char* name : {"office", "corridor_survey", "l_corridor", "loop"})
    print(standardPlanScene(name));
});

const Section models_section("models", [] {
  printHeadOfPlans();
  for (const auto& [model, floor] : {std::pair("AC20-FZK-Haus", 0.0),
                                     std::pair("duplex", 0.0),
                                     std::pair("duplex", 3.1)})
    if (const auto truth = modelPlanScene(model, floor))
      print(*truth);
});

} // namespace
} // namespace pcl::acmap::bench
