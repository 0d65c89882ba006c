#include <pcl/core/cylinder_facets.h>

#include <pcl/core/impl/arguments.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

constexpr double full_turn = 2 * M_PI;

/** Number of facets whose sagitta is at most the tolerance. */
int
numberOfFacets(const CylinderPatch& cylinder, double tolerance)
{
  constexpr double min_of_turn = 12, maximum = 720;
  const double share = std::min(tolerance / cylinder.radius, 1.0);
  const double of_turn = std::max(M_PI / std::acos(1 - share), min_of_turn);
  const double turns = std::min(cylinder.arc / full_turn, 1.0);
  return static_cast<int>(std::clamp(std::ceil(turns * of_turn), 1.0, maximum));
}

/** The directions across the axis at which facets begin and end; the last one of a closed
 * cylinder is the first one. */
std::vector<Eigen::Vector3d>
directionsOf(const CylinderPatch& cylinder, int facets)
{
  constexpr double closed = full_turn * (1 - 1e-9);
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i <= facets; ++i) {
    const double angle = cylinder.arc * (static_cast<double>(i) / facets - 0.5);
    directions.emplace_back(std::cos(angle) * cylinder.axis_u +
                            std::sin(angle) * cylinder.axis_v);
  }
  if (cylinder.arc >= closed)
    directions.back() = directions.front();
  return directions;
}

/** The facet between two directions. */
PlanePatch
facetBetween(const CylinderPatch& cylinder,
             const Eigen::Vector3d& first,
             const Eigen::Vector3d& second)
{
  const auto corner = [&](const Eigen::Vector3d& direction, double height) {
    return Eigen::Vector3d(cylinder.axis_point + height * cylinder.axis_direction +
                           cylinder.radius * direction);
  };
  PlanePatch facet;
  const Eigen::Vector3d outward = (first + second).normalized();
  const double side = cylinder.is_hollow ? -1 : 1;
  const double middle = (cylinder.low + cylinder.high) / 2;
  facet.center = (corner(first, middle) + corner(second, middle)) / 2;
  facet.axis_v = cylinder.axis_direction;
  facet.axis_u = facet.axis_v.cross(side * outward);
  facet.coefficients << side * outward, -side * outward.dot(facet.center);
  facet.area =
      cylinder.radius * (second - first).norm() * (cylinder.high - cylinder.low);
  PlanePolygon& polygon = facet.polygons.emplace_back();
  polygon.outer = {corner(first, cylinder.low).cast<float>(),
                   corner(second, cylinder.low).cast<float>(),
                   corner(second, cylinder.high).cast<float>(),
                   corner(first, cylinder.high).cast<float>()};
  if (cylinder.is_hollow)
    std::reverse(polygon.outer.begin(), polygon.outer.end());
  return facet;
}

bool
isFinite(const PlanePatch& facet)
{
  const auto& outer = facet.polygons[0].outer;
  return facet.coefficients.allFinite() &&
         std::all_of(outer.begin(), outer.end(), [](const Eigen::Vector3f& corner) {
           return corner.allFinite();
         });
}

} // namespace

std::vector<PlanePatch>
facetsOfCylinder(const CylinderPatch& cylinder, double tolerance)
{
  acmap::requireInRange("tolerance", tolerance, 1e-9, 1e9, "m");
  std::vector<PlanePatch> facets;
  if (!(cylinder.radius > 0) || !(cylinder.high > cylinder.low) || !(cylinder.arc > 0))
    return facets;
  const std::vector<Eigen::Vector3d> directions =
      directionsOf(cylinder, numberOfFacets(cylinder, tolerance));
  for (std::size_t i = 1; i < directions.size(); ++i)
    facets.push_back(facetBetween(cylinder, directions[i - 1], directions[i]));
  if (!std::all_of(facets.begin(), facets.end(), isFinite))
    facets.clear();
  return facets;
}

std::array<Eigen::Vector2d, 4>
unrolledCorners(const CylinderPatch& cylinder, std::size_t facet, std::size_t facets)
{
  const double left = static_cast<double>(facet) / static_cast<double>(facets);
  const double right = static_cast<double>(facet + 1) / static_cast<double>(facets);
  if (cylinder
          .is_hollow) // its polygons begin at the top, and angles ascend to the left
    return {{{1 - left, 0}, {1 - right, 0}, {1 - right, 1}, {1 - left, 1}}};
  return {{{left, 1}, {right, 1}, {right, 0}, {left, 0}}};
}

} // namespace pcl
