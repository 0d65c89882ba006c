#include "bench.h"
#include "chain_runs.h"
#include "point_tree.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/polygon_triangles.h>

#include <array>
#include <map>
#include <optional>
#include <set>

namespace pcl::acmap::bench {
namespace {

using Cube = std::array<int, 3>;

constexpr double edge = 0.1; // metres

/** A piece of a surface in one view. */
struct ChainPatch {
  Eigen::Vector3d middle, normal;
};

/** The planar pieces in the cubes of a view, in the camera frame. */
std::vector<ChainPatch>
patchesOf(const ChainView& view)
{
  constexpr double fewest = 20;
  std::map<Cube, Moments> cubes;
  for (const Eigen::Vector3d& point : view.points) {
    const Eigen::Vector3i at = (point / edge).array().floor().cast<int>();
    cubes[{at.x(), at.y(), at.z()}] += momentsOf(point);
  }
  std::vector<ChainPatch> patches;
  for (const auto& [cube, moments] : cubes)
    if (const PlaneFit fit = fitPlane(moments);
        moments.count >= fewest && fit.isPlanar())
      patches.push_back({fit.mean, fit.normal});
  return patches;
}

/** Distance across the surface to the nearest one of other patches. */
std::optional<double>
apart(const ChainPatch& patch, const std::vector<ChainPatch>& others)
{
  constexpr double alike = 0.9659; // cosine of 15 degrees
  std::optional<double> found;
  double nearest = edge / 2;
  for (const ChainPatch& other : others) {
    const Eigen::Vector3d between = patch.middle - other.middle;
    const double across = other.normal.dot(between);
    const double along = (between - across * other.normal).norm();
    if (std::abs(across) < edge && along < nearest &&
        std::abs(other.normal.dot(patch.normal)) > alike) {
      nearest = along;
      found = std::abs(across);
    }
  }
  return found;
}

} // namespace

std::vector<Eigen::Vector3d>
thinnedPoints(const PointCloudFile& file)
{
  constexpr std::size_t step = 4; // pixels
  const PointView view = file.points();
  std::vector<Eigen::Vector3d> points;
  for (std::size_t row = 0; row < file.cloud.height; row += step)
    for (std::size_t column = 0; column < file.cloud.width; column += step) {
      const Eigen::Vector3f p = view[row * file.cloud.width + column];
      if (p.allFinite())
        points.push_back(p.cast<double>());
    }
  return points;
}

SurfaceAgreement
compareSurfaces(const std::vector<ChainView>& views,
                std::size_t step,
                Eigen::Isometry3d ChainView::*pose)
{
  std::vector<std::vector<ChainPatch>> patches;
  for (const ChainView& view : views)
    patches.push_back(patchesOf(view));
  std::vector<double> distances;
  for (std::size_t i = 0; i + step < views.size(); ++i) {
    const Eigen::Isometry3d motion =
        (views[i].*pose).inverse() * (views[i + step].*pose);
    for (const ChainPatch& patch : patches[i + step])
      if (const auto distance = apart(
              {motion * patch.middle, motion.linear() * patch.normal}, patches[i]))
        distances.push_back(*distance);
  }
  return {distances.size(), median(distances), quantile(distances, 0.9)};
}

namespace {

using test::Points;

/** Least-squares rotation and translation without reflection (Kabsch). */
Eigen::Isometry3d
bestMotion(const Points& from, const Points& to)
{
  Eigen::Vector3d from_mean = Eigen::Vector3d::Zero(), to_mean = from_mean;
  for (std::size_t i = 0; i < from.size(); ++i) {
    from_mean += from[i] / static_cast<double>(from.size());
    to_mean += to[i] / static_cast<double>(from.size());
  }
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    products += (to[i] - to_mean) * (from[i] - from_mean).transpose();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = alignmentRotation<3>(products);
  motion.translation() = to_mean - motion.linear() * from_mean;
  return motion;
}

/** Samples on planes, each for at most 4 square centimetres, with their plane. */
struct PlanePlaces {
  Points places;
  std::vector<double> area; ///< square metres
  std::vector<std::size_t> plane;
};

/** Splits a triangle into four until it is small, and stores the centres. */
void
addPlaces(const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          const Eigen::Vector3d& c,
          PlanePlaces& places)
{
  constexpr double largest = 0.0004;
  const double area = (b - a).cross(c - a).norm() / 2;
  if (area <= largest) {
    places.places.push_back((a + b + c) / 3);
    places.area.push_back(area);
    return;
  }
  const Eigen::Vector3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  addPlaces(a, ab, ca, places);
  addPlaces(ab, b, bc, places);
  addPlaces(ca, bc, c, places);
  addPlaces(ab, bc, ca, places);
}

PlanePlaces
placesOn(const std::vector<PlanePatch>& planes)
{
  PlanePlaces all;
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
    for (const PlanePolygon& polygon : planes[plane].polygons) {
      const std::vector<Eigen::Vector3f> points = pointsOfPolygon(polygon);
      const auto corner = [&points](std::int32_t i) -> Eigen::Vector3d {
        return points[static_cast<std::size_t>(i)].cast<double>();
      };
      for (const auto& t :
           trianglesOfPolygon(polygon, planes[plane].coefficients.head<3>()))
        addPlaces(corner(t[0]), corner(t[1]), corner(t[2]), all);
      all.plane.resize(all.places.size(), plane);
    }
  return all;
}

std::vector<PlanePatch>
moved(std::vector<PlanePatch> planes, const Eigen::Isometry3d& motion)
{
  for (PlanePatch& plane : planes) {
    const Eigen::Vector3d normal = motion.linear() * plane.coefficients.head<3>();
    plane.coefficients[3] -= normal.dot(motion.translation());
    plane.coefficients.head<3>() = normal;
    for (PlanePolygon& polygon : plane.polygons) {
      for (Eigen::Vector3f& p : polygon.outer)
        p = (motion * p.cast<double>()).cast<float>();
      for (auto& hole : polygon.holes)
        for (Eigen::Vector3f& p : hole)
          p = (motion * p.cast<double>()).cast<float>();
    }
  }
  return planes;
}

/** Overlap of a plane of the reference and a plane of the map. */
struct Shared {
  double area = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(); ///< of the positions, weighted by area
};

double
angleBetween(const PlanePatch& a, const PlanePatch& b)
{
  const double cosine = a.coefficients.head<3>().dot(b.coefficients.head<3>());
  return std::acos(std::min(1.0, std::abs(cosine))) / degree;
}

/** For each plane of the reference, the planes of the map that are near it. */
struct Overlaps {
  std::vector<std::map<std::size_t, Shared>> shared;
  double area = 0, near = 0; ///< area of the reference, and the part of it that is near
                             ///< any plane
};

Overlaps
overlapsOf(const std::vector<PlanePatch>& reference,
           const std::vector<PlanePatch>& planes)
{
  constexpr double reach = 0.05, max_angle = 5; // metres, degrees
  const PlanePlaces here = placesOn(reference), there = placesOn(planes);
  const test::ReferenceTree tree(there.places);
  Overlaps overlaps;
  overlaps.shared.resize(reference.size());
  for (std::size_t i = 0; i < here.places.size(); ++i) {
    const std::size_t plane = here.plane[i];
    std::set<std::size_t> near;
    for (const std::int32_t j : tree.within(here.places[i], reach))
      near.insert(there.plane[static_cast<std::size_t>(j)]);
    bool is_near = false;
    for (const std::size_t other : near)
      if (angleBetween(reference[plane], planes[other]) <= max_angle) {
        Shared& both = overlaps.shared[plane][other];
        both.area += here.area[i];
        both.sum += here.area[i] * here.places[i];
        is_near = true;
      }
    overlaps.area += here.area[i];
    overlaps.near += is_near ? here.area[i] : 0;
  }
  return overlaps;
}

} // namespace

PointAgreement
comparePoints(const std::vector<ChainView>& views)
{
  Points given, found;
  for (const ChainView& view : views)
    for (const Eigen::Vector3d& point : view.points) {
      given.push_back(view.given * point);
      found.push_back(view.found * point);
    }
  PointAgreement agreement;
  agreement.T_given_found = bestMotion(found, given);
  std::vector<double> apart;
  for (std::size_t i = 0; i < given.size(); ++i)
    apart.push_back((agreement.T_given_found * found[i] - given[i]).norm());
  agreement.median = median(apart);
  agreement.maximum = quantile(apart, 0.95);
  return agreement;
}

PlaneAgreement
comparePlanes(const std::vector<PlanePatch>& reference,
              const std::vector<PlanePatch>& map_planes,
              const Eigen::Isometry3d& T_reference_map)
{
  constexpr double small = 0.25; // square metres
  const std::vector<PlanePatch> planes = moved(map_planes, T_reference_map);
  const Overlaps overlaps = overlapsOf(reference, planes);
  PlaneAgreement agreement;
  agreement.area = overlaps.near / overlaps.area;
  std::vector<double> angles, offsets;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const auto& shared = overlaps.shared[i];
    const auto partner = std::max_element(
        shared.begin(), shared.end(), [](const auto& a, const auto& b) {
          return a.second.area < b.second.area;
        });
    if (partner == shared.end())
      continue;
    ++agreement.planes;
    if (reference[i].area < small)
      continue;
    const PlanePatch& plane = planes[partner->first];
    const Eigen::Vector3d middle = partner->second.sum / partner->second.area;
    angles.push_back(angleBetween(reference[i], plane));
    offsets.push_back(
        std::abs(plane.coefficients.head<3>().dot(middle) + plane.coefficients[3]));
  }
  agreement.angle = median(angles);
  agreement.angle_maximum = quantile(angles, 1);
  agreement.offset = median(offsets);
  agreement.offset_maximum = quantile(offsets, 1);
  return agreement;
}

} // namespace pcl::acmap::bench
