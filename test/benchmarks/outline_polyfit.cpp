#include "outline_tables.h"

#include "child_process.h"
#include "markdown_row.h"
#include "outline_scores.h"
#include "polygonal_surface.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"
#include "timing.h"

#include <pcl/core/map_file.h>
#include <pcl/simulation/standard_scenes.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>

#include <sys/resource.h>

namespace pcl::acmap::bench {
namespace {

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
  const auto distance = [&](const TruthPlane& plane) {
    double maximum = 0;
    for (const Eigen::Vector3d& corner : corners)
      maximum = std::max(
          maximum,
          std::abs(plane.coefficients.head<3>().dot(corner) + plane.coefficients[3]));
    return maximum;
  };
  const auto nearest = std::min_element(
      planes.begin(), planes.end(), [&](const TruthPlane& a, const TruthPlane& b) {
        return distance(a) < distance(b);
      });
  return static_cast<std::size_t>(nearest - planes.begin());
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
printRow(const std::string& scene,
         const std::string& method,
         double seconds,
         const std::vector<PlanePatch>& planes,
         const SimulatedScene& simulated,
         const VisibleTruth& truth)
{
  const std::vector<PlaneOutline> outlines =
      makeOutlines(planes, simulated.views.front());
  const OutlineCounts counts = countOutlines(outlines);
  const OutlineScores scores = scoreOutlines(outlines, truth);
  MarkdownRow()
      .text(scene)
      .text(method)
      .text("yes")
      .number(seconds, 2)
      .count(counts.polygons)
      .number(scores.common / (scores.joined + truth.seenArea() - scores.seen), 4)
      .number(100 - 100 * scores.common / truth.seenArea(), 2)
      .number(100 * (scores.unseen + scores.nothing) / truth.seenArea(), 2)
      .number(counts.area / truth.seenArea(), 3)
      .print();
}

void
printUnsolved(const std::string& scene, double seconds)
{
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  MarkdownRow row;
  row.text(scene).text("PolyFit").text("no").number(seconds, 2);
  for (int column = 0; column < 5; ++column)
    row.number(nothing, 0);
  row.print();
}

} // namespace

void
printPolyfitOutlines(const std::vector<std::string>& names,
                     const OutlineOptions& options)
{
  const test::TemporaryFolder folder;
  std::vector<SimulatedScene> scenes;
  std::vector<VisibleTruth> truths;
  std::vector<PolyfitRun> runs; // before there are threads
  for (const std::string& name : names) {
    scenes.push_back(standardScene(name));
    truths.push_back(findVisibleTruth(scenes.back()));
    runs.push_back(runPolyfit(name, truths.back().face_of_plane, folder.path(name)));
  }
  std::cout << "\n### Closed surfaces\n";
  printHead({"scene",
             "method",
             "solved",
             "CPU s",
             "polygons",
             "IoU, all faces",
             "seen but missing %",
             "surplus %",
             "area : seen area"});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (runs[i].faces > 0)
      printRow(names[i],
               "PolyFit",
               runs[i].seconds,
               loadMapFile(folder.path(names[i])).planes,
               scenes[i],
               truths[i]);
    else
      printUnsolved(names[i], runs[i].seconds);
    const JudgedMap map =
        makeJudgedMap(names[i], options, [&] { return observeScene(scenes[i]); });
    printRow(names[i], "acmap", map.seconds, map.planes, scenes[i], truths[i]);
  }
}

} // namespace pcl::acmap::bench
