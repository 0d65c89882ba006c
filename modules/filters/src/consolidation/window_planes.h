#pragma once

#include "consolidation/surface_fit.h"

#include <pcl/core/impl/voxel_windows.h>

namespace pcl::acmap {

/** \brief If a window is thicker than the noise by this factor, it contains several
 * planes. */
inline constexpr double thick_factor = 2;

SurfaceFit
toSurfaceFit(const PlaneFit& fit);

/** \brief Thickness of the plane of a window, and range and height of its sensors. */
PlaneNoise
noiseOf(const VoxelMoments& voxels,
        const std::vector<WindowPart>& parts,
        const Eigen::Vector3f& normal,
        float thickness);

/** \brief Is the plane of the wider window the same as that of the inner one, with more
 * points? */
bool
isSamePlane(const PlaneFit& wide, const PlaneFit& inner);

/** \brief The plane of those parts of 5 x 5 x 5 voxels that a predicate selects, or of
 * the inner 3 x 3 x 3 of them if the outer ones are on another plane. */
template <typename Choose>
PlaneFit
widestPlane(const VoxelMoments& voxels,
            const std::vector<WindowPart>& parts,
            const Choose& choose)
{
  Moments inner, wide;
  for (const WindowPart& part : parts)
    if (choose(part))
      (part.isInner() ? inner : wide)
          .addShifted(voxels.cells[part.cell].moments, part.dx, part.dy, part.dz);
  wide += inner;
  if (wide.count < 1)
    return {};
  const PlaneFit wide_fit = fitPlane(wide);
  if (inner.count < 1)
    return wide_fit;
  const PlaneFit inner_fit = fitPlane(inner);
  return isSamePlane(wide_fit, inner_fit) ? wide_fit : inner_fit;
}

/** \brief Replaces the plane of an inner window by that of the whole window if this is
 * not thicker than the noise: the outer part of a slab of noisy points has a tilted
 * plane if it is fitted alone. */
void
widenWithinNoise(const VoxelMoments& voxels,
                 const std::vector<WindowPart>& parts,
                 const NoiseProfile& noise,
                 SurfaceFit& fit);

/** \brief The one or two sides from which a voxel was seen, each with its own plane. */
struct SidesOfVoxel {
  bool found = false;
  SurfaceFit first;
  bool has_second = false;
  SurfaceFit second;
};

/** \brief Tries to split a thick window by the directions to its sensors, along each
 * axis.
 * \param[in] whole the plane of the whole window */
SidesOfVoxel
separateSides(const VoxelMoments& voxels,
              const std::vector<WindowPart>& parts,
              const NoiseProfile& noise,
              const SurfaceFit& whole);

/** \brief Replaces the plane of a thick window by that of the flattest of the eight
 * windows of 2 x 2 x 2 voxels, or of the voxel alone, if it is much thinner.
 * \return true if it was replaced */
bool
narrowPlane(const VoxelMoments& voxels,
            const std::vector<WindowPart>& parts,
            const NoiseProfile& noise,
            SurfaceFit& fit);

} // namespace pcl::acmap
