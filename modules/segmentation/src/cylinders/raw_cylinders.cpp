#include "cylinders/raw_cylinders.h"

#include "median.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/voxel_windows.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::acmap::cylinders {
namespace {

using Members = std::vector<std::int32_t>;

std::vector<Sample>
samplesOf(const RawCloud& cloud, const Members& members)
{
  std::vector<Sample> samples;
  samples.reserve(members.size());
  for (const std::int32_t member : members) {
    const auto m = static_cast<std::size_t>(member);
    const Eigen::Vector3f point = cloud.points[m];
    Sample sample{point.cast<double>()};
    if (const Eigen::Vector3f* const sensor = cloud.sensors[m])
      sample.ray = (sample.point - sensor->cast<double>()).stableNormalized();
    samples.push_back(sample);
  }
  return samples;
}

/** At most about \a maximum of some members, evenly chosen. */
Members
thinned(const Members& members, std::size_t maximum)
{
  const std::size_t step = members.size() / maximum + 1;
  Members chosen;
  for (std::size_t i = 0; i < members.size(); i += step)
    chosen.push_back(members[i]);
  return chosen;
}

/** Does the surface of a plane's points bend by more than their noise and than walls
 * do? The height of a parabola is fitted to their offsets along both axes. */
bool
isBent(const RawCloud& cloud, const PlanePatch& patch, const Members& members)
{
  using Terms = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  constexpr std::size_t min_points = 60;
  if (members.size() < min_points)
    return false;
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  Matrix matrix = Matrix::Zero();
  Terms right = Terms::Zero();
  Eigen::Vector2d spread = Eigen::Vector2d::Zero();
  double squares = 0, count = 0;
  for (const Sample& sample : samplesOf(cloud, members)) {
    const double slant = sample.hasRay() ? std::abs(sample.ray.dot(normal)) : 1;
    if (slant < min_slant)
      continue;
    double off = normal.dot(sample.point) + patch.coefficients[3];
    Eigen::Vector3d foot = sample.point - off * normal;
    if (sample.hasRay())
      foot = sample.point - off / sample.ray.dot(normal) * sample.ray;
    off /= slant; // all have the same noise along their rays
    const double a = (foot - patch.center).dot(patch.axis_u);
    const double b = (foot - patch.center).dot(patch.axis_v);
    Terms terms;
    terms << 1, a, b, a * a, a * b, b * b;
    terms /= slant;
    matrix += terms * terms.transpose();
    right += off * terms;
    squares += off * off;
    spread += Eigen::Vector2d(a * a, b * b);
    count += 1;
  }
  if (count < min_points)
    return false;
  const Eigen::LDLT<Matrix> solver(matrix);
  const Terms fit = solver.solve(right);
  const double variance =
      std::max(squares - fit.dot(right), 0.0) / (count - 6);
  const Matrix covariance = variance * solver.solve(Matrix(Matrix::Identity()));
  constexpr double deviations = 5, min_sagitta = 0.006; // of the width
  for (const int axis : {0, 1}) {
    const int term = axis == 0 ? 3 : 5;
    const double width = std::sqrt(12 * spread[axis] / count);
    const double sagitta = std::abs(fit[term]) * width * width / 4;
    if (std::abs(fit[term]) > deviations * std::sqrt(covariance(term, term)) &&
        sagitta > min_sagitta * width)
      return true;
  }
  return false;
}

/** Connected cells of some points: clusters with the members of each. */
std::vector<Members>
clustersOf(const RawCloud& cloud, const Members& pool, double edge)
{
  constexpr std::size_t min_in_cell = 3, min_points = 60;
  const VoxelLattice lattice(cloud.points, edge);
  std::map<VoxelKey, Members> cells;
  for (const std::int32_t member : pool) {
    VoxelHit hit;
    if (lattice.locate(cloud.points[static_cast<std::size_t>(member)], hit))
      cells[voxelKey(hit.place)].push_back(member);
  }
  std::map<VoxelKey, bool> is_visited;
  std::vector<Members> clusters;
  for (const auto& [key, members] : cells) {
    if (members.size() < min_in_cell || is_visited[key])
      continue;
    std::vector<VoxelKey> queue{key};
    is_visited[key] = true;
    Members cluster;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Members& own = cells[queue[next]];
      cluster.insert(cluster.end(), own.begin(), own.end());
      const VoxelPlace place = placeOf(queue[next]);
      for (int step = 0; step < 27; ++step) {
        const VoxelKey other = voxelKey({place[0] + step / 9 - 1,
                                         place[1] + step / 3 % 3 - 1,
                                         place[2] + step % 3 - 1});
        const auto found = cells.find(other);
        if (found == cells.end() || found->second.size() < min_in_cell ||
            is_visited[other])
          continue;
        is_visited[other] = true;
        queue.push_back(other);
      }
    }
    std::sort(cluster.begin(), cluster.end());
    if (cluster.size() >= min_points)
      clusters.push_back(std::move(cluster));
  }
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
    return a.size() > b.size();
  });
  return clusters;
}

/** Directions without those that are nearly parallel to earlier ones. */
class Directions {
public:
  void
  add(const Eigen::Vector3d& direction)
  {
    constexpr double parallel = 0.996; // 5 degrees
    const double length = direction.norm();
    if (!(length > 0.1))
      return;
    for (const Eigen::Vector3d& other : directions_)
      if (std::abs(other.dot(direction)) > parallel * length)
        return;
    directions_.emplace_back(direction / length);
  }

  const std::vector<Eigen::Vector3d>&
  all() const
  {
    return directions_;
  }

private:
  std::vector<Eigen::Vector3d> directions_;
};

class RawSearch {
public:
  RawSearch(const RawCloud& cloud, const CylinderLimits& limits)
  : cloud_(cloud)
  , limits_(limits)
  , is_free_(cloud.points.size(), 0)
  , plane_members_(cloud.planes.size())
  {
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      const std::int32_t label = cloud.labels[i];
      if (label >= 0)
        plane_members_[static_cast<std::size_t>(label)].push_back(
            static_cast<std::int32_t>(i));
      else
        is_free_[i] = cloud.points[i].allFinite() ? 1 : 0;
    }
    for (std::size_t p = 0; p < cloud.planes.size(); ++p) {
      directions_.add(cloud.planes[p].coefficients.head<3>());
      if (isBent(cloud, cloud.planes[p], thinned(plane_members_[p], 20000)))
        for (const std::int32_t member : plane_members_[p])
          is_free_[static_cast<std::size_t>(member)] = 1;
    }
    const std::vector<Eigen::Vector3d> normals = directions_.all();
    for (std::size_t a = 0; a < normals.size(); ++a)
      for (std::size_t b = a + 1; b < normals.size(); ++b)
        directions_.add(normals[a].cross(normals[b]));
  }

  std::vector<RawCylinder>
  run(const Progress& progress)
  {
    constexpr int rounds = 4;
    const double edge = std::max(2.5 * cloud_.spacing, 2 * cloud_.sigma);
    for (int round = 0; round < rounds; ++round) {
      progress.tell(0.4 + 0.15 * round, "cylinders");
      Members pool;
      for (std::size_t i = 0; i < is_free_.size(); ++i)
        if (is_free_[i])
          pool.push_back(static_cast<std::int32_t>(i));
      bool has_found = false;
      for (const Members& cluster : clustersOf(cloud_, pool, edge))
        has_found |= searchCluster(cluster, pool);
      if (!has_found)
        break;
    }
    return std::move(found_);
  }

private:
  bool
  searchCluster(const Members& cluster, const Members& pool);
  std::optional<CylinderFit>
  bestFit(const std::vector<Sample>& samples) const;
  Directions
  axesOf(const std::vector<Sample>& samples) const;
  bool
  gather(const Members& pool, RawCylinder& cylinder) const;
  bool
  isCylinder(const RawCylinder& cylinder) const;
  bool
  isShorter(RawCylinder& cylinder) const;
  bool
  isLookedThrough(const CylinderFit& fit, const CylinderReach& reach) const;

  const RawCloud& cloud_;
  CylinderLimits limits_;
  std::vector<std::uint8_t> is_free_;
  std::vector<Members> plane_members_;
  Directions directions_; ///< of planes and of their edges
  std::vector<RawCylinder> found_;
};

Directions
RawSearch::axesOf(const std::vector<Sample>& samples) const
{
  Directions axes;
  Moments moments;
  const Eigen::Vector3d middle = samples[samples.size() / 2].point;
  for (const Sample& sample : samples)
    moments += momentsOf(sample.point - middle);
  const PlaneFit plane = fitPlane(moments);
  axes.add(plane.long_axis);
  for (const Eigen::Vector3d& direction : directions_.all())
    axes.add(direction);
  axes.add(plane.normal.cross(plane.long_axis));
  return axes;
}

/** The best of the fits that start at the axes that may be. */
std::optional<CylinderFit>
RawSearch::bestFit(const std::vector<Sample>& samples) const
{
  std::optional<CylinderFit> best;
  double best_score = 0;
  for (const Eigen::Vector3d& axis : axesOf(samples).all()) {
    std::optional<Cylinder> start = cylinderOfCircle(samples, axis);
    if (!start || start->radius > 100 * limits_.max_radius)
      continue;
    double facing = 0;
    for (const Sample& sample : samples)
      facing += start->across(sample.point).dot(sample.ray);
    start->is_hollow = facing > 0;
    std::vector<double> offs;
    for (const Sample& sample : samples)
      offs.push_back(std::abs(start->distance(sample.point)));
    const double rough = 1.5 * medianOf(offs);
    std::optional<CylinderFit> fit;
    for (double sigma = std::max(rough, cloud_.sigma);; sigma = std::max(sigma / 2, cloud_.sigma)) {
      fit = fitCylinder(samples, fit ? fit->cylinder : *start, sigma);
      if (!fit || sigma <= cloud_.sigma)
        break;
    }
    if (!fit)
      continue;
    const double score =
        static_cast<double>(fit->count) *
        (1 - std::pow(fit->rms / (4 * cloud_.sigma), 2)); // rewards samples on it
    if (best && score <= best_score)
      continue;
    best = fit;
    best_score = score;
  }
  return best;
}

/** Gathers all free points on the cylinder beside those that were found, and fits
 * again: a selection by rays does not shift the fit. */
bool
RawSearch::gather(const Members& pool, RawCylinder& cylinder) const
{
  constexpr int rounds = 3;
  constexpr double gate = 4;
  for (int round = 0; round < rounds; ++round) {
    const CylinderReach reach =
        reachOf(cylinder.fit.cylinder, cylinder.samples, 2 * cloud_.spacing);
    const double slack = 2 * cloud_.spacing;
    Members members;
    const std::vector<Sample> all = samplesOf(cloud_, pool);
    for (std::size_t i = 0; i < pool.size(); ++i) {
      const Offset offset(cylinder.fit.cylinder, all[i]);
      if (!offset.exists || std::abs(offset.value) > gate * cloud_.sigma)
        continue;
      const double along = cylinder.fit.cylinder.along(offset.foot);
      if (along > reach.low - slack && along < reach.high + slack)
        members.push_back(pool[i]);
    }
    cylinder.samples = samplesOf(cloud_, members);
    cylinder.members = std::move(members);
    const auto fit =
        fitCylinder(cylinder.samples, cylinder.fit.cylinder, cloud_.sigma);
    if (!fit)
      return false;
    cylinder.fit = *fit;
  }
  return true;
}

bool
RawSearch::searchCluster(const Members& cluster, const Members& pool)
{
  constexpr std::size_t max_samples = 3000;
  RawCylinder cylinder;
  cylinder.samples = samplesOf(cloud_, thinned(cluster, max_samples));
  const std::optional<CylinderFit> fit = bestFit(cylinder.samples);
  if (!fit)
    return false;
  cylinder.fit = *fit;
  Members still_free;
  for (const std::int32_t member : pool)
    if (is_free_[static_cast<std::size_t>(member)])
      still_free.push_back(member);
  if (!gather(still_free, cylinder))
    return false;
  setCovariance(cylinder.samples, cloud_.sigma, 2 * cloud_.spacing, cylinder.fit);
  if (!isCylinder(cylinder) || !isShorter(cylinder))
    return false;
  for (const std::int32_t member : cylinder.members)
    is_free_[static_cast<std::size_t>(member)] = 0;
  found_.push_back(std::move(cylinder));
  return true;
}

/** Do rays pass through the cylinder where it should stop them? */
bool
RawSearch::isLookedThrough(const CylinderFit& fit, const CylinderReach& reach) const
{
  constexpr double min_cosine = 0.4, max_share = 0.15, sigmas = 5;
  std::size_t through = 0, on = 0;
  Members all(cloud_.points.size());
  std::iota(all.begin(), all.end(), 0);
  for (const Sample& sample : samplesOf(cloud_, all)) {
    if (!sample.hasRay() || !sample.point.allFinite())
      continue;
    const Offset offset(fit.cylinder, sample);
    if (!offset.exists || std::abs(offset.slant) < min_cosine)
      continue;
    const double along = fit.cylinder.along(offset.foot);
    if (along < reach.low || along > reach.high)
      continue;
    through += offset.value > sigmas * cloud_.sigma ? 1 : 0;
    on += std::abs(offset.value) <= sigmas * cloud_.sigma ? 1 : 0;
  }
  return static_cast<double>(through) >
         max_share * static_cast<double>(through + on);
}

bool
RawSearch::isCylinder(const RawCylinder& cylinder) const
{
  const double radius = cylinder.fit.cylinder.radius;
  if (radius < limits_.min_radius || radius > limits_.max_radius)
    return false;
  constexpr double min_arc = 0.38; // 22 degrees
  const CylinderReach reach =
      reachOf(cylinder.fit.cylinder, cylinder.samples, 2 * cloud_.spacing);
  if (reach.arc < min_arc || reach.sagitta < 0.012 * reach.chord)
    return false;
  constexpr double max_deviation = 0.1; // of the radius
  if (!(std::sqrt(cylinder.fit.covariance(4, 4)) < max_deviation * radius))
    return false;
  const double count = static_cast<double>(cylinder.members.size());
  constexpr double max_misfit = 0.2;
  return misfit(cylinder.samples, cylinder.fit, cloud_.sigma / 2) <=
             max_misfit + 18 / count &&
         (cylinder.fit.cylinder.is_hollow || !isLookedThrough(cylinder.fit, reach));
}

/** Are the points described in fewer bits than as free ones, with the planes that the
 * cylinder replaces, and than by one plane? */
bool
RawSearch::isShorter(RawCylinder& cylinder) const
{
  Moments moments;
  const Eigen::Vector3d middle = cylinder.fit.cylinder.point;
  for (const Sample& sample : cylinder.samples)
    moments += momentsOf(sample.point - middle);
  const PlaneFit plane = fitPlane(moments);
  const double extent = std::sqrt(12 * plane.variances.sum());
  const DescriptionLength lengths(cloud_.sigma, cloud_.spacing, extent);
  const double count = static_cast<double>(cylinder.members.size());
  double on_cylinder = lengths.cylinder(count), on_plane = lengths.plane(count);
  double before = 0;
  std::map<std::int32_t, std::size_t> taken;
  for (std::size_t i = 0; i < cylinder.samples.size(); ++i) {
    const Sample& sample = cylinder.samples[i];
    const Offset offset(cylinder.fit.cylinder, sample);
    const double cosine = sample.hasRay() ? sample.ray.dot(plane.normal) : 1;
    const double off = plane.normal.dot(sample.point - middle - plane.mean) /
                       std::max(std::abs(cosine), min_slant);
    on_cylinder += lengths.element(offset.value);
    on_plane += lengths.element(off);
    const std::int32_t label =
        cloud_.labels[static_cast<std::size_t>(cylinder.members[i])];
    if (label < 0) {
      before += lengths.freeElement();
      continue;
    }
    ++taken[label];
    const Eigen::Vector4d& its =
        cloud_.planes[static_cast<std::size_t>(label)].coefficients;
    before += lengths.element(its.head<3>().dot(sample.point) + its[3]);
  }
  for (const auto& [label, number] : taken) {
    const double all =
        static_cast<double>(plane_members_[static_cast<std::size_t>(label)].size());
    constexpr double min_share = 0.6;
    if (static_cast<double>(number) < min_share * all)
      continue;
    cylinder.planes.push_back(label);
    before += lengths.plane(all);
  }
  return on_cylinder < before && on_cylinder < on_plane;
}

} // namespace

std::vector<RawCylinder>
findRawCylinders(const RawCloud& cloud,
                 const CylinderLimits& limits,
                 const Progress& progress)
{
  return RawSearch(cloud, limits).run(progress);
}

} // namespace pcl::acmap::cylinders
