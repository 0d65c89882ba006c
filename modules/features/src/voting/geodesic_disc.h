#pragma once

#include "voting/vertex_rings.h"

namespace pcl::acmap::voting {

/** The vertices within a geodesic distance, computed by shortest paths along edges. An
 * object is created once per thread and filled again for each vertex, without resetting
 * the marks of other vertices. */
class GeodesicDisc {
public:
  GeodesicDisc(const VertexRings& rings, std::size_t vertices)
  : rings_(rings)
  , marks_(vertices)
  {}

  void
  fill(std::int32_t middle, float radius);

  /** In the order in which they were reached. */
  const std::vector<std::int32_t>&
  vertices() const
  {
    return vertices_;
  }

  bool
  contains(std::int32_t vertex) const
  {
    return marks_[static_cast<std::size_t>(vertex)].round == round_;
  }

  /** Geodesic distance in metres from the middle, of a vertex in the disc. */
  float
  distance(std::int32_t vertex) const
  {
    return marks_[static_cast<std::size_t>(vertex)].distance;
  }

private:
  struct Mark {
    float distance = 0;
    std::uint32_t round = 0; ///< in which it was last reached
  };

  const VertexRings& rings_;
  std::vector<Mark> marks_;
  std::vector<std::int32_t> vertices_;
  std::vector<std::int32_t> wave_, next_wave_;
  std::uint32_t round_ = 0;
};

} // namespace pcl::acmap::voting
