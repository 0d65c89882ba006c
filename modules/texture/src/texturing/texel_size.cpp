#include "texturing/texel_size.h"

#include "texturing/canvas.h"

#include <pcl/core/impl/quantile.h>
#include <pcl/core/pinhole.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::acmap {

using namespace texturing;

namespace {

constexpr double finest = 0.003, coarsest_of_images = 0.03; // metres

/** Metres of a pixel on what is near in an image. */
double
footprintOf(const ColoredView& view, const Pinhole& camera)
{
  constexpr std::size_t most = 10000; // depths
  const std::size_t step = view.points.size() / most + 1;
  LargeVector<float> depths;
  for (std::size_t i = 0; i < view.points.size(); i += step)
    if (const float depth = view.points[i].z(); std::isfinite(depth))
      depths.push_back(depth);
  return static_cast<double>(valueOfRank(depths, depths.size() / 4)) / camera.fx;
}

/** Half the distance between the points from which the planes were fitted, metres. */
double
halfSpacingOn(const std::vector<PlanePatch>& planes)
{
  double area = 0, support = 0;
  for (const PlanePatch& plane : planes) {
    area += plane.area;
    support += static_cast<double>(plane.support);
  }
  constexpr double most = 10;
  const double half = support > 0 ? std::sqrt(area / support) / 2 : 0;
  return half > 0 && half < most ? half : paper_texel_size;
}

/** At most as many texels as are worth their time and memory where nobody asked for them. */
double
affordable(const std::vector<PlanePatch>& planes,
           const std::vector<CylinderPatch>& cylinders,
           double wanted)
{
  constexpr double max_texels = 1 << 23; // half a page
  constexpr double coarsest = 0.3;       // metres
  return boundedTexelSize(
      planes, cylinders, wanted, max_texels, std::max(16.0, coarsest / wanted));
}

} // namespace

double
texturing::legalTexelSize(const std::vector<PlanePatch>& planes,
                          const std::vector<CylinderPatch>& cylinders,
                          double wanted)
{
  constexpr double max_texels = 3 << 24;
  constexpr double max_enlargement = 16; // of a laser scan from the air
  return boundedTexelSize(planes, cylinders, wanted, max_texels, max_enlargement);
}

double
texturing::finestTexelSize(const std::vector<PlanePatch>& planes,
                           const std::vector<CylinderPatch>& cylinders)
{
  return affordable(planes, cylinders, finest);
}

double
automaticTexelSize(const std::vector<PlanePatch>& planes,
                   const std::vector<CylinderPatch>& cylinders,
                   const ColoredView& view)
{
  const std::optional<Pinhole> camera =
      fitUprightPinhole(view.points, static_cast<std::size_t>(view.width));
  const double wanted =
      camera ? std::clamp(footprintOf(view, *camera), finest, coarsest_of_images)
             : std::max(halfSpacingOn(planes), finest);
  return affordable(planes, cylinders, wanted);
}

} // namespace pcl::acmap
