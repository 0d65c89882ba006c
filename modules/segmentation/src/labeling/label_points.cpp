#include "labeling/label_points.h"

#include "labeling/candidate_grid.h"
#include "labeling/plane_sums.h"
#include "labeling/ray_labels.h"
#include "labeling/verdicts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::acmap {

namespace labeling {
namespace {

/** Assigns hypotheses without a plane to the nearest plane within a distance. Such
 * hypotheses are often at creases, where normals are mixed.
 * \param[in] distance metres */
void
gatherStragglers(double distance, const CandidateGrid& grid, KnownPlanes& known)
{
  for (std::size_t i = 0; i < known.labels.size(); ++i) {
    VoxelHit hit;
    const Eigen::Vector3f point = known.points[i];
    if (known.labels[i] >= 0 || !grid.lattice().locate(point, hit))
      continue;
    const std::int32_t entry = grid.find(voxelKey(hit.place));
    double minimum = distance;
    for (std::size_t k = 0; entry >= 0 && k < grid[entry].size; ++k) {
      const std::int32_t plane = grid[entry].planes[k];
      const Eigen::Vector4d& its =
          known.planes[static_cast<std::size_t>(plane)].patch.coefficients;
      const double off = std::abs(its.head<3>().dot(point.cast<double>()) + its[3]);
      if (off < minimum) {
        minimum = off;
        known.labels[i] = plane;
      }
    }
  }
}

constexpr double guess_weight = 1 / (0.0175 * 0.0175); // one degree, radians

/** Are there enough points for a fit? All of them may be outside of the gate. */
bool
canBeFitted(const PlaneSums& sums)
{
  constexpr std::size_t min_points = 3;
  return sums.points >= min_points && sums.best().matrix(2, 2) > 0;
}

/** Adds a guessed normal as a prior of the slopes. */
void
addGuess(const Eigen::Vector3d& guess, const PlanePatch& patch, FitSums& sums)
{
  const double along = guess.dot(patch.coefficients.head<3>());
  const Eigen::Vector2d slopes(-guess.dot(patch.axis_u) / along,
                               -guess.dot(patch.axis_v) / along);
  sums.matrix.topLeftCorner<2, 2>() += guess_weight * Eigen::Matrix2d::Identity();
  sums.right.head<2>() += guess_weight * slopes;
}

bool
needsGuess(const PlaneSums& sums, const KnownPlane& plane)
{
  constexpr double max_tilt =
      0.1; // radians; beyond it the points do not determine the tilt
  return plane.trust == PlaneTrust::Strip || !knowsTilt(sums.best(), max_tilt);
}

FitSums
withGuess(const PlaneSums& sums, const KnownPlane& plane, const Eigen::Vector3d& guess)
{
  FitSums fit = sums.best();
  if (needsGuess(sums, plane))
    addGuess(guess, plane.patch, fit);
  return fit;
}

/** Half sides of a rectangle with the variances of the points: a half side h has the
 * variance h^2 / 3. */
Eigen::Vector2d
halfSize(const FitSums& sums)
{
  const Eigen::Matrix3d mean = sums.matrix / sums.matrix(2, 2);
  const Eigen::Array2d variances =
      mean.diagonal().head<2>().array() - mean.col(2).head<2>().array().square();
  return (3 * variances.max(0.0)).sqrt();
}

/** Number of independent points that would determine the offset equally well; for
 * points without noise it is their number. */
double
effectiveSupport(const PlanePatch& patch, double count)
{
  const double square = patch.rms * patch.rms;
  const double variance = patch.covariance(2, 2);
  return count * variance <= square ? count : square / variance;
}

/** Fits each plane to its points and updates its frame. Strips, and planes whose points
 * are on one line, keep their guessed tilt unless the points determine it better. */
void
fitPlanes(const std::vector<PlaneSums>& sums,
          const std::vector<Eigen::Vector3d>& guesses,
          std::vector<KnownPlane>& planes)
{
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!canBeFitted(sums[p]))
      continue;
    const FitSums fit = withGuess(sums[p], planes[p], guesses[p]);
    moveToFit(fit, planes[p].patch);
    setFrame(sums[p].best(), planes[p].patch);
  }
}

/** Moves the frame of each plane to its points and transforms the sums accordingly. */
void
centerFrames(std::vector<PlaneSums>& sums, std::vector<KnownPlane>& planes)
{
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!canBeFitted(sums[p]))
      continue;
    const PlanePatch before = planes[p].patch;
    setFrame(sums[p].best(), planes[p].patch);
    for (FitSums* fit : {&sums[p].fit, &sums[p].clean})
      *fit = movedSums(*fit, before, planes[p].patch);
  }
}

/** Same as \ref fitPlanes, but sets support, rms and covariance instead of the
 * frames. */
void
finishPlanes(const std::vector<PlaneSums>& sums,
             const std::vector<Eigen::Vector3d>& guesses,
             std::vector<KnownPlane>& planes)
{
  for (std::size_t p = 0; p < planes.size(); ++p) {
    PlanePatch& patch = planes[p].patch;
    patch.support = sums[p].points;
    patch.covariance.setConstant(std::nan(""));
    if (!canBeFitted(sums[p]))
      continue;
    const FitSums fit = withGuess(sums[p], planes[p], guesses[p]);
    const double guess = needsGuess(sums[p], planes[p]) ? guess_weight : 0;
    const double count = static_cast<double>(sums[p].points);
    planes[p].half_size = halfSize(sums[p].fit);
    const Eigen::Vector3d solution = moveToFit(fit, patch);
    patch.covariance = clusteredCovariance(fit, guess, solution, sums[p].clusters);
    patch.rms = std::sqrt(sums[p].squares / count);
    patch.effective_support = effectiveSupport(patch, count);
  }
}

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
  , noise(survey, grid, known.planes, known.max_sigma)
  {
    measureWarps(survey, grid, noise, known.max_warp, known.planes);
  }
};

/** Fits those planes again whose parts were separated by pose errors, and increases
 * their warp accordingly.
 * \param[in] labels with the new numbers */
void
settleDrift(const Verdicts& verdicts,
            const std::vector<std::int32_t>& numbers,
            const Survey& survey,
            PointLabels labels,
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
  for (std::int32_t& label : labels) // the other planes are not fitted
    if (label >= 0 && drift[static_cast<std::size_t>(label)] == 0)
      label = -1;
  const PlaneMembers members(labels.data(), labels.size(), wide.size());
  fitPlanes(
      sumPlanes(survey, members, scenery.grid, scenery.noise, wide), guesses, wide);
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
  PointLabels labels;
  std::optional<PlaneMembers> members;
  std::vector<PlaneSums> sums;
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    progress.tell(0.4 + 0.2 * round, "labels");
    labels = RayLabels(grid, noise, junctions, known.planes).chooseAll(survey);
    members.emplace(labels.data(), labels.size(), known.planes.size());
    sums = sumPlanes(survey, *members, grid, noise, known.planes);
    fitPlanes(sums, guesses, known.planes);
  }
  countAtHome(survey, grid, sums);
  const Verdicts verdicts =
      judge(sums,
            ViewSteps(survey, labels, grid, noise, known.planes),
            findShadows(survey, *members, grid, noise, known.planes),
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
  settleDrift(verdicts, numbers, survey, std::move(labels), scenery, guesses, known);
}

void
finish(const Scenery& scenery,
       const PlaneMembers& members,
       const std::vector<Eigen::Vector3d>& guesses,
       int coarseness,
       KnownPlanes& known)
{
  const auto& [grid, survey, noise] = scenery;
  std::vector<PlaneSums> sums = sumPlanes(survey, members, grid, noise, known.planes);
  centerFrames(sums, known.planes); // parts may have been merged since the last fit
  sumClusters(survey, members, grid, noise, known.planes, coarseness, sums);
  finishPlanes(sums, guesses, known.planes);
}

} // namespace
} // namespace labeling

PointLabels
labelPoints(const PointView& points,
            const SensorView& sensors,
            const LabelingLimits& limits,
            const Progress& progress,
            KnownPlanes& known,
            PlaneClusteringReport& report)
{
  using namespace labeling;
  if (known.planes.empty())
    return PointLabels(points.size(), -1);
  StepTimer timer(report);
  std::vector<Eigen::Vector3d> guesses = normalsOf(known.planes);
  Scenery scenery(points, sensors, known);
  timer.finish("survey");
  settle(limits, progress, scenery, guesses, known, report);
  timer.finish("labels");
  progress.tell(0.8, "fits");
  const Junctions junctions(known, scenery.grid);
  PointLabels labels = RayLabels(scenery.grid, scenery.noise, junctions, known.planes)
                           .chooseAll(scenery.survey);
  finish(scenery,
         PlaneMembers(labels.data(), labels.size(), known.planes.size()),
         guesses,
         limits.coarseness,
         known);
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
  finish(scenery,
         PlaneMembers(known.labels.data(), known.labels.size(), known.planes.size()),
         normalsOf(known.planes),
         limits.coarseness,
         known);
  gatherStragglers(limits.stray, scenery.grid, known);
}

} // namespace pcl::acmap
