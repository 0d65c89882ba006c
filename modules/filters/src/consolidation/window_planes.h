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

/** \brief The plane of a window, or of its inner part if the outer one is on another
 * plane.
 * \param[in] inner sums over the inner 3 x 3 x 3 voxels
 * \param[in] whole over all of them */
PlaneFit
widestPlane(const Moments& inner, const Moments& whole);

/** \brief The same for those parts of 5 x 5 x 5 voxels that a predicate selects. */
template <typename Choose>
PlaneFit
widestPlane(const VoxelMoments& voxels,
            const std::vector<WindowPart>& parts,
            const Choose& choose)
{
  Moments inner, whole;
  for (const WindowPart& part : parts)
    if (choose(part))
      (part.isInner() ? inner : whole)
          .addShifted(voxels.cells[part.cell].moments, part.dx, part.dy, part.dz);
  whole += inner;
  return widestPlane(inner, whole);
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
