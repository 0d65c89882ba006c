#pragma once

#include "voting/geodesic_disc.h"

#include <pcl/features/impl/voting_kernel.h>

namespace pcl::acmap::voting {

/** Second pass of Page et al.: the vertices of a disc vote for the curvature along
 * their direction. The result is NaN if the vertex is not of class Surface. Use one
 * object per thread. */
class CurvatureVoter {
public:
  CurvatureVoter(const PointView& points,
                 const VertexRings& rings,
                 const LargeVector<VotedNormal>& normals,
                 double radius);

  VotedCurvature
  vote(std::int32_t vertex);

private:
  const PointView& points_;
  const LargeVector<VotedNormal>& normals_;
  float radius_;
  GeodesicDisc disc_;
};

} // namespace pcl::acmap::voting
