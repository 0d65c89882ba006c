#include "bench.h"
#include "outline_scores.h"
#include "processes.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"

#include <pcl/core/map_file.h>
#include <pcl/simulation/standard_scenes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Polygonal_surface_reconstruction.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <Eigen/Core>
#include <sys/resource.h>

#include <stdexcept>
#include <tuple>

namespace pcl::acmap::bench {
namespace {

/** \brief Points with the planes that they are on. */
struct LabelledPoints {
  std::vector<Eigen::Vector3f> points;  ///< metres
  std::vector<std::int32_t> labels;     ///< index of a plane, -1 for none
  std::vector<Eigen::Vector3d> normals; ///< of the planes; each has points
};

/** \brief Faces of the closed surface that CGAL's Polygonal_surface_reconstruction
 * (PolyFit) selects with its default weights and GLPK; empty if the solver failed. */
std::vector<std::vector<Eigen::Vector3d>>
polygonalSurface(const LabelledPoints& input)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = std::tuple<Kernel::Point_3, Kernel::Vector_3, int>;
  std::vector<Point> points;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const Eigen::Vector3d place = input.points[i].cast<double>();
    const std::int32_t label = input.labels[i];
    const Eigen::Vector3d normal = label < 0
                                       ? Eigen::Vector3d::UnitX()
                                       : input.normals[static_cast<std::size_t>(label)];
    points.emplace_back(Kernel::Point_3(place.x(), place.y(), place.z()),
                        Kernel::Vector_3(normal.x(), normal.y(), normal.z()),
                        label);
  }
  CGAL::Polygonal_surface_reconstruction<Kernel> reconstruction(
      points,
      CGAL::Nth_of_tuple_property_map<0, Point>(),
      CGAL::Nth_of_tuple_property_map<1, Point>(),
      CGAL::Nth_of_tuple_property_map<2, Point>());
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::vector<std::vector<Eigen::Vector3d>> faces;
  if (!reconstruction.reconstruct<CGAL::GLPK_mixed_integer_program_traits<double>>(
          mesh)) {
    std::cerr << "PolyFit: " << reconstruction.error_message() << "\n";
    return faces;
  }
  for (const auto face : mesh.faces()) {
    std::vector<Eigen::Vector3d>& corners = faces.emplace_back();
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      const Kernel::Point_3& point = mesh.point(vertex);
      corners.emplace_back(point.x(), point.y(), point.z());
    }
  }
  return faces;
}

constexpr double time_limit = 120;         // seconds of CPU time
constexpr std::size_t max_points = 100000; // of a scene, for the peer

/** \brief Ends this process when it has used \a seconds more of CPU time. */
void
limitTime(double seconds)
{
  rlimit limit{};
  limit.rlim_cur = limit.rlim_max =
      static_cast<rlim_t>(std::ceil(processSeconds() + seconds));
  if (::setrlimit(RLIMIT_CPU, &limit) != 0)
    throw std::runtime_error("no limit of time");
}

/** \brief A part of the points with their true labels. Planes that lie in one plane are
 * one; those with few points are left out. The frame is that of the map. */
LabelledPoints
labelledPoints(const SimulatedScene& scene,
               const std::vector<std::size_t>& face_of_plane)
{
  constexpr std::size_t min_points = 30;
  const SimulatedCloud part = makeRandomPart(makeSceneCloud(scene), max_points, 1);
  const std::vector<TruthPlane>& planes = part.merged.planes;
  std::vector<std::size_t> counts(planes.size());
  for (const std::uint32_t label : part.merged.label)
    if (label > 0)
      ++counts[face_of_plane[label - 1]];
  LabelledPoints input;
  input.points = part.merged.points;
  std::vector<std::int32_t> number_of_face(planes.size(), -1);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    std::int32_t& number = number_of_face[face_of_plane[p]];
    if (number < 0 && counts[face_of_plane[p]] >= min_points) {
      number = static_cast<std::int32_t>(input.normals.size());
      input.normals.push_back(planes[p].coefficients.head<3>());
    }
  }
  for (const std::uint32_t label : part.merged.label)
    input.labels.push_back(label > 0 ? number_of_face[face_of_plane[label - 1]] : -1);
  return input;
}

/** \brief The true plane whose distance from the corners of a face is the smallest. */
std::size_t
nearestPlane(const std::vector<Eigen::Vector3d>& corners,
             const std::vector<TruthPlane>& planes)
{
  const std::vector<double> distances = valuesOf(planes, [&](const TruthPlane& plane) {
    return largest(valuesOf(corners, [&](const Eigen::Vector3d& corner) {
      return std::abs(plane.coefficients.dot(corner.homogeneous()));
    }));
  });
  return static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) -
                                  distances.begin());
}

/** \brief Faces as the polygons of planes, which are those of the truth: the peer was
 * told them. */
std::vector<PlanePatch>
patchesOf(const std::vector<std::vector<Eigen::Vector3d>>& faces,
          const std::vector<TruthPlane>& planes)
{
  std::vector<PlanePatch> patches(planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p)
    patches[p].coefficients = planes[p].coefficients;
  for (const std::vector<Eigen::Vector3d>& face : faces) {
    PlanePolygon& polygon = patches[nearestPlane(face, planes)].polygons.emplace_back();
    for (const Eigen::Vector3d& corner : face)
      polygon.outer.push_back(corner.cast<float>());
  }
  return patches;
}

/** \brief What a child process tells; its faces are in a file. */
struct PolyfitRun {
  double seconds = 0;    ///< CPU
  std::size_t faces = 0; ///< 0 if it was not solved
};

PolyfitRun
runPolyfit(const std::string& name,
           const std::vector<std::size_t>& face_of_plane,
           const std::string& file)
{
  try {
    return runInChild([&] {
      const SimulatedScene scene = standardScene(name);
      const LabelledPoints input = labelledPoints(scene, face_of_plane);
      limitTime(time_limit);
      std::vector<std::vector<Eigen::Vector3d>> faces;
      PolyfitRun run;
      run.seconds = measureCost([&] { faces = polygonalSurface(input); }).cpu;
      run.faces = faces.size();
      CompactMap map;
      map.planes = patchesOf(faces, planesInMap(scene));
      saveMapFile(file, map);
      return run;
    });
  }
  catch (const std::runtime_error&) {
    return {time_limit, 0};
  }
}

void
printSurface(const std::string& scene,
             const std::string& method,
             const JudgedMap& map,
             const SimulatedScene& simulated,
             const VisibleTruth& truth)
{
  const std::vector<PlaneOutline> outlines =
      makeOutlines(map.planes, simulated.views.front());
  const OutlineCounts counts = countOutlines(outlines);
  const OutlineScores scores = scoreOutlines(outlines, truth);
  const double seen = truth.seenArea();
  Row() << scene << method << "yes" << figure(map.seconds, 2) << counts.polygons
        << figure(scores.common / (scores.joined + seen - scores.seen), 4)
        << figure(100 - 100 * scores.common / seen, 2)
        << figure(100 * (scores.unseen + scores.nothing) / seen, 2)
        << figure(counts.area / seen, 3);
}

/** The surfaces that PolyFit makes, knowing the true planes, beside ours. */
const Section polyfit_section("polyfit", [] {
  const test::TemporaryFolder folder;
  const std::vector<std::string> names{
      "corridor_survey", "office", "l_corridor", "loop"};
  std::vector<SimulatedScene> scenes;
  std::vector<VisibleTruth> truths;
  std::vector<PolyfitRun> runs; // before there are threads
  for (const std::string& name : names) {
    scenes.push_back(standardScene(name));
    truths.push_back(findVisibleTruth(scenes.back()));
    runs.push_back(runPolyfit(name, truths.back().face_of_plane, folder.path(name)));
  }
  printHead("scene | method | solved | CPU s | polygons | IoU, all faces | seen but "
            "missing % | surplus % | area : seen area");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (runs[i].faces > 0)
      printSurface(names[i],
                   "PolyFit",
                   {loadMapFile(folder.path(names[i])).planes, runs[i].seconds},
                   scenes[i],
                   truths[i]);
    else
      Row() << names[i] << "PolyFit | no" << figure(runs[i].seconds, 2) << no_value
            << no_value << no_value << no_value << no_value;
    printSurface(names[i], "acmap", findJudgedMap(scenes[i]), scenes[i], truths[i]);
  }
});

} // namespace
} // namespace pcl::acmap::bench
