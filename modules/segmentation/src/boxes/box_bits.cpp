#include "boxes/box_bits.h"

#include "description_length.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::boxes {

double
pointsOn(const PlanePatch& plane)
{
  const double effective = plane.effective_support;
  return std::max(
      1.0, std::isfinite(effective) ? effective : static_cast<double>(plane.support));
}

MapScale::MapScale(const std::vector<PlanePatch>& planes,
                   const std::vector<Piece>& pieces)
{
  constexpr double min_sigma = 0.0005; // metres, of planes without noise
  Eigen::AlignedBox3d box;
  double area = 0, sum = 0;
  for (const Piece& piece : pieces) {
    for (const Eigen::Vector3d& point : piece.loops.front())
      box.extend(point);
    const double rms = planes[piece.plane].rms;
    if (!std::isfinite(rms))
      continue;
    area += piece.area;
    sum += piece.area * rms * rms;
  }
  sigma = std::max(min_sigma, area > 0 ? std::sqrt(sum / area) : 0.0);
  extent = box.isEmpty() ? 0 : box.diagonal().norm();
}

void
measureBits(const std::vector<PlanePatch>& planes,
            const std::vector<Piece>& pieces,
            const MapScale& scale,
            std::size_t templates,
            bool is_instance,
            Box& box)
{
  constexpr double half_log2_of_e = 0.7213475204444817;
  // neither spacing nor free elements matter: the points stay on planes
  const DescriptionLength length(scale.sigma, scale.sigma, scale.extent);
  double points = 0, pose = 6, sizes = 3, choices = 0;
  box.bits_of_planes = 0;
  for (const Side& side : box.sides) {
    if (side.kind == BoxFaceKind::Seen || side.kind == BoxFaceKind::Slanted) {
      const double on_it = pointsOn(planes[static_cast<std::size_t>(side.plane)]);
      points += on_it;
      box.bits_of_planes += length.plane(on_it);
    }
    else if (side.kind == BoxFaceKind::Snapped) {
      choices += std::log2(static_cast<double>(pieces.size()));
      --sizes;
    }
    else
      choices += length.outline(1) / 2;
  }
  if (box.isSlanted()) { // which side it is, and two angles; its offset is a size
    choices += std::log2(static_cast<double>(box.sides.size()));
    pose += 2;
  }
  if (is_instance) {
    sizes = std::min(sizes, 0.0);
    choices += std::log2(static_cast<double>(std::max<std::size_t>(1, templates)));
  }
  const double own = DescriptionLength::label +
                     (pose + sizes) * length.parameter(points) + choices +
                     half_log2_of_e * box.misfit;
  box.saved_bits = box.bits_of_planes - own;
}

} // namespace pcl::acmap::boxes
