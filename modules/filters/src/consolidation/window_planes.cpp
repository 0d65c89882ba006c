#include "consolidation/window_planes.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double enough_points = 6;

/** Is the normal defined, i.e. are the points not on a line or at one position? */
bool
isSurface(const PlaneFit& fit)
{
  // ratio of variances; its square is the minimum variance in edges^2
  constexpr double min_width = 1e-3;
  return fit.count >= 3 && fit.variances[1] > min_width * fit.variances[2] &&
         fit.variances[1] > min_width * min_width;
}

unsigned
bitOf(const VoxelMoments& voxels, const WindowPart& part, unsigned bit)
{
  return octantOf(voxels.cells[part.cell].key) & bit;
}

double
pointsOfMiddle(const VoxelMoments& voxels,
               const std::vector<WindowPart>& parts,
               unsigned bit,
               unsigned value)
{
  double count = 0;
  for (const WindowPart& part : parts)
    if (part.isMiddle() && bitOf(voxels, part, bit) == value)
      count += voxels.cells[part.cell].moments.count;
  return count;
}

std::uint8_t
octantsWith(unsigned bit, unsigned value)
{
  std::uint8_t octants = 0;
  for (unsigned octant = 0; octant < 8; ++octant)
    if ((octant & bit) == value)
      octants = static_cast<std::uint8_t>(octants | 1u << octant);
  return octants;
}

SurfaceFit
fitSide(const VoxelMoments& voxels,
        const std::vector<WindowPart>& parts,
        unsigned bit,
        unsigned value)
{
  SurfaceFit side =
      toSurfaceFit(widestPlane(voxels, parts, [&](const WindowPart& part) {
        return bitOf(voxels, part, bit) == value;
      }));
  side.octants = octantsWith(bit, value);
  return side;
}

} // namespace

SurfaceFit
toSurfaceFit(const PlaneFit& fit)
{
  SurfaceFit surface;
  surface.mean = fit.mean.cast<float>();
  surface.count = static_cast<float>(fit.count);
  if (!isSurface(fit))
    return surface;
  surface.normal = fit.normal.cast<float>();
  surface.thickness = static_cast<float>(fit.thickness());
  surface.curvature = static_cast<float>(fit.variances[0] / fit.variances.sum());
  return surface;
}

bool
isSamePlane(const PlaneFit& wide, const PlaneFit& inner)
{
  if (inner.count < enough_points || !isSurface(inner))
    return true;
  constexpr double min_cosine = 0.95;
  if (std::abs(wide.normal.dot(inner.normal)) < min_cosine)
    return false;
  // the thickness of a few points is uncertain
  const double slack = 1.22 * (1 + 2 / std::sqrt(inner.count));
  return wide.thickness() < slack * inner.thickness();
}

PlaneNoise
noiseOf(const VoxelMoments& voxels,
        const std::vector<WindowPart>& parts,
        const Eigen::Vector3f& normal,
        float thickness)
{
  double count = 0, range_square = 0, height_square = 0;
  for (const WindowPart& part : parts) {
    const VoxelCell& cell = voxels.cells[part.cell];
    const double height = cell.way.dot(normal);
    count += cell.moments.count;
    range_square += cell.moments.count * static_cast<double>(cell.way.squaredNorm());
    height_square += cell.moments.count * height * height;
  }
  PlaneNoise noise;
  noise.thickness = thickness;
  noise.range = static_cast<float>(std::sqrt(range_square / count));
  if (!(noise.range > 0))
    return noise;
  // even at grazing incidence a part of the noise is across the plane
  constexpr float min_slant = 0.1f;
  noise.height = std::max(min_slant * noise.range,
                          static_cast<float>(std::sqrt(height_square / count)));
  return noise;
}

void
widenWithinNoise(const VoxelMoments& voxels,
                 const std::vector<WindowPart>& parts,
                 const NoiseProfile& noise,
                 SurfaceFit& fit)
{
  constexpr double slack = 1.3;
  const SurfaceFit whole = toSurfaceFit(
      fitPlane(sumParts(voxels, parts, [](const WindowPart&) { return true; })));
  const PlaneNoise seen = noiseOf(voxels, parts, whole.normal, whole.thickness);
  if (whole.normal.isZero() || whole.thickness > slack * noise.expectedThickness(seen))
    return;
  fit = whole;
  fit.noise = seen;
}

SidesOfVoxel
separateSides(const VoxelMoments& voxels,
              const std::vector<WindowPart>& parts,
              const NoiseProfile& noise,
              const SurfaceFit& whole)
{
  // thickness relative to the expected one
  const auto excess = [&](const SurfaceFit& side) {
    return side.thickness /
           noise.expectedThickness(noiseOf(voxels, parts, side.normal, side.thickness));
  };
  SidesOfVoxel best;
  double minimum = std::max(thick_factor, 0.6 * excess(whole));
  for (const unsigned bit : {4u, 2u, 1u}) {
    const double low = pointsOfMiddle(voxels, parts, bit, 0);
    const double high = pointsOfMiddle(voxels, parts, bit, bit);
    const unsigned main = high > low ? bit : 0;
    const SurfaceFit first = fitSide(voxels, parts, bit, main);
    if (first.count < enough_points || first.normal.isZero())
      continue;
    // a few points on the far side are outliers of the near side
    const bool both = std::min(low, high) >= enough_points / 2;
    const SurfaceFit second = fitSide(voxels, parts, bit, bit - main);
    const bool has_second =
        both && second.count >= enough_points && !second.normal.isZero();
    const double worst =
        has_second ? std::max(excess(first), excess(second)) : excess(first);
    if (first.count == whole.count || !(worst < minimum))
      continue;
    minimum = worst;
    best = {true, first, has_second, second};
  }
  return best;
}

bool
narrowPlane(const VoxelMoments& voxels,
            const std::vector<WindowPart>& parts,
            const NoiseProfile& noise,
            SurfaceFit& fit)
{
  PlaneFit best;
  double flattest = 1;
  const auto offer = [&](const Moments& sum) {
    if (sum.count < enough_points)
      return;
    const PlaneFit plane = fitPlane(sum);
    const double flatness = plane.variances[0] / plane.variances[1];
    if (isSurface(plane) && flatness < flattest) {
      best = plane;
      flattest = flatness;
    }
  };
  for (int corner = 0; corner < 8; ++corner)
    offer(sumParts(voxels, parts, [corner](const WindowPart& part) {
      const int dx = part.dx + (corner & 1);
      const int dy = part.dy + (corner >> 1 & 1);
      const int dz = part.dz + (corner >> 2);
      return (dx | dy | dz) >= 0 && dx <= 1 && dy <= 1 && dz <= 1;
    }));
  const auto expected = [&](const PlaneFit& plane) {
    return noise.expectedThickness(
        noiseOf(voxels, parts, plane.normal.cast<float>(), 0));
  };
  if (best.count > 0 && best.thickness() > thick_factor * expected(best))
    offer(sumParts(
        voxels, parts, [](const WindowPart& part) { return part.isMiddle(); }));
  if (best.count == 0 || best.thickness() > 0.7 * fit.thickness)
    return false;
  fit = toSurfaceFit(best);
  return true;
}

} // namespace pcl::acmap
