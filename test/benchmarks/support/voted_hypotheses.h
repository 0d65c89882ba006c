#pragma once

#include <pcl/features/impl/voting_kernel.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

namespace pcl::acmap::bench {

/** \brief Copies voted normals to hypotheses. */
inline void
addVotes(const VotedNormals& votes, PlaneHypotheses& hypotheses)
{
  for (const VotedNormal& voted : votes.normals) {
    hypotheses.normals.push_back(voted.normal);
    hypotheses.is_crease.push_back(voted.vertex_class >= VertexClass::Crease ? 1 : 0);
    hypotheses.curvatures.push_back(1 - voted.saliency);
  }
}

} // namespace pcl::acmap::bench
