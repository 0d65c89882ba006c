#include "cylinders/cylinder_growth.h"

#include "cylinders/cylinder_union.h"
#include "mesh_neighbourhood.h"
#include "region_growing.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/parallel.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

namespace pcl::acmap::cylinders {
namespace {

constexpr double degree = M_PI / 180;

/** Owner of the elements that no cylinder may take. */
constexpr std::int32_t wide_plane = no_region - 1;

/** Elements near a cylinder with normals along its radius. */
class CylinderRegion {
public:
  /** \param[in] owner of each element: those of wide planes are not accepted
   * \param[in] times that each element was grown over; after very many of them it is not
   * accepted any more */
  CylinderRegion(const SurfaceElements& elements,
                 const std::vector<std::int32_t>& owner,
                 const std::vector<std::uint8_t>& times,
                 const Cylinder& cylinder,
                 double distance)
  : elements_(elements)
  , owner_(owner)
  , times_(times)
  , cylinder_(cylinder)
  , distance_(distance)
  {}

  bool
  accepts(std::size_t i) const
  {
    constexpr std::uint8_t most = 128;
    if (owner_[i] == wide_plane || times_[i] >= most)
      return false;
    const Eigen::Vector3d from = cylinder_.across(elements_.points[i]);
    const double radius = from.norm();
    if (!(std::abs(radius - cylinder_.radius) < distance_)) // false for NaN
      return false;
    if (!elements_.is_smooth[i])
      return !elements_.is_oriented; // at an edge of surfaces that are not meshed
    const double cosine = from.dot(elements_.normals[i]) / radius;
    constexpr double min_cosine = 0.88; // 28 degrees
    if (!elements_.is_oriented)
      return std::abs(cosine) > min_cosine;
    return (cylinder_.is_hollow ? -cosine : cosine) > min_cosine;
  }

  void
  add(std::size_t)
  {}

private:
  const SurfaceElements& elements_;
  const std::vector<std::int32_t>& owner_;
  const std::vector<std::uint8_t>& times_;
  const Cylinder& cylinder_;
  double distance_;
};

/** A cylinder through a small patch. */
struct Seed {
  double error = 0; ///< metres, of the mean over the patch
  std::int32_t element = 0;
  Cylinder cylinder;
  std::vector<std::int32_t> patch;
};

/** Collects elements breadth first over smooth neighbours, with their normals on one
 * side. */
class PatchWalk {
public:
  explicit PatchWalk(const SurfaceElements& elements)
  : elements_(elements)
  , visited_(elements.size(), 0)
  {}

  /** \return the largest squared distance from the start to an element that was looked at,
   * square metres: the patch does not depend on others */
  double
  walk(std::int32_t start,
       std::size_t size,
       const std::vector<std::int32_t>& owner,
       std::vector<std::int32_t>& patch,
       std::vector<Eigen::Vector3d>& normals)
  {
    constexpr double min_cosine = 0.8; // 37 degrees from one to the next
    ++round_;
    patch.assign(1, start);
    normals.assign(1, elements_.normals[static_cast<std::size_t>(start)]);
    visited_[static_cast<std::size_t>(start)] = round_;
    const Eigen::Vector3d& middle = elements_.points[static_cast<std::size_t>(start)];
    double reach = 0;
    for (std::size_t next = 0; next < patch.size() && patch.size() < size; ++next)
      for (const std::int32_t other :
           elements_.neighbours[static_cast<std::size_t>(patch[next])]) {
        const auto o = static_cast<std::size_t>(other);
        if (visited_[o] == round_ || !elements_.is_smooth[o] || patch.size() == size)
          continue;
        reach = std::max(reach, (elements_.points[o] - middle).squaredNorm());
        if (owner[o] != no_region)
          continue;
        const double cosine = normals[next].dot(elements_.normals[o]);
        if (std::abs(cosine) < min_cosine || (elements_.is_oriented && cosine < 0))
          continue;
        visited_[o] = round_;
        patch.push_back(other);
        normals.emplace_back(cosine < 0 ? Eigen::Vector3d(-elements_.normals[o])
                                        : elements_.normals[o]);
      }
    return reach;
  }

private:
  const SurfaceElements& elements_;
  std::vector<std::uint32_t> visited_; ///< round of the last visit
  std::uint32_t round_ = 0;
};

/** The cylinder whose axis is across all normals of a patch: these lie on a great
 * circle of the sphere. */
bool
seedOf(const SurfaceElements& elements,
       const std::vector<std::int32_t>& patch,
       const std::vector<Eigen::Vector3d>& normals,
       Seed& seed)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    sum += normals[i] * normals[i].transpose();
    points.push_back(elements.points[static_cast<std::size_t>(patch[i])]);
  }
  const double count = static_cast<double>(patch.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum / count);
  const Eigen::Vector3d& spread = solver.eigenvalues();
  const double min_spread = std::pow(0.4 * degree, 2);
  if (!(spread[1] > min_spread) || !(spread[1] > 4 * spread[0]))
    return false;
  double residual = 0;
  const auto cylinder =
      cylinderOfNormals(points, normals, solver.eigenvectors().col(0), residual);
  if (!cylinder || residual > 3 * elements.sigma + 0.25 * elements.spacing ||
      std::abs(cylinder->radius) > 4 * elements.extent)
    return false;
  seed.cylinder = *cylinder;
  seed.cylinder.is_hollow = cylinder->radius < 0 && elements.is_oriented;
  seed.cylinder.radius = std::abs(cylinder->radius);
  seed.error = residual / std::sqrt(count);
  seed.element = patch[0];
  seed.patch = patch;
  return true;
}

/** One element of each cube that is free and smooth. */
std::vector<std::int32_t>
spreadElements(const SurfaceElements& elements, const std::vector<std::int32_t>& owner)
{
  const double side = 1.75 * elements.spacing;
  using Place = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int32_t>;
  std::vector<Place> places;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!elements.is_smooth[i] || owner[i] != no_region)
      continue;
    const Eigen::Array3d cube =
        (elements.points[i].array() / side).floor().max(-1e15).min(1e15);
    places.emplace_back(static_cast<std::int64_t>(cube[0]),
                        static_cast<std::int64_t>(cube[1]),
                        static_cast<std::int64_t>(cube[2]),
                        static_cast<std::int32_t>(i));
  }
  std::sort(places.begin(), places.end());
  std::vector<std::int32_t> chosen;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [x, y, z, element] = places[i];
    if (i > 0 && std::get<0>(places[i - 1]) == x && std::get<1>(places[i - 1]) == y &&
        std::get<2>(places[i - 1]) == z)
      continue;
    chosen.push_back(element);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/** The seeds at one element, over patches of several sizes. */
struct SeedsOfElement {
  std::int32_t element = 0;
  double squared_reach = 0; ///< square metres: they do not depend on elements beyond
  std::vector<Seed> seeds;
};

SeedsOfElement
seedsAt(std::int32_t element,
        const SurfaceElements& elements,
        const std::vector<std::int32_t>& owner,
        PatchWalk& walk)
{
  constexpr std::array<std::size_t, 4> sizes{16, 40, 100, 250};
  SeedsOfElement found;
  found.element = element;
  std::vector<std::int32_t> patch, part;
  std::vector<Eigen::Vector3d> normals, part_normals;
  found.squared_reach = walk.walk(element, sizes.back(), owner, patch, normals);
  std::size_t before = 0;
  for (const std::size_t size : sizes) {
    const std::size_t used = std::min(size, patch.size());
    if (used < sizes.front() || used == before)
      break;
    before = used;
    part.assign(patch.begin(), patch.begin() + static_cast<std::ptrdiff_t>(used));
    part_normals.assign(normals.begin(),
                        normals.begin() + static_cast<std::ptrdiff_t>(used));
    Seed seed;
    if (seedOf(elements, part, part_normals, seed))
      found.seeds.push_back(std::move(seed));
  }
  return found;
}

/** The seeds of a surface, which are searched again only where elements were taken since
 * the last search. */
class SeedSearch {
public:
  explicit SeedSearch(const SurfaceElements& elements)
  : elements_(elements)
  , walks_([&elements] { return PatchWalk(elements); })
  {}

  /** To be called for elements that were taken. */
  void
  addTaken(const std::vector<std::int32_t>& members)
  {
    Eigen::AlignedBox3d box;
    for (const std::int32_t member : members)
      box.extend(elements_.points[static_cast<std::size_t>(member)]);
    taken_.push_back(box);
  }

  /** \return the seeds in the order of their errors; valid until the next call */
  std::vector<const Seed*>
  run(const std::vector<std::int32_t>& owner)
  {
    search(spreadElements(elements_, owner), owner);
    taken_.clear();
    std::vector<const Seed*> seeds;
    for (const SeedsOfElement& of_element : found_)
      for (const Seed& seed : of_element.seeds)
        seeds.push_back(&seed);
    std::stable_sort(seeds.begin(), seeds.end(), [](const Seed* a, const Seed* b) {
      return a->error < b->error;
    });
    return seeds;
  }

private:
  /** \param[in] starts ascending */
  void
  search(const std::vector<std::int32_t>& starts,
         const std::vector<std::int32_t>& owner)
  {
    constexpr std::size_t of_a_part = 256;
    std::vector<SeedsOfElement> before = std::move(found_);
    found_.assign(starts.size(), {});
    const std::size_t parts = (starts.size() + of_a_part - 1) / of_a_part;
    oneapi::tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
      PatchWalk& walk = walks_.local();
      const std::size_t end = std::min((part + 1) * of_a_part, starts.size());
      for (std::size_t i = part * of_a_part; i < end; ++i) {
        const auto known =
            std::lower_bound(before.begin(),
                             before.end(),
                             starts[i],
                             [](const SeedsOfElement& seeds, std::int32_t element) {
                               return seeds.element < element;
                             });
        if (known != before.end() && known->element == starts[i] &&
            !isNearTaken(*known))
          found_[i] = std::move(*known);
        else
          found_[i] = seedsAt(starts[i], elements_, owner, walk);
      }
    });
  }

  bool
  isNearTaken(const SeedsOfElement& seeds) const
  {
    constexpr double rounding = 1 + 1e-9;
    const Eigen::Vector3d& middle =
        elements_.points[static_cast<std::size_t>(seeds.element)];
    return std::any_of(
        taken_.begin(), taken_.end(), [&](const Eigen::AlignedBox3d& box) {
          return box.squaredExteriorDistance(middle) <= rounding * seeds.squared_reach;
        });
  }

  const SurfaceElements& elements_;
  oneapi::tbb::enumerable_thread_specific<PatchWalk> walks_;
  std::vector<SeedsOfElement> found_;      ///< in the order of the elements
  std::vector<Eigen::AlignedBox3d> taken_; ///< around elements, since the last search
};

/** Connected elements of one plane. */
class PlanePiece {
public:
  PlanePiece(const PointLabels& labels, std::int32_t plane)
  : labels_(labels)
  , plane_(plane)
  {}

  bool
  accepts(std::size_t i) const
  {
    return labels_[i] == plane_;
  }

  void
  add(std::size_t)
  {}

private:
  const PointLabels& labels_;
  std::int32_t plane_;
};

/** Marks the elements of pieces of planes that are wider than strips of a cylinder: no
 * cylinder replaces these, and it would take long to try at each of their elements. A
 * strip on a column may be coplanar with a wall. */
std::vector<std::int32_t>
ownersOfWidePlanes(const SurfaceElements& elements, const KnownFaces& faces)
{
  constexpr double max_width = 20; // spacings
  const MeshNeighbourhood neighbours(elements.neighbours);
  std::vector<std::int32_t> owners(elements.size(), no_region);
  std::vector<std::int32_t> pieces(elements.size(), no_region);
  for (std::size_t i = 0; i < faces.labels.size(); ++i) {
    if (faces.labels[i] < 0 || pieces[i] != no_region ||
        !elements.points[i].allFinite())
      continue;
    PlanePiece piece(faces.labels, faces.labels[i]);
    std::vector<std::int32_t> members{static_cast<std::int32_t>(i)};
    pieces[i] = 0;
    growRegion(neighbours, piece, members, pieces, 0);
    Moments moments;
    for (const std::int32_t member : members)
      moments += momentsOf(elements.points[static_cast<std::size_t>(member)]);
    if (std::sqrt(12 * fitPlane(moments).variances[1]) > max_width * elements.spacing)
      for (const std::int32_t member : members)
        owners[static_cast<std::size_t>(member)] = wide_plane;
  }
  return owners;
}

class CylinderSearch {
public:
  CylinderSearch(const SurfaceElements& elements,
                 const KnownFaces& faces,
                 const CylinderLimits& limits)
  : elements_(elements)
  , faces_(faces)
  , limits_(limits)
  , lengths_(elements.sigma, elements.spacing, elements.extent)
  , owner_(ownersOfWidePlanes(elements, faces))
  , wide_(owner_)
  , seed_search_(elements)
  , scratch_(elements.size(), no_region)
  , failures_(elements.size(), 0)
  , times_(elements.size(), 0)
  , plane_sizes_(faces.planes.size(), 0)
  , plane_bits_(faces.planes.size(), 0)
  {
    for (std::size_t i = 0; i < faces.labels.size(); ++i)
      if (faces.labels[i] >= 0) {
        const auto plane = static_cast<std::size_t>(faces.labels[i]);
        ++plane_sizes_[plane];
        plane_bits_[plane] += bitsBefore(static_cast<std::int32_t>(i));
      }
  }

  std::vector<GrownCylinder>
  run(const Progress& progress)
  {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
      progress.tell(0.1 + 0.25 * round, "cylinders");
      if (!take(growCandidates()))
        break;
    }
    uniteCoaxial();
    finish();
    return std::move(taken_);
  }

private:
  double
  tolerance() const
  {
    return gate_sigmas_ * elements_.sigma;
  }

  /** Bits that a cylinder must save. The errors of neighbouring vertices of a mesh are not
   * independent. */
  double
  minGain() const
  {
    return elements_.is_mesh ? 30 : 0;
  }

  std::vector<Sample>
  samplesOf(const std::vector<std::int32_t>& members) const
  {
    return elements_.samplesOf(members);
  }

  std::vector<GrownCylinder>
  growCandidates();
  std::optional<GrownCylinder>
  grow(const Seed& seed);
  bool
  isTried(const Seed& seed) const;
  void
  addFailure(const std::vector<std::int32_t>& members);
  bool
  isCylinder(const GrownCylinder& grown, bool is_final) const;
  bool
  isRoundedEdge(double radius, double arc, bool is_hollow) const;
  bool
  areNormalsAcross(const GrownCylinder& grown) const;
  void
  weigh(GrownCylinder& grown) const;
  double
  bitsBefore(std::int32_t element) const;
  bool
  take(std::vector<GrownCylinder> candidates);
  void
  uniteCoaxial();
  void
  finish();

  static constexpr double gate_sigmas_ = 3;

  const SurfaceElements& elements_;
  const KnownFaces& faces_;
  CylinderLimits limits_;
  DescriptionLength lengths_;
  std::vector<std::int32_t> owner_; ///< taken cylinder of each element, or wide_plane
  std::vector<std::int32_t> wide_;  ///< the same without cylinders

  SeedSearch seed_search_;
  std::vector<std::int32_t> scratch_; ///< of one region; no_region between
  std::vector<std::uint8_t>
      failures_;                    ///< regions of each element that were no cylinder
  std::vector<std::uint8_t> times_; ///< that each element was grown over
  std::vector<std::size_t> plane_sizes_;
  std::vector<double> plane_bits_; ///< of the elements of each plane
  std::vector<GrownCylinder> taken_;
};

std::vector<GrownCylinder>
CylinderSearch::growCandidates()
{
  times_.assign(elements_.size(), 0);
  std::vector<std::uint8_t> is_covered(elements_.size(), 0);
  std::vector<GrownCylinder> candidates;
  for (const Seed* const seed : seed_search_.run(owner_)) {
    if (is_covered[static_cast<std::size_t>(seed->element)] || isTried(*seed))
      continue;
    std::optional<GrownCylinder> candidate = grow(*seed);
    if (!candidate)
      continue;
    for (const std::int32_t member : candidate->members)
      is_covered[static_cast<std::size_t>(member)] = 1;
    candidates.push_back(std::move(*candidate));
  }
  return candidates;
}

/** Floods and fits alternately until the region does not change. */
std::optional<GrownCylinder>
CylinderSearch::grow(const Seed& seed)
{
  constexpr int max_rounds = 8, wide_rounds = 2;
  constexpr double settled = 0.002; // change of the number of members
  const MeshNeighbourhood neighbours(elements_.neighbours);
  GrownCylinder grown;
  grown.fit.cylinder = seed.cylinder;
  std::vector<std::int32_t> start = seed.patch;
  for (int round = 0; round < max_rounds; ++round) {
    const Cylinder cylinder = grown.fit.cylinder;
    CylinderRegion region(elements_,
                          owner_,
                          times_,
                          cylinder,
                          (round < wide_rounds ? 2 : 1) * tolerance());
    std::vector<std::int32_t> members;
    for (const std::int32_t element : start)
      if (region.accepts(static_cast<std::size_t>(element))) {
        members.push_back(element);
        scratch_[static_cast<std::size_t>(element)] = 0;
      }
    if (2 * members.size() >= start.size())
      growRegion(neighbours, region, members, scratch_, 0);
    for (const std::int32_t member : members) {
      scratch_[static_cast<std::size_t>(member)] = no_region;
      ++times_[static_cast<std::size_t>(member)];
    }
    members.erase(std::remove_if(members.begin(),
                                 members.end(),
                                 [&](std::int32_t member) {
                                   return owner_[static_cast<std::size_t>(member)] !=
                                          no_region;
                                 }),
                  members.end());
    constexpr std::size_t min_members = 12;
    if (members.size() < min_members || 2 * members.size() < start.size())
      return {};
    const double change = std::abs(static_cast<double>(members.size()) -
                                   static_cast<double>(grown.members.size()));
    std::sort(members.begin(), members.end());
    const bool is_settled =
        round >= wide_rounds &&
        change <= settled * static_cast<double>(grown.members.size());
    grown.members = std::move(members);
    const bool is_last = is_settled || round + 1 == max_rounds;
    auto fit = (is_last ? fitCylinder : roughFit)(
        samplesOf(grown.members), cylinder, elements_.sigma);
    if (!fit || fit->cylinder.radius < limits_.min_radius / 2 ||
        fit->cylinder.radius > 2 * limits_.max_radius)
      return {};
    fit->cylinder.is_hollow = cylinder.is_hollow;
    grown.fit = *fit;
    start = grown.members;
    if (is_settled)
      break;
  }
  if (isCylinder(grown, false)) {
    const std::vector<std::int32_t> members = grown.members;
    weigh(grown);
    if (grown.gain > minGain())
      return grown;
    grown.members = members;
  }
  addFailure(grown.members);
  return {};
}

/** Neighbouring seeds of a surface that is curved, but no cylinder, grow to nearly the same
 * region: after a few of them, the others are not tried. */
bool
CylinderSearch::isTried(const Seed& seed) const
{
  constexpr std::uint8_t enough = 6;
  return failures_[static_cast<std::size_t>(seed.element)] >= enough;
}

void
CylinderSearch::addFailure(const std::vector<std::int32_t>& members)
{
  for (const std::int32_t member : members) {
    std::uint8_t& failures = failures_[static_cast<std::size_t>(member)];
    failures += failures < 255 ? 1 : 0;
  }
}

/** Bits alone say yes too often, because errors of models are correlated. */
bool
CylinderSearch::isCylinder(const GrownCylinder& grown, bool is_final) const
{
  const double radius = grown.fit.cylinder.radius;
  if (radius < limits_.min_radius || radius > limits_.max_radius)
    return false;
  const std::vector<Sample> samples = samplesOf(grown.members);
  const CylinderReach reach = reachOf(grown.fit.cylinder, samples, elements_.spacing);
  const double min_arc = (is_final ? 22 : 11) * degree;
  const double min_sagitta =
      std::max({3 * grown.fit.rms,
                2.5 * tolerance(),
                (elements_.is_mesh ? 0.02 : 0.012) * reach.chord});
  if (reach.arc < min_arc || reach.sagitta < min_sagitta ||
      isRoundedEdge(radius, reach.arc, grown.fit.cylinder.is_hollow))
    return false;
  constexpr double max_rms = 0.12; // of the radius
  if (grown.fit.rms > max_rms * radius)
    return false;
  constexpr double max_misfit = 0.35, of_few = 8; // nine terms are fitted
  constexpr double mesh_bias = 0.08; // of the spacing, where views and surfaces end
  const double noise = std::max(elements_.sigma / 2,
                                elements_.is_mesh ? mesh_bias * elements_.spacing : 0);
  const double count = static_cast<double>(grown.members.size());
  return misfit(samples, grown.fit, noise) <= max_misfit + of_few / count &&
         areNormalsAcross(grown);
}

/** Is a cylinder as narrow as those by which a mesh rounds the edges and corners of
 * planes? Its triangles cut inner edges at a few spacings, and outer ones at their tips. */
bool
CylinderSearch::isRoundedEdge(double radius, double arc, bool is_hollow) const
{
  if (!elements_.is_mesh)
    return false;
  const double spacings = radius / elements_.spacing;
  return is_hollow ? spacings < 5 || (spacings < 10 && arc < 60 * degree)
                   : spacings < 6 && arc < 80 * degree;
}

/** Are the normals across the axis, on average and at both ends? On a cone they lean to
 * one side, on a torus or ball more and more towards the ends. Normals at the rim lean,
 * too, where the surface ends at an edge. */
bool
CylinderSearch::areNormalsAcross(const GrownCylinder& grown) const
{
  const Cylinder& cylinder = grown.fit.cylinder;
  const auto isMember = [&](std::int32_t element) {
    return std::binary_search(grown.members.begin(), grown.members.end(), element);
  };
  double count = 0, sum = 0, sum_z = 0, sum_zz = 0, sum_z_lean = 0;
  for (const std::int32_t member : grown.members) {
    const auto m = static_cast<std::size_t>(member);
    const VertexNeighbours::Range others = elements_.neighbours[m];
    if (!elements_.is_smooth[m] || !std::all_of(others.begin(), others.end(), isMember))
      continue;
    const Eigen::Vector3d& normal = elements_.normals[m];
    const double side = normal.dot(cylinder.across(elements_.points[m])) < 0 ? -1 : 1;
    const double lean = side * normal.dot(cylinder.axis);
    const double z = cylinder.along(elements_.points[m]);
    count += 1;
    sum += lean;
    sum_z += z;
    sum_zz += z * z;
    sum_z_lean += z * lean;
  }
  constexpr double min_inner = 8;
  if (count < min_inner)
    return true;
  const double mean = sum / count, mean_z = sum_z / count;
  const double variance = sum_zz / count - mean_z * mean_z;
  const double trend = (sum_z_lean / count - mean_z * mean) / std::sqrt(variance);
  constexpr double max_lean = 3 * degree;
  return std::abs(mean) < max_lean && !(std::abs(trend) > max_lean);
}

double
CylinderSearch::bitsBefore(std::int32_t element) const
{
  const auto e = static_cast<std::size_t>(element);
  const std::int32_t plane = faces_.labels.empty() ? -1 : faces_.labels[e];
  if (plane < 0)
    return lengths_.freeElement();
  const Eigen::Vector4d& face = faces_.planes[static_cast<std::size_t>(plane)];
  return lengths_.element(face.head<3>().dot(elements_.points[e]) + face[3]);
}

/** Removes members that are taken, or nearer to a plane that stays, and sets the gain
 * of the others. */
void
CylinderSearch::weigh(GrownCylinder& grown) const
{
  std::vector<std::size_t> taken(faces_.planes.size(), 0);
  const auto planeOf = [&](std::int32_t member) {
    return faces_.labels.empty() ? -1 : faces_.labels[static_cast<std::size_t>(member)];
  };
  const auto isFallen = [&](std::int32_t plane) {
    const auto p = static_cast<std::size_t>(plane);
    constexpr double min_share = 0.6;
    return static_cast<double>(taken[p]) >
           min_share * static_cast<double>(plane_sizes_[p]);
  };
  for (const std::int32_t member : grown.members)
    if (planeOf(member) >= 0)
      ++taken[static_cast<std::size_t>(planeOf(member))];
  const auto leaves = [&](std::int32_t member) {
    const auto m = static_cast<std::size_t>(member);
    if (owner_[m] != no_region)
      return true;
    const std::int32_t plane = planeOf(member);
    return plane >= 0 && !isFallen(plane) &&
           bitsBefore(member) <=
               lengths_.element(grown.fit.cylinder.distance(elements_.points[m]));
  };
  grown.members.erase(
      std::remove_if(grown.members.begin(), grown.members.end(), leaves),
      grown.members.end());
  const double count = static_cast<double>(grown.members.size());
  grown.gain = -lengths_.cylinder(count);
  for (const std::int32_t member : grown.members)
    grown.gain +=
        bitsBefore(member) - lengths_.element(grown.fit.cylinder.distance(
                                 elements_.points[static_cast<std::size_t>(member)]));
  grown.planes.clear();
  for (std::size_t p = 0; p < taken.size(); ++p)
    if (isFallen(static_cast<std::int32_t>(p))) {
      grown.planes.push_back(static_cast<std::int32_t>(p));
      grown.gain += lengths_.plane(static_cast<double>(plane_sizes_[p]));
    }
  // The other elements of the replaced planes are then on no plane.
  std::vector<double> rest = plane_bits_;
  for (const std::int32_t member : grown.members)
    if (planeOf(member) >= 0)
      rest[static_cast<std::size_t>(planeOf(member))] -= bitsBefore(member);
  for (const std::int32_t plane : grown.planes) {
    const auto p = static_cast<std::size_t>(plane);
    grown.gain += rest[p] - static_cast<double>(plane_sizes_[p] - taken[p]) *
                                lengths_.freeElement();
  }
}

/** Takes candidates in the order of their gains; elements that are taken are lost for
 * the others. */
bool
CylinderSearch::take(std::vector<GrownCylinder> candidates)
{
  constexpr double min_left = 0.6; // of the members
  bool has_taken = false;
  while (!candidates.empty()) {
    const auto best =
        std::max_element(candidates.begin(),
                         candidates.end(),
                         [](const auto& a, const auto& b) { return a.gain < b.gain; });
    const std::size_t before = best->members.size();
    const double gain = best->gain;
    weigh(*best);
    if (static_cast<double>(best->members.size()) <
            min_left * static_cast<double>(before) ||
        !(best->gain > minGain())) {
      candidates.erase(best);
      continue;
    }
    if (best->gain < gain)
      continue; // another one may be better now
    for (const std::int32_t member : best->members)
      owner_[static_cast<std::size_t>(member)] =
          static_cast<std::int32_t>(taken_.size());
    seed_search_.addTaken(best->members);
    taken_.push_back(std::move(*best));
    candidates.erase(best);
    has_taken = true;
  }
  return has_taken;
}

void
CylinderSearch::uniteCoaxial()
{
  const auto tryBoth = [&](const GrownCylinder& a, const GrownCylinder& b) {
    std::optional<GrownCylinder> both;
    if (!mayBeOne(a, b, elements_.sigma))
      return both;
    both.emplace(a);
    both->members.insert(both->members.end(), b.members.begin(), b.members.end());
    std::sort(both->members.begin(), both->members.end());
    const auto fit =
        fitCylinder(samplesOf(both->members), a.fit.cylinder, elements_.sigma);
    if (!fit || !fitsBoth(*fit, a, b, elements_.sigma))
      return std::optional<GrownCylinder>();
    const bool is_hollow = a.fit.cylinder.is_hollow;
    both->fit = *fit;
    both->fit.cylinder.is_hollow = is_hollow;
    both->planes.insert(both->planes.end(), b.planes.begin(), b.planes.end());
    return both;
  };
  unite(taken_, tryBoth);
}

/** Checks the cylinders again, now that pieces are united, and drops what is none. */
void
CylinderSearch::finish()
{
  std::vector<GrownCylinder> kept;
  owner_ = wide_;
  for (GrownCylinder& grown : taken_) {
    weigh(grown);
    if (!(grown.gain > minGain()) || !isCylinder(grown, true))
      continue;
    for (const std::int32_t member : grown.members)
      owner_[static_cast<std::size_t>(member)] = static_cast<std::int32_t>(kept.size());
    kept.push_back(std::move(grown));
  }
  taken_ = std::move(kept);
}

} // namespace

CylinderReach
reachOf(const Cylinder& cylinder, const std::vector<Sample>& samples, double spacing)
{
  CylinderReach reach;
  const Development development(cylinder);
  struct Places {
    std::vector<double> angles, heights;
  };
  const auto placesOf = [&](std::size_t begin, std::size_t end) {
    Places places;
    for (std::size_t i = begin; i < end; ++i) {
      const Offset offset(cylinder, samples[i]);
      if (!offset.exists)
        continue;
      places.angles.push_back(development.angle(offset.normal));
      places.heights.push_back(cylinder.along(offset.foot));
    }
    return places;
  };
  auto [angles, heights] = parallelReduceChunks(
      samples.size(), Places(), placesOf, [](Places& all, const Places& some) {
        all.angles.insert(all.angles.end(), some.angles.begin(), some.angles.end());
        all.heights.insert(all.heights.end(), some.heights.begin(), some.heights.end());
      });
  if (angles.empty())
    return reach;
  std::sort(angles.begin(), angles.end());
  const double max_gap = std::max(5 * degree, 2.5 * spacing / cylinder.radius);
  double widest = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double before = i > 0 ? angles[i - 1] : angles.back() - 2 * M_PI;
    const double gap = angles[i] - before;
    reach.arc += gap < max_gap ? gap : 0;
    if (gap <= widest)
      continue;
    widest = gap;
    reach.arc_begin = angles[i];
  }
  reach.arc_length = 2 * M_PI - (widest < max_gap ? 0 : widest);
  const double half = std::min(reach.arc_length / 2, M_PI / 2);
  reach.chord = 2 * cylinder.radius * std::sin(half);
  reach.sagitta = cylinder.radius * (1 - std::cos(reach.arc_length / 2));
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  reach.low = *low;
  reach.high = *high;
  return reach;
}

std::vector<GrownCylinder>
growCylinders(const SurfaceElements& elements,
              const KnownFaces& faces,
              const CylinderLimits& limits,
              const Progress& progress)
{
  CylinderSearch search(elements, faces, limits);
  return search.run(progress);
}

} // namespace pcl::acmap::cylinders
