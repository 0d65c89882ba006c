#include <pcl/core/patch_text.h>

#include <cmath>
#include <cstdio>

namespace pcl {

std::string
textOf(const PlanePatch& plane)
{
  // adding zero removes the sign of negative zeros
  const Eigen::Array3d n =
      (1000 * plane.coefficients.head<3>().array()).round() / 1000 + 0.0;
  char text[128];
  std::snprintf(text,
                sizeof text,
                "%.3g m2, rmse %.3g mm, normal %.3f %.3f %.3f",
                plane.area,
                1000 * plane.rms,
                n[0],
                n[1],
                n[2]);
  return text;
}

std::string
textOf(const CylinderPatch& cylinder)
{
  constexpr double degrees = 180 / M_PI;
  char text[160];
  std::snprintf(text,
                sizeof text,
                "radius %.3g m, %.3g m long, %.0f degrees of arc, %s, rmse %.3g mm, "
                "%.0f bits saved",
                cylinder.radius,
                cylinder.high - cylinder.low,
                degrees * cylinder.arc,
                cylinder.is_hollow ? "hollow" : "solid",
                1000 * cylinder.rms,
                cylinder.saved_bits);
  return text;
}

std::string
textOf(const BoxPatch& box)
{
  std::size_t seen = 0, snapped = 0;
  for (const BoxFace& face : box.faces) {
    seen += face.kind == BoxFaceKind::Seen ? 1 : 0;
    snapped += face.kind == BoxFaceKind::Snapped ? 1 : 0;
  }
  char text[160];
  std::snprintf(text,
                sizeof text,
                "%.3f x %.3f x %.3f m, %zu sides seen%s, %zu on other planes, "
                "template %d, %.0f bits saved",
                box.size[0],
                box.size[1],
                box.size[2],
                seen,
                box.slant.isZero(0) ? "" : " and a slanted one",
                snapped,
                box.template_id,
                box.saved_bits);
  return text;
}

std::string
textOf(const RecessPatch& recess)
{
  char text[160];
  std::snprintf(text,
                sizeof text,
                "%.3f x %.3f m, %.3f m deep, plane %d behind %d, %s, template %d, %.0f "
                "bits saved",
                recess.size[0],
                recess.size[1],
                recess.size[2],
                recess.leaf,
                recess.wall,
                recess.reaches_floor ? "reaches the floor" : "above the floor",
                recess.template_id,
                recess.saved_bits);
  return text;
}

} // namespace pcl
