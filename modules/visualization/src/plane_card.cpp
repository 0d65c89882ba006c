#include <pcl/visualization/plane_card.h>

#include "map_faces.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/surface_sentence.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace pcl {
namespace {

template <typename... Values>
std::string
format(const char* form, Values... values)
{
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), form, values...);
  return text.data();
}

/** \brief A number with its unit, or a remark that it is unknown. */
std::string
known(const char* form, double value)
{
  return std::isfinite(value) ? format(form, value) : "unknown";
}

/** \brief A length of a box or a recess, with its standard deviation. */
template <typename Patch>
std::string
sizeOf(const Patch& patch, Eigen::Index axis)
{
  return format("%.3f m (deviation ", patch.size[axis]) +
         known("%.3g mm", 1000 * std::sqrt(patch.covariance(6 + axis, 6 + axis))) + ")";
}

std::string
deviations(const Eigen::Matrix3d& covariance)
{
  constexpr double degrees = 180 / M_PI;
  const Eigen::Vector3d deviation = covariance.diagonal().cwiseSqrt();
  return "slopes " + known("%.3g deg", deviation[0] * degrees) + " and " +
         known("%.3g deg", deviation[1] * degrees) + ", offset " +
         known("%.3g mm", deviation[2] * 1000);
}

} // namespace

std::string
planeCard(const CompactMap& map, std::size_t number)
{
  const std::string sentence = describePlane(map, number);
  const PlanePatch& plane = map.planes[number];
  const Eigen::Vector4d& c = plane.coefficients;
  std::string support = format("%zu points", plane.support);
  if (plane.effective_support > 0 && std::isfinite(plane.effective_support))
    support += format(", %.0f of them independent", plane.effective_support);
  return sentence + format("\nplane %zu\n", number) +
         format(
             "equation   %.5f x %+.5f y %+.5f z %+.4f = 0\n", c[0], c[1], c[2], c[3]) +
         "deviation  " + deviations(plane.covariance) + "\nsupport    " + support +
         "\n";
}

std::string
cylinderCard(const CompactMap& map, std::size_t number)
{
  constexpr double degrees = 180 / M_PI;
  const std::string sentence = describeCylinder(map, number);
  const CylinderPatch& cylinder = map.cylinders[number];
  return sentence +
         format(
             "\ncylinder %zu, %s\n", number, cylinder.is_hollow ? "hollow" : "solid") +
         format("radius     %.4f m, deviation ", cylinder.radius) +
         known("%.3g mm", 1000 * std::sqrt(cylinder.covariance(4, 4))) +
         format("\nextent     %.3f m, %.0f deg of arc\n",
                cylinder.high - cylinder.low,
                degrees * cylinder.arc) +
         format("support    %zu points\n", cylinder.support) +
         format("area       %.4g m2\n", cylinder.area) +
         format("saved      %.0f bits\n", cylinder.saved_bits);
}

std::string
boxCard(const BoxPatch& box, std::size_t number)
{
  std::array<std::size_t, 4> sides{}; // of each kind
  for (const BoxFace& face : box.faces)
    ++sides[static_cast<std::size_t>(face.kind)];
  return format("box %zu, template %d\n", number, box.template_id) + "size       " +
         sizeOf(box, 0) + ", " + sizeOf(box, 1) + ", " + sizeOf(box, 2) +
         format("\nsides      %zu seen, %zu on another plane, %zu not seen",
                sides[static_cast<std::size_t>(BoxFaceKind::Seen)],
                sides[static_cast<std::size_t>(BoxFaceKind::Snapped)],
                sides[static_cast<std::size_t>(BoxFaceKind::Free)]) +
         (box.slant.isZero(0) ? "" : ", one slanted") +
         format("\nsaved      %.0f bits\n", box.saved_bits);
}

std::string
recessCard(const RecessPatch& recess, std::size_t number)
{
  return format("recess %zu, template %d\n", number, recess.template_id) +
         "width      " + sizeOf(recess, 0) + "\nheight     " + sizeOf(recess, 1) +
         "\ndepth      " + sizeOf(recess, 2) +
         format("\nplanes     %d behind %d, %s\n",
                recess.leaf,
                recess.wall,
                recess.reaches_floor ? "down to the floor" : "above the floor") +
         format("saved      %.0f bits\n", recess.saved_bits);
}

std::optional<std::size_t>
planeOnRay(const CompactMap& map,
           const Eigen::Vector3d& eye,
           const Eigen::Vector3d& direction,
           bool fronts_only)
{
  if (!eye.allFinite() || !direction.allFinite() || direction.norm() == 0)
    throw acmap::BadArgument("a ray has to begin somewhere and lead somewhere");
  const auto hit = acmap::firstHit(acmap::facesOf(map), eye, direction, fronts_only);
  if (!hit || hit->plane >= map.planes.size())
    return {};
  return hit->plane;
}

} // namespace pcl
