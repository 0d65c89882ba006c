#include "planes/plane_region.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::planes {
namespace {

constexpr double first_fit = 12; // members; before that the seed's normal is better
constexpr double refit_growth = 1.2;

} // namespace

Plane
planeThrough(const PlaneFit& fit, const Eigen::Vector3d& front)
{
  Plane plane;
  plane.normal = fit.normal.dot(front) < 0 ? Eigen::Vector3d(-fit.normal) : fit.normal;
  plane.offset = -plane.normal.dot(fit.mean);
  return plane;
}

PlaneRegion::PlaneRegion(const CellGraph& graph,
                         const PlaneLimits& limits,
                         std::size_t seed)
: graph_(&graph)
, limits_(limits)
, distance_(limits.distance)
, refit_at_(first_fit)
{
  plane_.normal = graph.normals[seed].cast<double>().normalized();
  plane_.offset = -plane_.normal.dot(graph.points[seed]);
}

void
PlaneRegion::add(std::size_t i)
{
  moments_ += momentsOf(graph_->points[i]);
  if (moments_.count < refit_at_)
    return;
  refit();
  refit_at_ = moments_.count * refit_growth;
}

void
PlaneRegion::setMembers(const std::vector<std::int32_t>& members)
{
  moments_ = {};
  for (const std::int32_t member : members)
    moments_ += momentsOf(graph_->points[static_cast<std::size_t>(member)]);
  refit();
}

void
PlaneRegion::refit()
{
  const PlaneFit fit = fitPlane(moments_);
  if (!fit.isPlanar())
    return;
  plane_ = planeThrough(fit, plane_.normal);
  const double extent = std::sqrt(12 * fit.variances[2]);
  distance_ =
      std::max(limits_.distance, std::min(limits_.bow * extent, limits_.max_bow));
}

} // namespace pcl::acmap::planes
