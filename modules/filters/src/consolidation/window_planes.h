#pragma once

#include "consolidation/surface_fit.h"

#include <pcl/core/voxel_windows.h>

namespace pcl::acmap {

/** \brief A window this many times as thick as the noise holds more than one plane. */
inline constexpr double thick_factor = 2;

SurfaceFit
toSurfaceFit(const PlaneFit& fit);

/** \brief How thick a plane through a window is, and from where its points were seen. */
PlaneNoise
noiseOf(const VoxelMoments& voxels,
        const std::vector<WindowPart>& parts,
        const Eigen::Vector3f& normal,
        float thickness);

/** \brief Is the plane through the wider window that through the inner one, with more
 * points? */
bool
isSamePlane(const PlaneFit& wide, const PlaneFit& inner);

/** \brief The plane through the parts of 5 x 5 x 5 voxels that a predicate chooses, or
 * through the inner 3 x 3 x 3 of them where the wider ones lie on another. */
template <typename Choose>
PlaneFit
widestPlane(const VoxelMoments& voxels,
            const std::vector<WindowPart>& parts,
            const Choose& choose)
{
  const Moments inner = sumParts(voxels, parts, [&](const WindowPart& part) {
    return part.isInner() && choose(part);
  });
  Moments wide = sumParts(voxels, parts, [&](const WindowPart& part) {
    return !part.isInner() && choose(part);
  });
  wide += inner;
  if (wide.count < 1)
    return {};
  const PlaneFit wide_fit = fitPlane(wide);
  if (inner.count < 1)
    return wide_fit;
  const PlaneFit inner_fit = fitPlane(inner);
  return isSamePlane(wide_fit, inner_fit) ? wide_fit : inner_fit;
}

/** \brief Replaces the plane of an inner window by that of the whole one where this is no
 * thicker than the noise: the tail of a slab, seen alone, has a tilted plane of its own. */
void
widenWithinNoise(const VoxelMoments& voxels,
                 const std::vector<WindowPart>& parts,
                 const NoiseProfile& noise,
                 SurfaceFit& fit);

/** \brief The one or two sides on which a voxel was seen, each with its own plane. */
struct SidesOfVoxel {
  bool found = false;
  SurfaceFit first;
  bool has_second = false;
  SurfaceFit second;
};

/** \brief Tries to split a thick window by where its sensors stood, along each axis.
 * \param[in] whole the plane through all of it */
SidesOfVoxel
separateSides(const VoxelMoments& voxels,
              const std::vector<WindowPart>& parts,
              const NoiseProfile& noise,
              const SurfaceFit& whole);

/** \brief Replaces a thick plane by that through the flattest of the eight windows of
 * 2 x 2 x 2 voxels, or through the voxel alone, where these are much thinner. */
bool
narrowPlane(const VoxelMoments& voxels,
            const std::vector<WindowPart>& parts,
            const NoiseProfile& noise,
            SurfaceFit& fit);

} // namespace pcl::acmap
