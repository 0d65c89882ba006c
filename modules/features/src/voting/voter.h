#pragma once

#include "voting/ballot.h"
#include "voting/geodesic_disc.h"

namespace pcl::acmap::voting {

/** The mesh as all voters see it. */
struct Electorate {
  const PointView& points;
  const std::vector<TriangleMesh::Triangle>& triangles;
  std::vector<Face> faces;
  VertexRings rings;

  Electorate(const PointView& points,
             const std::vector<TriangleMesh::Triangle>& triangles)
  : points(points)
  , triangles(triangles)
  , faces(facesOf(points, triangles))
  , rings(points, triangles, faces)
  {}
};

/** Lets the triangles around a vertex vote. One a thread. */
class Voter {
public:
  /** \param[in] radius g_max, metres
   * \param[in] nearest metres; in a slab a nearer triangle says nothing of the surface */
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
