#include "labeling/label_points.h"

#include "labeling/plane_fits.h"
#include "labeling/ray_labels.h"
#include "labeling/stragglers.h"
#include "labeling/verdicts.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace labeling {
namespace {

/** Is each plane large enough, after its parts are merged? */
std::vector<std::uint8_t>
largeEnough(const KnownPlanes& known, const Verdicts& verdicts, double min_area)
{
  std::vector<double> areas(known.planes.size(), 0);
  for (std::size_t p = 0; p < areas.size(); ++p)
    if (verdicts.kept_as[p] >= 0)
      areas[static_cast<std::size_t>(verdicts.kept_as[p])] +=
          known.planes[p].patch.area;
  std::vector<std::uint8_t> is_large;
  for (const double area : areas)
    is_large.push_back(area >= min_area ? 1 : 0);
  return is_large;
}

/** Removes planes that are refuted or too small, merges parts and renumbers the rest.
 * \return for each old plane its new number, -1 for none */
std::vector<std::int32_t>
sift(const Verdicts& verdicts,
     double min_area,
     KnownPlanes& known,
     PlaneClusteringReport& report)
{
  const std::vector<std::uint8_t> is_large = largeEnough(known, verdicts, min_area);
  std::vector<std::int32_t> numbers(known.planes.size(), -1);
  std::vector<KnownPlane> left;
  for (std::size_t p = 0; p < known.planes.size(); ++p) {
    const std::int32_t kept_as = verdicts.kept_as[p];
    if (kept_as < 0)
      continue;
    if (!is_large[static_cast<std::size_t>(kept_as)]) {
      ++report.small_regions;
      continue;
    }
    if (kept_as == static_cast<std::int32_t>(p)) {
      numbers[p] = static_cast<std::int32_t>(left.size());
      left.push_back(known.planes[p]);
      continue;
    }
    numbers[p] = numbers[static_cast<std::size_t>(kept_as)];
    left[static_cast<std::size_t>(numbers[p])].patch.area += known.planes[p].patch.area;
  }
  known.planes = std::move(left);
  for (std::int32_t& label : known.labels)
    label = label < 0 ? -1 : numbers[static_cast<std::size_t>(label)];
  return numbers;
}

std::vector<Eigen::Vector3d>
normalsOf(const std::vector<KnownPlane>& planes)
{
  std::vector<Eigen::Vector3d> normals;
  for (const KnownPlane& plane : planes)
    normals.push_back(plane.patch.coefficients.head<3>());
  return normals;
}

/** Data of a cloud that labelling and fitting need. */
struct Scenery {
  CandidateGrid grid;
  Survey survey;
  RangeNoise noise;

  Scenery(const PointView& points, const SensorView& sensors, KnownPlanes& known)
  : grid(known, 2 * known.spacing, 1)
  , survey(points, sensors, grid)
  , noise(survey, grid, known.planes)
  {
    measureWarps(survey, grid, noise, known.planes);
  }
};

/** Fits those planes again whose parts were separated by pose errors, and increases
 * their warp accordingly. */
void
settleDrift(const Verdicts& verdicts,
            const std::vector<std::int32_t>& numbers,
            const Survey& survey,
            const std::vector<std::int32_t>& labels,
            const Scenery& scenery,
            const std::vector<Eigen::Vector3d>& guesses,
            KnownPlanes& known)
{
  std::vector<double> drift(known.planes.size(), 0);
  for (std::size_t p = 0; p < numbers.size(); ++p)
    if (numbers[p] >= 0) {
      double& largest = drift[static_cast<std::size_t>(numbers[p])];
      largest = std::max(largest, verdicts.drift[p]);
    }
  if (std::all_of(drift.begin(), drift.end(), [](double d) { return d == 0; }))
    return;
  // The gate has to include the far side of the part, because the plane is still that
  // of the larger part.
  std::vector<KnownPlane> wide = known.planes;
  for (std::size_t p = 0; p < wide.size(); ++p)
    wide[p].warp = std::hypot(wide[p].warp, drift[p]);
  fitPlanes(
      sumPlanes(survey, labels, scenery.grid, scenery.noise, wide), guesses, wide);
  for (std::size_t p = 0; p < wide.size(); ++p) {
    if (drift[p] == 0)
      continue;
    wide[p].warp = std::hypot(known.planes[p].warp, drift[p] / 2);
    known.planes[p] = wide[p];
  }
}

/** Labels and fits in several rounds, then removes and merges planes; updates the grid
 * and the guesses. */
void
settle(const LabelingLimits& limits,
       const Progress& progress,
       Scenery& scenery,
       std::vector<Eigen::Vector3d>& guesses,
       KnownPlanes& known,
       PlaneClusteringReport& report)
{
  const auto& [grid, all, noise] = scenery;
  constexpr std::size_t max_of_a_voxel = 24;
  const Survey survey = all.thinned(max_of_a_voxel, grid);
  const Junctions junctions(known, grid);
  std::vector<std::int32_t> labels;
  std::vector<PlaneSums> sums;
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    progress.tell(0.4 + 0.2 * round, "labels");
    labels = RayLabels(grid, noise, junctions, known.planes).chooseAll(survey);
    sums = sumPlanes(survey, labels, grid, noise, known.planes);
    fitPlanes(sums, guesses, known.planes);
  }
  const Verdicts verdicts =
      judge(sums,
            ViewSteps(survey, labels, grid, noise, known.planes),
            findShadows(survey, labels, grid, noise, known.planes),
            known.planes,
            limits.distance,
            limits.cosine);
  report.merged += verdicts.merged;
  report.refuted_regions = verdicts.refuted;
  const std::vector<std::int32_t> numbers =
      sift(verdicts, limits.min_area, known, report);
  std::vector<Eigen::Vector3d> left(known.planes.size());
  for (std::size_t p = 0; p < numbers.size(); ++p)
    if (verdicts.kept_as[p] == static_cast<std::int32_t>(p) && numbers[p] >= 0)
      left[static_cast<std::size_t>(numbers[p])] = guesses[p];
  guesses = std::move(left);
  scenery.grid.renumber(numbers);
  for (std::int32_t& label : labels)
    label = label < 0 ? -1 : numbers[static_cast<std::size_t>(label)];
  settleDrift(verdicts, numbers, survey, labels, scenery, guesses, known);
}

void
finish(const Scenery& scenery,
       const std::vector<std::int32_t>& labels,
       const std::vector<Eigen::Vector3d>& guesses,
       int coarseness,
       KnownPlanes& known)
{
  const auto& [grid, survey, noise] = scenery;
  std::vector<PlaneSums> sums = sumPlanes(survey, labels, grid, noise, known.planes);
  centerFrames(sums, known.planes); // parts may have been merged since the last fit
  sumClusters(survey, labels, grid, noise, known.planes, coarseness, sums);
  finishPlanes(sums, guesses, known.planes);
}

} // namespace
} // namespace labeling

std::vector<std::int32_t>
labelPoints(const PointView& points,
            const SensorView& sensors,
            const LabelingLimits& limits,
            const Progress& progress,
            KnownPlanes& known,
            PlaneClusteringReport& report)
{
  using namespace labeling;
  if (known.planes.empty())
    return std::vector<std::int32_t>(points.size(), -1);
  StepTimer timer(report);
  std::vector<Eigen::Vector3d> guesses = normalsOf(known.planes);
  Scenery scenery(points, sensors, known);
  timer.finish("survey");
  settle(limits, progress, scenery, guesses, known, report);
  timer.finish("labels");
  progress.tell(0.8, "fits");
  const Junctions junctions(known, scenery.grid);
  std::vector<std::int32_t> labels =
      RayLabels(scenery.grid, scenery.noise, junctions, known.planes)
          .chooseAll(scenery.survey);
  finish(scenery, labels, guesses, limits.coarseness, known);
  gatherStragglers(limits.stray, scenery.grid, known);
  timer.finish("fits");
  return labels;
}

void
fitLabeled(const PointView& points,
           const SensorView& sensors,
           const LabelingLimits& limits,
           KnownPlanes& known)
{
  using namespace labeling;
  if (known.planes.empty())
    return;
  const Scenery scenery(points, sensors, known);
  finish(scenery, known.labels, normalsOf(known.planes), limits.coarseness, known);
  gatherStragglers(limits.stray, scenery.grid, known);
}

} // namespace pcl::acmap
