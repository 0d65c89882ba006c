#pragma once

#include "voting/ballot.h"
#include "voting/geodesic_disc.h"

namespace pcl::acmap::voting {

/** The mesh with its precomputed faces and rings, shared by all voters. */
struct Electorate {
  const PointView& points;
  const TriangleMesh::Triangles& triangles;
  LargeVector<Face> faces;
  VertexRings rings;

  Electorate(const PointView& points, const TriangleMesh::Triangles& triangles)
  : points(points)
  , triangles(triangles)
  , faces(facesOf(points, triangles))
  , rings(points, triangles, faces)
  {}
};

/** Collects the votes of the triangles around a vertex. Use one object per thread. */
class Voter {
public:
  /** \param[in] electorate the mesh
   * \param[in] radius g_max, metres
   * \param[in] nearest minimum distance of a triangle in metres: closer triangles in a
   * slab of noisy points do not describe the surface
   * \param[in] settings the weights */
  Voter(const Electorate& electorate,
        double radius,
        double nearest,
        const VotingSettings& settings);

  VotedNormal
  vote(std::int32_t vertex);

private:
  VotedNormal
  voteWithin(std::int32_t vertex, float radius);

  void
  shareOut(float radius);

  const Electorate& electorate_;
  const VotingSettings& settings_;
  float radius_;
  float squared_nearest_;
  GeodesicDisc disc_;
  std::vector<float> shares_; ///< exp (-g / g_max) of each vertex in the disc
};

} // namespace pcl::acmap::voting
