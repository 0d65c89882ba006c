#include "cylinders/raw_cylinders.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/voxel_windows.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace pcl::acmap::cylinders {
namespace {

using Members = std::vector<std::int32_t>;

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

/** Gathers the points on a cylinder within its reach, and fits again.
 * \param[in] all samples of the pool
 * \param[in] slack by how much they may be beyond the reach, metres
 * \param[in] most samples that are fitted to
 * \param[in,out] reach of the cylinder */
bool
gatherOnce(const RawCloud& cloud,
           const Members& pool,
           const std::vector<Sample>& all,
           double slack,
           std::size_t most,
           CylinderReach& reach,
           RawCylinder& cylinder)
{
  constexpr double gate = 4;
  const Cylinder& now = cylinder.fit.cylinder;
  const Development development(now);
  const auto isMember = [&](const Sample& sample) {
    const Offset offset(now, sample);
    if (!offset.exists || !(std::abs(offset.value) < gate * cloud.sigma))
      return false;
    const double along = now.along(offset.foot);
    const double turn =
        development.angle(offset.normal) - reach.arc_begin + slack / now.radius;
    return along > reach.low - slack && along < reach.high + slack &&
           turn - 2 * M_PI * std::floor(turn / (2 * M_PI)) <
               reach.arc_length + 2 * slack / now.radius;
  };
  Members members = parallelReduceChunks(
      pool.size(),
      Members(),
      [&](std::size_t begin, std::size_t end) {
        Members some;
        for (std::size_t i = begin; i < end; ++i)
          if (isMember(all[i]))
            some.push_back(pool[i]);
        return some;
      },
      [](Members& joined, const Members& some) {
        joined.insert(joined.end(), some.begin(), some.end());
      });
  cylinder.samples = samplesOf(cloud, members);
  cylinder.members = std::move(members);
  const auto fit =
      fitCylinder(cylinder.samples.size() > most ? thinned(cylinder.samples, most)
                                                 : cylinder.samples,
                  now,
                  cloud.sigma);
  if (!fit)
    return false;
  cylinder.fit = *fit;
  reach = reachOf(fit->cylinder, cylinder.samples, 2 * cloud.spacing);
  return true;
}

constexpr std::size_t enough_to_approach = 20000;

/** Gathers the points on a cylinder of which a part was found, until it does not grow. */
bool
growRaw(const RawCloud& cloud,
        const Members& pool,
        CylinderReach& reach,
        RawCylinder& cylinder)
{
  constexpr int rounds = 12;
  constexpr double settled = 0.01, turn = 0.25; // of the members; radians
  const std::vector<Sample> all = samplesOf(cloud, pool);
  for (int round = 0; round < rounds; ++round) {
    const auto before = static_cast<double>(cylinder.members.size());
    const double slack =
        std::max(2 * cloud.spacing, turn * cylinder.fit.cylinder.radius);
    if (!gatherOnce(cloud, pool, all, slack, enough_to_approach, reach, cylinder))
      return false;
    if (std::abs(static_cast<double>(cylinder.members.size()) - before) <=
        settled * before)
      break;
  }
  return true;
}

class RawSearch {
public:
  /** \param[in] on_mesh the cylinders that were found on a mesh; null: there is no mesh */
  RawSearch(const RawCloud& cloud,
            const CylinderLimits& limits,
            std::vector<RawCylinder>* on_mesh)
  : cloud_(cloud)
  , limits_(limits)
  , has_mesh_(on_mesh)
  , lengths_(lengthsOf(cloud))
  , is_free_(cloud.points.size(), 0)
  , is_taken_(cloud.points.size(), 0)
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
    for (std::size_t p = 0; p < cloud.planes.size(); ++p)
      if (cloud.is_bent[p])
        for (const std::int32_t member : plane_members_[p])
          is_free_[static_cast<std::size_t>(member)] = 1;
    addDirections();
    if (!on_mesh)
      return;
    found_ = std::move(*on_mesh);
    for (const RawCylinder& cylinder : found_)
      setTaken(cylinder);
    for (RawCylinder& cylinder : found_)
      addStrips(cylinder);
  }

  std::vector<RawCylinder>
  run(const Progress& progress)
  {
    constexpr int rounds = 4;
    const double edge = std::max(2.5 * cloud_.spacing, 2 * cloud_.sigma);
    for (int round = 0; round < rounds; ++round) {
      progress.tell(0.4 + 0.15 * round, "cylinders");
      const Members pool = freePoints();
      bool has_found = false;
      for (const Members& cluster : clustersOf(cloud_, pool, edge)) {
        if (!isSearched(cluster) || failed_.count(cluster) > 0)
          continue;
        const bool is_found = searchCluster(cluster, pool);
        has_found |= is_found;
        if (!is_found && has_mesh_)
          failed_.insert(cluster);
      }
      if (!has_found && !searchStrips())
        break;
    }
    return std::move(found_);
  }

private:
  /** The normals of planes and the directions of their edges; only of the largest planes
   * if there is a mesh, which has very many of them. */
  void
  addDirections()
  {
    constexpr std::size_t enough = 8;
    std::vector<std::size_t> order(cloud_.planes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (has_mesh_) {
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return plane_members_[a].size() > plane_members_[b].size();
      });
      order.resize(std::min(order.size(), enough));
    }
    for (const std::size_t plane : order)
      directions_.add(cloud_.planes[plane].coefficients.head<3>());
    const std::vector<Eigen::Vector3d> normals = directions_.all();
    for (std::size_t a = 0; a < normals.size(); ++a)
      for (std::size_t b = a + 1; b < normals.size(); ++b)
        directions_.add(normals[a].cross(normals[b]));
  }

  Members
  freePoints() const
  {
    Members pool;
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i])
        pool.push_back(static_cast<std::int32_t>(i));
    return pool;
  }

  void
  setTaken(const RawCylinder& cylinder)
  {
    for (const std::int32_t member : cylinder.members) {
      is_free_[static_cast<std::size_t>(member)] = 0;
      is_taken_[static_cast<std::size_t>(member)] = 1;
    }
  }

  bool
  extend(const Members& more, RawCylinder& cylinder) const;
  void
  addStrips(RawCylinder& cylinder);
  bool
  join(RawCylinder&& cylinder);
  bool
  isSearched(const Members& cluster) const;
  bool
  isPromising(const RawCylinder& cylinder) const;
  bool
  isExhausted() const;
  bool
  isNear(const Cylinder& cylinder, std::int32_t member) const;
  bool
  searchStrips();
  bool
  isSure(const RawCylinder& cylinder, const CylinderReach& reach) const;
  bool
  searchCluster(const Members& cluster, const Members& pool);
  void
  addPlanesOn(const Cylinder& cylinder, Members& members) const;
  double
  facingOf(const Cylinder& cylinder, const Members& members) const;
  std::optional<CylinderFit>
  bestFit(const Members& members) const;
  Directions
  axesOf(const std::vector<Sample>& samples) const;
  bool
  isCylinder(const RawCylinder& cylinder) const;
  bool
  isShorter(RawCylinder& cylinder) const;

  const RawCloud& cloud_;
  CylinderLimits limits_;
  bool has_mesh_;
  DescriptionLength lengths_;
  std::vector<std::uint8_t> is_free_;  ///< on no plane, or on a bent one
  std::vector<std::uint8_t> is_taken_; ///< by a cylinder
  std::vector<Members> plane_members_;
  Directions directions_; ///< of planes and of their edges
  std::vector<RawCylinder> found_;
  std::size_t looked_at_ = 0; ///< points, by all searches
  std::set<Members> failed_;  ///< clusters; they are not searched again beside a mesh
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

/** Positive if the sensors see a cylinder from inside, 0 if they are unknown. */
double
RawSearch::facingOf(const Cylinder& cylinder, const Members& members) const
{
  double facing = 0;
  for (const std::int32_t member : members) {
    const auto m = static_cast<std::size_t>(member);
    const Eigen::Vector3d point = cloud_.points[m].cast<double>();
    if (const Eigen::Vector3f* const sensor = cloud_.sensors[m])
      facing += cylinder.across(point).dot(
          (point - sensor->cast<double>()).stableNormalized());
  }
  return facing;
}

/** The best of the fits that start at the axes that may be. */
std::optional<CylinderFit>
RawSearch::bestFit(const Members& members) const
{
  const std::vector<Sample> samples = samplesOf(cloud_, members);
  std::optional<CylinderFit> best;
  double best_score = 0;
  const Directions axes = axesOf(samples);
  for (const Eigen::Vector3d& axis : axes.all()) {
    constexpr double enough = 0.85;
    if (best_score > enough * static_cast<double>(samples.size()))
      break; // the axis of the cluster's shape is nearly always right
    std::optional<Cylinder> start = cylinderOfCircle(samples, axis);
    if (!start || start->radius > 100 * limits_.max_radius)
      continue;
    start->is_hollow = facingOf(*start, members) > 0;
    std::vector<double> offs;
    for (const Sample& sample : samples)
      offs.push_back(std::abs(start->distance(sample.point)));
    const double rough = 1.5 * medianOf(offs);
    std::optional<CylinderFit> fit;
    for (double sigma = std::max(rough, cloud_.sigma);;
         sigma = std::max(sigma / 2, cloud_.sigma)) {
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

/** Adds the points of flat planes that are mostly on a cylinder. Which points a strip on
 * it took depends on their noise: without them the fit would be shifted. */
void
RawSearch::addPlanesOn(const Cylinder& cylinder, Members& members) const
{
  constexpr double gate = 4, min_share = 0.6;
  constexpr std::size_t enough = 500;
  for (std::size_t p = 0; p < plane_members_.size(); ++p) {
    if (cloud_.is_bent[p])
      continue;
    const std::vector<Sample> samples =
        samplesOf(cloud_, thinned(plane_members_[p], enough));
    const auto on =
        std::count_if(samples.begin(), samples.end(), [&](const Sample& sample) {
          const Offset offset(cylinder, sample);
          return offset.exists && std::abs(offset.value) < gate * cloud_.sigma;
        });
    if (static_cast<double>(on) < min_share * static_cast<double>(samples.size()))
      continue;
    for (const std::int32_t member : plane_members_[p])
      if (!is_taken_[static_cast<std::size_t>(member)])
        members.push_back(member);
  }
  std::sort(members.begin(), members.end());
}

/** May a cylinder through a cluster be one? Quicker than to gather its points. */
bool
RawSearch::isPromising(const RawCylinder& cylinder) const
{
  constexpr double min_share = 0.3;
  constexpr double max_rms = 2; // sigmas
  Eigen::AlignedBox3d box;
  for (const Sample& sample : cylinder.samples)
    box.extend(sample.point);
  const CylinderFit& fit = cylinder.fit;
  return fit.cylinder.radius < box.diagonal().norm() &&
         fit.rms<max_rms * cloud_.sigma&& static_cast<double>(fit.count)> min_share *
             static_cast<double>(cylinder.samples.size());
}

/** Were the points looked at so often that the rest is not worth it? Clusters are searched
 * in the order of their sizes, and each search looks at all free points; where poses are
 * wrong, these are all points, in very many clusters. */
bool
RawSearch::isExhausted() const
{
  constexpr std::size_t most = 20;
  return looked_at_ > most * cloud_.points.size();
}

/** Is a point so near a cylinder that it may belong to it after a better fit? */
bool
RawSearch::isNear(const Cylinder& cylinder, std::int32_t member) const
{
  constexpr double sigmas = 8, max_change = 0.5; // of the radius
  const Eigen::Vector3d place =
      cloud_.points[static_cast<std::size_t>(member)].cast<double>();
  return std::abs(cylinder.distance(place)) <
         sigmas * cloud_.sigma + max_change * cylinder.radius;
}

/** Is a cluster worth a search? Beside a mesh, small and flat ones are not. */
bool
RawSearch::isSearched(const Members& cluster) const
{
  constexpr std::size_t min_points = 150, enough = 3000;
  constexpr double sigmas = 2;
  if (!has_mesh_)
    return true;
  if (cluster.size() < min_points)
    return false;
  Moments moments;
  const Eigen::Vector3f middle =
      cloud_.points[static_cast<std::size_t>(cluster.front())];
  for (const std::int32_t member : thinned(cluster, enough))
    moments += momentsOf(
        (cloud_.points[static_cast<std::size_t>(member)] - middle).cast<double>());
  return fitPlane(moments).thickness() > sigmas * cloud_.sigma;
}

/** Searches at each bent plane alone: where columns stand close together, or clutter is
 * beside them, their clusters show no single cylinder. */
bool
RawSearch::searchStrips()
{
  constexpr std::size_t min_points = 60;
  bool has_found = false;
  if (!has_mesh_)
    return has_found;
  Members pool = freePoints();
  for (std::size_t p = 0; p < plane_members_.size(); ++p) {
    if (!cloud_.is_bent[p])
      continue;
    Members strip;
    for (const std::int32_t member : plane_members_[p])
      if (is_free_[static_cast<std::size_t>(member)])
        strip.push_back(member);
    if (strip.size() < min_points || 2 * strip.size() < plane_members_[p].size() ||
        !searchCluster(strip, pool))
      continue;
    has_found = true;
    pool = freePoints();
  }
  return has_found;
}

bool
RawSearch::searchCluster(const Members& cluster, const Members& pool)
{
  const std::size_t max_samples = has_mesh_ ? 1000 : 3000;
  RawCylinder cylinder;
  const Members chosen = thinned(cluster, max_samples);
  cylinder.samples = samplesOf(cloud_, chosen);
  const std::optional<CylinderFit> fit = bestFit(chosen);
  if (!fit)
    return false;
  cylinder.fit = *fit;
  if (has_mesh_ && (!isPromising(cylinder) || isExhausted()))
    return false;
  Members candidates;
  for (const std::int32_t member : pool)
    if (is_free_[static_cast<std::size_t>(member)] &&
        (!has_mesh_ || isNear(cylinder.fit.cylinder, member)))
      candidates.push_back(member);
  addPlanesOn(cylinder.fit.cylinder, candidates);
  constexpr std::size_t gatherings = 15; // at most, to grow and to settle
  looked_at_ += pool.size() + gatherings * candidates.size();
  CylinderReach reach =
      reachOf(cylinder.fit.cylinder, cylinder.samples, 2 * cloud_.spacing);
  if (has_mesh_ && !growRaw(cloud_, candidates, reach, cylinder))
    return false;
  if (!gatherRaw(cloud_, candidates, reach, cylinder))
    return false;
  if (!isCylinder(cylinder) || !isShorter(cylinder))
    return false;
  return join(std::move(cylinder));
}

/** Fits a cylinder again with more points; it is unchanged unless it describes them all.
 * \return whether it does */
bool
RawSearch::extend(const Members& more, RawCylinder& cylinder) const
{
  constexpr double max_rms = 1.35, min_share = 0.85, max_change = 0.2;
  RawCylinder both = cylinder;
  Members pool = both.members;
  pool.insert(pool.end(), more.begin(), more.end());
  std::sort(pool.begin(), pool.end());
  both.samples = samplesOf(cloud_, pool);
  const auto fit = fitCylinder(both.samples, cylinder.fit.cylinder, cloud_.sigma);
  if (!fit)
    return false;
  both.fit = *fit;
  const CylinderReach reach = reachOf(fit->cylinder, both.samples, 2 * cloud_.spacing);
  const double radius = cylinder.fit.cylinder.radius;
  if (!gatherRaw(cloud_, pool, reach, both) || both.fit.rms > max_rms * cloud_.sigma ||
      std::abs(both.fit.cylinder.radius - radius) > max_change * radius ||
      static_cast<double>(both.members.size()) <
          min_share * static_cast<double>(pool.size()))
    return false;
  for (const std::int32_t member : more)
    if (std::binary_search(both.members.begin(), both.members.end(), member)) {
      const auto m = static_cast<std::size_t>(member);
      both.gain +=
          bitsOfPoint(cloud_, lengths_, m) -
          lengths_.element(Offset(both.fit.cylinder, sampleOf(cloud_, m)).value);
    }
  both.is_changed = true;
  cylinder = std::move(both);
  return true;
}

/** Adds the bent planes that are mostly on a cylinder of the mesh, which replaces them. */
void
RawSearch::addStrips(RawCylinder& cylinder)
{
  constexpr double gate = 4, min_share = 0.6;
  for (std::size_t p = 0; p < plane_members_.size(); ++p) {
    if (!cloud_.is_bent[p] || plane_members_[p].empty())
      continue;
    const Cylinder& now = cylinder.fit.cylinder;
    const CylinderReach reach = reachOf(now, cylinder.samples, 2 * cloud_.spacing);
    Members strip;
    std::size_t on = 0;
    for (const std::int32_t member : plane_members_[p]) {
      const Eigen::Vector3d place =
          cloud_.points[static_cast<std::size_t>(member)].cast<double>();
      const double along = now.along(place), slack = 2 * cloud_.spacing;
      if (std::abs(now.distance(place)) > gate * cloud_.sigma ||
          along < reach.low - slack || along > reach.high + slack)
        continue;
      ++on;
      if (is_free_[static_cast<std::size_t>(member)])
        strip.push_back(member);
    }
    const auto size = static_cast<double>(plane_members_[p].size());
    if (static_cast<double>(on) < min_share * size || !extend(strip, cylinder))
      continue;
    cylinder.planes.push_back(static_cast<std::int32_t>(p));
    cylinder.gain += lengths_.plane(size);
    setTaken(cylinder);
  }
}

/** Adds a cylinder to those that were found, or to one of them of which it is a part.
 * \return false if it contradicts one of them */
bool
RawSearch::join(RawCylinder&& cylinder)
{
  constexpr double parallel = 0.99, near = 0.25; // 8 degrees; of the radius
  const Cylinder& own = cylinder.fit.cylinder;
  if (has_mesh_)
    for (RawCylinder& other : found_) {
      const Cylinder& theirs = other.fit.cylinder;
      const double radius = std::max(own.radius, theirs.radius);
      if (std::abs(own.axis.dot(theirs.axis)) < parallel ||
          theirs.across(own.point).norm() > near * radius ||
          std::abs(own.radius - theirs.radius) > near * radius)
        continue;
      if (extend(cylinder.members, other)) {
        other.planes.insert(
            other.planes.end(), cylinder.planes.begin(), cylinder.planes.end());
        setTaken(other);
        return true;
      }
      const CylinderReach reach = reachOf(theirs, other.samples, 2 * cloud_.spacing);
      const double along = theirs.along(own.point);
      if (along > reach.low && along < reach.high)
        return false;
    }
  setTaken(cylinder);
  cylinder.is_changed = true;
  found_.push_back(std::move(cylinder));
  return true;
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
  return (!has_mesh_ || isSure(cylinder, reach)) &&
         misfit(cylinder.samples, cylinder.fit, cloud_.sigma / 2) <=
             max_misfit + 18 / count &&
         !isLookedThrough(cloud_, cylinder, reach);
}

/** Is a cylinder clear enough to be no clutter? A smeared edge looks like a whole round bar
 * that is hardly wider than its noise. */
bool
RawSearch::isSure(const RawCylinder& cylinder, const CylinderReach& reach) const
{
  constexpr double min_arc = 0.7;                     // 40 degrees
  constexpr double min_sagitta = 2.5, max_rms = 1.35; // sigmas
  constexpr double half = M_PI, max_noise = 0.12,
                   max_noise_of_half = 0.2; // of the radius
  const double noise = reach.arc_length > 1.1 * half ? max_noise : max_noise_of_half;
  return reach.arc > min_arc && reach.sagitta > min_sagitta * cloud_.sigma &&
         cylinder.fit.rms < max_rms * cloud_.sigma &&
         cylinder.fit.rms < noise * cylinder.fit.cylinder.radius;
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
  const double count = static_cast<double>(cylinder.members.size());
  double on_cylinder = lengths_.cylinder(count), on_plane = lengths_.plane(count);
  double before = 0;
  std::map<std::int32_t, std::size_t> taken;
  for (std::size_t i = 0; i < cylinder.samples.size(); ++i) {
    const Sample& sample = cylinder.samples[i];
    const auto member = static_cast<std::size_t>(cylinder.members[i]);
    const double cosine = sample.hasRay() ? sample.ray.dot(plane.normal) : 1;
    const double off = plane.normal.dot(sample.point - middle - plane.mean) /
                       std::max(std::abs(cosine), min_slant);
    on_cylinder += lengths_.element(Offset(cylinder.fit.cylinder, sample).value);
    on_plane += lengths_.element(off);
    before += bitsOfPoint(cloud_, lengths_, member);
    if (cloud_.labels[member] >= 0)
      ++taken[cloud_.labels[member]];
  }
  for (const auto& [label, number] : taken) {
    const Members& all = plane_members_[static_cast<std::size_t>(label)];
    constexpr double min_share = 0.6;
    if (static_cast<double>(number) < min_share * static_cast<double>(all.size()))
      continue;
    cylinder.planes.push_back(label);
    before += lengths_.plane(static_cast<double>(all.size()));
  }
  cylinder.gain = before - on_cylinder;
  return cylinder.gain > 0 && on_cylinder < on_plane;
}

/** Does the line through a point and its sensor pass a cylinder for certain? Quicker than
 * \ref Offset, which tells it exactly. */
bool
passes(const Cylinder& cylinder,
       const Eigen::Vector3f& point,
       const Eigen::Vector3f& sensor)
{
  constexpr double rounding = 1e-6;
  const Eigen::Vector3d place = point.cast<double>();
  const Eigen::Vector3d line = place - sensor.cast<double>();
  const Eigen::Vector3d way = line - line.dot(cylinder.axis) * cylinder.axis;
  const Eigen::Vector3d from = cylinder.across(place);
  const double a = way.squaredNorm(), b = from.dot(way);
  const double squared = from.squaredNorm(), radius = cylinder.radius * cylinder.radius;
  return b * b - a * (squared - radius) < -rounding * a * (squared + radius);
}

} // namespace

bool
gatherRaw(const RawCloud& cloud,
          const std::vector<std::int32_t>& pool,
          CylinderReach reach,
          RawCylinder& cylinder)
{
  constexpr int rounds = 3;
  const double slack = 2 * cloud.spacing;
  const std::vector<Sample> all = samplesOf(cloud, pool);
  for (int round = 0; round < rounds; ++round) {
    const bool is_last = round + 1 == rounds;
    const std::size_t most = is_last ? pool.size() : enough_to_approach;
    if (!gatherOnce(cloud, pool, all, slack, most, reach, cylinder))
      return false;
  }
  setCovariance(cylinder.samples, cloud.sigma, slack, cylinder.fit);
  return true;
}

namespace {

/** Cells of the developed surface of a cylinder that have points. */
class CoveredCells {
public:
  CoveredCells(const RawCylinder& cylinder, double side)
  : cylinder_(cylinder.fit.cylinder)
  , development_(cylinder_)
  , side_(side)
  {
    for (const Sample& sample : cylinder.samples)
      keys_.push_back(keyOf(cylinder_.across(sample.point), sample.point));
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }

  bool
  contain(const Offset& offset) const
  {
    return std::binary_search(
        keys_.begin(), keys_.end(), keyOf(offset.normal, offset.foot));
  }

private:
  using Key = std::pair<std::int64_t, std::int64_t>;

  Key
  keyOf(const Eigen::Vector3d& across, const Eigen::Vector3d& place) const
  {
    return {std::llround(development_.angle(across) * cylinder_.radius / side_),
            std::llround(cylinder_.along(place) / side_)};
  }

  Cylinder cylinder_;
  Development development_;
  double side_;
  std::vector<Key> keys_;
};

} // namespace

bool
isLookedThrough(const RawCloud& cloud,
                const RawCylinder& cylinder,
                const CylinderReach& reach)
{
  constexpr double min_cosine = 0.4, max_share = 0.15, sigmas = 5;
  constexpr std::size_t enough = 5000; // points on it
  const CylinderFit& fit = cylinder.fit;
  const std::size_t step = 1 + cylinder.members.size() / enough;
  constexpr double side = 3; // spacings
  const CoveredCells covered(cylinder, side * cloud.spacing);
  if (fit.cylinder.is_hollow)
    return false;
  struct Rays {
    std::size_t through = 0, on = 0;
  };
  const auto count = [&](std::size_t begin, std::size_t end) {
    Rays rays;
    for (std::size_t i = begin * step; i < end * step; i += step) {
      const Eigen::Vector3f* const sensor = cloud.sensors[i];
      if (!sensor || passes(fit.cylinder, cloud.points[i], *sensor))
        continue;
      Sample sample{cloud.points[i].cast<double>()};
      if (!sample.point.allFinite())
        continue;
      sample.ray = (sample.point - sensor->cast<double>()).stableNormalized();
      const Offset offset(fit.cylinder, sample);
      if (!offset.exists || std::abs(offset.slant) < min_cosine)
        continue;
      if (offset.value > (sample.point - sensor->cast<double>()).norm())
        continue; // the cylinder is behind the sensor
      const double along = fit.cylinder.along(offset.foot);
      if (along < reach.low || along > reach.high)
        continue;
      // A ray through a place where the surface was seen tells that the sensor stood
      // elsewhere.
      rays.through +=
          offset.value > sigmas * cloud.sigma && !covered.contain(offset) ? 1 : 0;
      rays.on += std::abs(offset.value) <= sigmas * cloud.sigma ? 1 : 0;
    }
    return rays;
  };
  const Rays rays = parallelReduceChunks((cloud.points.size() + step - 1) / step,
                                         Rays(),
                                         count,
                                         [](Rays& all, const Rays& more) {
                                           all.through += more.through;
                                           all.on += more.on;
                                         });
  const auto through = static_cast<double>(rays.through);
  return through > max_share * (through + static_cast<double>(rays.on));
}

double
bitsOfPoint(const RawCloud& cloud, const DescriptionLength& lengths, std::size_t i)
{
  if (cloud.labels[i] < 0)
    return lengths.freeElement();
  const Sample sample = sampleOf(cloud, i);
  const Eigen::Vector4d& plane =
      cloud.planes[static_cast<std::size_t>(cloud.labels[i])].coefficients;
  const double cosine = sample.hasRay() ? sample.ray.dot(plane.head<3>()) : 1;
  return lengths.element((plane.head<3>().dot(sample.point) + plane[3]) /
                         std::max(std::abs(cosine), min_slant));
}

DescriptionLength
lengthsOf(const RawCloud& cloud)
{
  Moments moments;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f point = cloud.points[i];
    if (!point.allFinite())
      continue;
    if (moments.count == 0)
      origin = point.cast<double>();
    moments += momentsOf(point.cast<double>() - origin);
  }
  const double variance = moments.count > 0 ? fitPlane(moments).variances.sum()
                                            : 0; // of a box: side^2 / 12
  return DescriptionLength(cloud.sigma, cloud.spacing, std::sqrt(12 * variance));
}

std::vector<RawCylinder>
findRawCylinders(const RawCloud& cloud,
                 const CylinderLimits& limits,
                 const Progress& progress)
{
  return RawSearch(cloud, limits, nullptr).run(progress);
}

void
addMissedCylinders(const RawCloud& cloud,
                   const CylinderLimits& limits,
                   const Progress& progress,
                   std::vector<RawCylinder>& cylinders)
{
  RawSearch search(cloud, limits, &cylinders);
  cylinders = search.run(progress);
}

} // namespace pcl::acmap::cylinders
