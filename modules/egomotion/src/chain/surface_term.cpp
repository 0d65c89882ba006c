#include "chain/surface_term.h"

#include <pcl/core/impl/parallel.h>

#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double min_cosine = 0.9; // between normals of the same surface

void
addPair(const SurfaceBlock& source,
        const SurfaceBlock& target,
        const Eigen::Vector3d& point,
        double reach,
        std::size_t tile,
        SurfaceTerm& term)
{
  const double distance = target.normal.dot(point - target.center);
  if (std::abs(distance) > reach)
    return;
  const double variance = source.variance + target.variance;
  const double squared = distance * distance / variance;
  const double weight = robustWeight(squared) / variance;
  term.evidence.add(tile, motionRow(point, target.normal), distance, weight);
  term.evidence.tell(squared);
  term.squares += weight * distance * distance;
  term.weights += weight;
}

} // namespace

SurfaceTerm
surfaceTerm(const SurfaceBlocks& source,
            const SurfaceBlocks& target,
            const Pinhole& target_pinhole,
            const Eigen::Isometry3d& T_target_source,
            double reach)
{
  const auto ofChunk = [&](std::size_t begin, std::size_t end) {
    SurfaceTerm term;
    for (std::size_t i = begin; i < end; ++i) {
      const SurfaceBlock& block = source.blocks[i];
      if (!block.isPlane())
        continue;
      const Eigen::Vector3d point = T_target_source * block.point;
      if (point.z() <= 0)
        continue;
      const SurfaceBlock* other = target.at(target_pinhole.project(point));
      if (other && other->isPlane() &&
          other->normal.dot(T_target_source.linear() * block.normal) > min_cosine)
        addPair(block, *other, point, reach, tileOf(target_pinhole, point), term);
    }
    return term;
  };
  return parallelReduceChunks(source.blocks.size(),
                              SurfaceTerm{},
                              ofChunk,
                              [](SurfaceTerm& sum, const SurfaceTerm& term) {
                                sum.evidence.add(term.evidence);
                                sum.squares += term.squares;
                                sum.weights += term.weights;
                              });
}

} // namespace pcl::acmap
