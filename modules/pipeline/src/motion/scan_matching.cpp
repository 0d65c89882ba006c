#include "motion/scan_matching.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/rotation_vector.h>
#include <pcl/core/impl/voxel_windows.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_set>

namespace pcl::acmap {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/** Points of the source that are compared, for starts, for their refinement, at the end. */
constexpr std::size_t few = 200, some = 500, many = 1500;

/** Distances within which a point belongs to a surface, metres. */
constexpr double coarse_gate = 0.5, fine_gate = 0.1;

/** A point of the source and the surface of the target that is nearest. */
struct Pair {
  Vector3d point;  ///< frame of the target
  Vector3d normal; ///< of the target
  double distance; ///< metres, signed
};

/** The pair of a point under a motion: with the nearest surface of a similar normal. Rings of a
 * scanner are far apart and move with it, so that the nearest point tells nothing along a surface:
 * a limit as narrow as the gate would find that the sensor stood still. */
std::optional<Pair>
pairOf(const ScanSurface& source,
       const ScanSurface& target,
       const Isometry3d& motion,
       std::size_t i,
       Indices& found)
{
  constexpr double min_cosine = 0.7, beside = 1; // 45 degrees, metres
  constexpr std::size_t neighbours = 8;
  const Vector3d point = motion * source.points[i].cast<double>();
  const Vector3d facing = motion.linear() * source.normals[i].cast<double>();
  target.tree.find(point.cast<float>(), neighbours, found);
  for (const auto index : found) {
    const auto nearest = static_cast<std::size_t>(index);
    const Vector3d normal = target.normals[nearest].cast<double>();
    const Vector3d way = point - target.points[nearest].cast<double>();
    if (way.squaredNorm() > beside * beside)
      break;
    if (normal.dot(facing) > min_cosine)
      return Pair{point, normal, normal.dot(way)};
  }
  return std::nullopt;
}

/** Every so many points are compared. */
std::size_t
stepOf(const ScanSurface& source, std::size_t count)
{
  return std::max<std::size_t>(1, source.size() / count);
}

/** Calls a function with each pair of every so many points.
 * \return number of points */
template <typename Function>
std::size_t
forPairs(const ScanSurface& source,
         const ScanSurface& target,
         const Isometry3d& motion,
         std::size_t count,
         const Function& function)
{
  const std::size_t step = stepOf(source, count);
  Indices found;
  std::size_t all = 0;
  for (std::size_t i = 0; i < source.size(); i += step, ++all)
    if (const auto pair = pairOf(source, target, motion, i, found))
      function(*pair);
  return all;
}

/** Share of the points that a motion explains, from 0 to 1; nearer ones count more. */
double
agreement(const ScanSurface& source,
          const ScanSurface& target,
          const Isometry3d& motion,
          double gate,
          std::size_t count)
{
  double sum = 0;
  const std::size_t all =
      forPairs(source, target, motion, count, [&](const Pair& pair) {
        sum += std::max(0.0, 1 - std::pow(pair.distance / gate, 2));
      });
  return all > 0 ? sum / static_cast<double>(all) : 0;
}

/** Normal equations of a small motion of the source: translation, rotation. */
struct Equations {
  Matrix6d matrix = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  double squares = 0, weights = 0;
  std::size_t pairs = 0;
};

Equations
equationsAt(const ScanSurface& source,
            const ScanSurface& target,
            const Isometry3d& motion,
            double gate,
            std::size_t count)
{
  Equations sums;
  forPairs(source, target, motion, count, [&](const Pair& pair) {
    const double rest = 1 - std::pow(pair.distance / gate, 2);
    if (rest <= 0)
      return;
    const double weight = rest * rest; // Tukey's
    Vector6d row;
    row << pair.normal, (pair.point - motion.translation()).cross(pair.normal);
    sums.matrix += weight * row * row.transpose();
    sums.right -= weight * pair.distance * row;
    sums.squares += weight * pair.distance * pair.distance;
    sums.weights += weight;
    ++sums.pairs;
  });
  return sums;
}

Isometry3d
movedBy(const Isometry3d& motion, const Vector6d& step)
{
  Isometry3d result = motion;
  result.linear() = rotationOf(step.tail<3>()).toRotationMatrix() * motion.linear();
  result.translation() += step.head<3>();
  return result;
}

/** Descends until the steps are small. What no surface determines stays nearly as it is. */
Isometry3d
descended(const ScanSurface& source,
          const ScanSurface& target,
          Isometry3d motion,
          double gate,
          std::size_t count,
          int max_steps)
{
  constexpr double settled = 1e-4; // metres, radians
  constexpr double damping = 1e-3;
  for (int i = 0; i < max_steps; ++i) {
    Equations sums = equationsAt(source, target, motion, gate, count);
    if (sums.pairs < 6)
      break;
    sums.matrix.diagonal().array() += damping * sums.weights;
    const Vector6d step = sums.matrix.ldlt().solve(sums.right);
    if (!step.allFinite())
      break;
    motion = movedBy(motion, step);
    if (step.norm() < settled)
      break;
  }
  return motion;
}

/** Motions from which the search begins: the guess, and a lattice in the plane along which the
 * target extends most. */
std::vector<Isometry3d>
startsOf(const ScanSurface& target, const Isometry3d& guess, const ScanReach& reach)
{
  constexpr double apart = 0.5, turn = 20 * M_PI / 180; // metres, radians
  Moments moments;
  for (const Eigen::Vector3f& point : target.points)
    moments += momentsOf(point.cast<double>());
  const PlaneFit level = fitPlane(moments);
  const Vector3d u = level.long_axis, v = level.normal.cross(u);
  const auto rings = static_cast<int>(reach.translation / apart);
  const auto turns = static_cast<int>(reach.rotation / turn);
  std::vector<Isometry3d> starts{guess};
  for (int a = -rings; a <= rings; ++a)
    for (int b = -rings; b <= rings; ++b) {
      if (a * a + b * b > rings * rings)
        continue;
      for (int k = -turns; k <= turns; ++k) {
        Isometry3d start(Eigen::AngleAxisd(k * turn, level.normal));
        start.translation() = apart * (a * u + b * v);
        starts.push_back(start);
      }
    }
  return starts;
}

struct Candidate {
  Isometry3d motion;
  double agreement;
};

bool
isNear(const Isometry3d& a, const Isometry3d& b)
{
  constexpr double far = 0.2, turned = 5 * M_PI / 180; // metres, radians
  return (a.translation() - b.translation()).norm() < far &&
         Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() < turned;
}

/** The best of some candidates, without those that are near a better one; best first. */
std::vector<Candidate>
bestOf(std::vector<Candidate> candidates, std::size_t count)
{
  std::stable_sort(
      candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.agreement > b.agreement;
      });
  std::vector<Candidate> best;
  for (const Candidate& candidate : candidates)
    if (best.size() < count &&
        std::none_of(best.begin(), best.end(), [&](const Candidate& other) {
          return isNear(candidate.motion, other.motion);
        }))
      best.push_back(candidate);
  return best;
}

/** Replaces each motion by what a function makes of it. */
template <typename Function>
std::vector<Candidate>
judged(std::vector<Candidate> candidates, const Function& function)
{
  oneapi::tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    candidates[i] = function(candidates[i].motion);
    pollRun();
  });
  return candidates;
}

/** The motions that explain the scans, best first. */
std::vector<Candidate>
searched(const ScanSurface& source,
         const ScanSurface& target,
         const Isometry3d& guess,
         const ScanReach& reach)
{
  constexpr std::size_t refined = 12, finished = 4;
  std::vector<Candidate> candidates;
  for (const Isometry3d& start : startsOf(target, guess, reach))
    candidates.push_back({start, 0});
  candidates = judged(std::move(candidates), [&](const Isometry3d& start) {
    return Candidate{start, agreement(source, target, start, coarse_gate, few)};
  });
  candidates = judged(bestOf(std::move(candidates), refined), [&](Isometry3d motion) {
    constexpr double middle_gate = 0.25;
    motion = descended(source, target, motion, coarse_gate, some, 8);
    motion = descended(source, target, motion, middle_gate, some, 8);
    return Candidate{motion, agreement(source, target, motion, middle_gate, some)};
  });
  return bestOf(
      judged(bestOf(std::move(candidates), finished),
             [&](Isometry3d motion) {
               motion = descended(source, target, motion, 2 * fine_gate, some, 8);
               motion = descended(source, target, motion, fine_gate, many, 10);
               return Candidate{motion,
                                agreement(source, target, motion, fine_gate, many)};
             }),
      finished);
}

bool
isWithin(const ScanReach& reach, const Isometry3d& motion)
{
  return motion.translation().norm() <= reach.translation &&
         Eigen::AngleAxisd(motion.linear()).angle() <= reach.rotation;
}

/** A point of each cube of 5 cm, so that rows of a scanner are not much denser than its columns. */
std::vector<Eigen::Vector3f>
thinned(const PointView& scan)
{
  constexpr double edge = 0.05;
  const VoxelLattice lattice(scan, edge);
  std::unordered_set<VoxelKey> taken;
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    VoxelHit hit;
    if (lattice.locate(scan[i], hit) && taken.insert(voxelKey(hit.place)).second)
      points.push_back(scan[i]);
  }
  return points;
}

/** The normal towards the sensor of the plane of a point's neighbours; zero if these are on no
 * plane, or on a line. */
Vector3d
normalAt(const std::vector<Eigen::Vector3f>& points,
         const NearestPoints& tree,
         std::size_t i)
{
  constexpr std::size_t neighbours = 20, least = 8;
  constexpr double max_distance = 0.5;      // metres
  constexpr double flat = 0.1, wide = 0.02; // variances, of that along the longest axis
  Indices found;
  tree.find(points[i], neighbours, found);
  Moments moments;
  const Vector3d place = points[i].cast<double>();
  for (const auto index : found) {
    const Vector3d way = points[static_cast<std::size_t>(index)].cast<double>() - place;
    if (way.squaredNorm() < max_distance * max_distance)
      moments += momentsOf(way);
  }
  if (moments.count < least)
    return Vector3d::Zero();
  const PlaneFit plane = fitPlane(moments);
  if (plane.variances[0] > flat * plane.variances[1] ||
      plane.variances[1] < wide * plane.variances[2])
    return Vector3d::Zero();
  return plane.normal.dot(place) > 0 ? -plane.normal : plane.normal;
}

std::optional<EgomotionEstimate>
failed(EgomotionOutcome outcome, const std::string& reason, EgomotionReport& report)
{
  report.outcome = outcome;
  report.reason = reason;
  return std::nullopt;
}

} // namespace

ScanSurface::ScanSurface(const PointView& scan)
: points()
, normals()
, tree([&] {
  const std::vector<Eigen::Vector3f> all = thinned(scan);
  const NearestPoints neighbours(all);
  std::vector<Vector3d> found(all.size());
  parallelForChunks(all.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      found[i] = normalAt(all, neighbours, i);
  });
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!found[i].isZero()) {
      points.push_back(all[i]);
      normals.emplace_back(found[i].cast<float>());
    }
  return NearestPoints(points);
}())
{}

std::optional<EgomotionEstimate>
matchScans(const ScanSurface& source,
           const ScanSurface& target,
           const Isometry3d& guess,
           const ScanReach& reach,
           EgomotionReport& report)
{
  constexpr std::size_t least = 100;    // points
  constexpr double min_agreement = 0.3; // of the points
  constexpr double sure = 4; // independent points that prefer the best motion
  constexpr double max_deviation = 0.1, max_turn = 3 * M_PI / 180; // metres, radians
  constexpr double of_neighbours = 10; // points whose residuals are alike
  report = {};
  report.source_points = source.size();
  report.target_points = target.size();
  if (source.size() < least || target.size() < least)
    return failed(EgomotionOutcome::BlankView,
                  source.size() < least ? "the source has hardly any surface"
                                        : "the target has hardly any surface",
                  report);
  std::vector<Candidate> found = searched(source, target, guess, reach);
  found.erase(std::remove_if(found.begin(),
                             found.end(),
                             [&](const Candidate& candidate) {
                               return !isWithin(reach, candidate.motion);
                             }),
              found.end());
  char text[160];
  if (found.empty() || found.front().agreement < min_agreement)
    return failed(EgomotionOutcome::Inconsistent,
                  "no motion within the reach lays the surfaces onto each other",
                  report);
  const Candidate& best = found.front();
  const auto points =
      static_cast<double>(source.size() / stepOf(source, many)) / of_neighbours;
  if (found.size() > 1 && points * (best.agreement - found[1].agreement) < sure) {
    std::snprintf(text,
                  sizeof text,
                  "two motions, %.2g m apart, lay the surfaces onto each other equally "
                  "well",
                  (best.motion.translation() - found[1].motion.translation()).norm());
    return failed(EgomotionOutcome::Inconsistent, text, report);
  }
  const Equations sums = equationsAt(source, target, best.motion, fine_gate, many);
  report.surface_pairs = sums.pairs;
  report.surface_after = std::sqrt(sums.squares / sums.weights);
  report.contradicted = 1 - best.agreement;
  const Matrix6d covariance = of_neighbours * sums.squares / sums.weights *
                              sums.matrix.ldlt().solve(Matrix6d::Identity());
  const auto largest = [](const Eigen::Matrix3d& block) {
    return std::sqrt(
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(block).eigenvalues()[2]);
  };
  const double deviation = largest(covariance.topLeftCorner<3, 3>());
  const double turn = largest(covariance.bottomRightCorner<3, 3>());
  if (!(deviation < max_deviation) || !(turn < max_turn)) {
    std::snprintf(text,
                  sizeof text,
                  "the surfaces do not determine the motion: %.2g m, %.2g degrees are "
                  "uncertain",
                  deviation,
                  turn * 180 / M_PI);
    return failed(EgomotionOutcome::Unobservable, text, report);
  }
  report.outcome = EgomotionOutcome::Estimated;
  EgomotionEstimate estimate;
  estimate.T_target_source = best.motion;
  estimate.action = actionBetween({}, planarPartOf(best.motion));
  estimate.covariance = covariance;
  return estimate;
}

} // namespace pcl::acmap
