#include "cylinders/cylinder_templates.h"

#include "cylinders/cylinder_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::cylinders {
namespace {

/** A common radius, by information. */
struct Template {
  double information = 0; ///< 1 / m^2; 0 if the radius has no known uncertainty
  double weighted = 0;
  bool is_hollow = false;
  std::vector<std::size_t> patches;

  double
  radius() const
  {
    return weighted / information;
  }

  void
  add(const CylinderPatch& patch, std::size_t number)
  {
    const double variance = patch.covariance(4, 4);
    if (variance > 0) { // false for NaN
      information += 1 / variance;
      weighted += patch.radius / variance;
    }
    is_hollow = patch.is_hollow;
    patches.push_back(number);
  }
};

/** May the radius of a cylinder be that of a template? */
bool
isInstance(const CylinderPatch& patch, const Template& common)
{
  constexpr double sigmas = 2.576;            // 1 % of equal radii differ more
  constexpr double largest_difference = 0.02; // of the radius
  const double variance = patch.covariance(4, 4);
  if (!(variance > 0) || !(common.information > 0) ||
      patch.is_hollow != common.is_hollow)
    return false;
  const double difference = std::abs(patch.radius - common.radius());
  return difference < sigmas * std::sqrt(variance + 1 / common.information) &&
         difference < largest_difference * common.radius();
}

/** Changes a cylinder to a given radius, most where it is least known. */
void
setRadius(double radius, double variance, CylinderPatch& patch)
{
  const Vector5 with_radius = patch.covariance.col(4);
  const Vector5 gain = with_radius / patch.covariance(4, 4);
  const Vector5 shift = gain * (radius - patch.radius);
  const Eigen::Vector3d u = patch.axis_u, v = patch.axis_v;
  patch.axis_point += shift[0] * u + shift[1] * v;
  patch.axis_direction =
      (patch.axis_direction + shift[2] * u + shift[3] * v).normalized();
  patch.axis_u = (u - u.dot(patch.axis_direction) * patch.axis_direction).normalized();
  patch.axis_v = patch.axis_direction.cross(patch.axis_u);
  patch.area *= radius / patch.radius;
  patch.radius = radius;
  patch.covariance +=
      variance * gain * gain.transpose() - gain * with_radius.transpose();
}

} // namespace

std::size_t
shareRadii(std::vector<CylinderPatch>& patches)
{
  std::vector<Template> templates;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const auto found =
        std::find_if(templates.begin(), templates.end(), [&](const Template& common) {
          return isInstance(patches[i], common);
        });
    Template& common = found == templates.end() ? templates.emplace_back() : *found;
    patches[i].template_id = static_cast<std::int32_t>(&common - templates.data());
    common.add(patches[i], i);
  }
  for (const Template& common : templates)
    if (common.patches.size() > 1)
      for (const std::size_t patch : common.patches)
        setRadius(common.radius(), 1 / common.information, patches[patch]);
  return templates.size();
}

} // namespace pcl::acmap::cylinders
