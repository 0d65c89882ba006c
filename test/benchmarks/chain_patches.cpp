#include "chain_agreement.h"

#include "statistics.h"

#include <pcl/core/impl/moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace pcl::acmap::bench {
namespace {

using Cube = std::array<int, 3>;

constexpr double edge = 0.1; // metres

/** A piece of a surface in one view. */
struct ChainPatch {
  Eigen::Vector3d middle, normal;
};

/** The planar pieces in the cubes of a view, in the camera frame. */
std::vector<ChainPatch>
patchesOf(const ChainView& view)
{
  constexpr double fewest = 20;
  std::map<Cube, Moments> cubes;
  for (const Eigen::Vector3d& point : view.points) {
    const Eigen::Vector3i at = (point / edge).array().floor().cast<int>();
    cubes[{at.x(), at.y(), at.z()}] += momentsOf(point);
  }
  std::vector<ChainPatch> patches;
  for (const auto& [cube, moments] : cubes)
    if (const PlaneFit fit = fitPlane(moments);
        moments.count >= fewest && fit.isPlanar())
      patches.push_back({fit.mean, fit.normal});
  return patches;
}

/** Distance across the surface to the nearest one of other patches. */
std::optional<double>
apart(const ChainPatch& patch, const std::vector<ChainPatch>& others)
{
  constexpr double alike = 0.9659; // cosine of 15 degrees
  std::optional<double> found;
  double nearest = edge / 2;
  for (const ChainPatch& other : others) {
    const Eigen::Vector3d between = patch.middle - other.middle;
    const double across = other.normal.dot(between);
    const double along = (between - across * other.normal).norm();
    if (std::abs(across) < edge && along < nearest &&
        std::abs(other.normal.dot(patch.normal)) > alike) {
      nearest = along;
      found = std::abs(across);
    }
  }
  return found;
}

} // namespace

SurfaceAgreement
compareSurfaces(const std::vector<ChainView>& views,
                std::size_t step,
                Eigen::Isometry3d ChainView::*pose)
{
  std::vector<std::vector<ChainPatch>> patches;
  for (const ChainView& view : views)
    patches.push_back(patchesOf(view));
  std::vector<double> distances;
  for (std::size_t i = 0; i + step < views.size(); ++i) {
    const Eigen::Isometry3d motion =
        (views[i].*pose).inverse() * (views[i + step].*pose);
    for (const ChainPatch& patch : patches[i + step])
      if (const auto distance = apart(
              {motion * patch.middle, motion.linear() * patch.normal}, patches[i]))
        distances.push_back(*distance);
  }
  return {distances.size(), median(distances), quantile(distances, 0.9)};
}

} // namespace pcl::acmap::bench
