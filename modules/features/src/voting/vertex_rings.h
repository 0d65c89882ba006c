#pragma once

#include <pcl/core/impl/point_view.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/triangle_mesh.h>

#include <cstdint>

namespace pcl::acmap::voting {

/** Contribution of a triangle to the votes. */
struct Face {
  Eigen::Vector3f normal; ///< unit
  /** \brief Centre relative to the first corner: accurate far from the origin. */
  Eigen::Vector3f center;
  float area = 0; ///< 0: it does not vote
};

LargeVector<Face>
facesOf(const PointView& points, const TriangleMesh::Triangles& triangles);

/** An edge as seen from one of its ends. */
struct Spoke {
  std::int32_t vertex; ///< the other end
  float length;        ///< metres
};

/** The edges at each vertex, and the triangles of which it is the first corner: each
 * triangle is in one list only. */
class VertexRings {
public:
  VertexRings(const PointView& points,
              const TriangleMesh::Triangles& triangles,
              const LargeVector<Face>& faces);

  struct Spokes {
    const Spoke* begin_;
    const Spoke* end_;
    const Spoke*
    begin() const
    {
      return begin_;
    }
    const Spoke*
    end() const
    {
      return end_;
    }
  };

  struct Triangles {
    const std::uint32_t* begin_;
    const std::uint32_t* end_;
    const std::uint32_t*
    begin() const
    {
      return begin_;
    }
    const std::uint32_t*
    end() const
    {
      return end_;
    }
  };

  Spokes
  spokes(std::int32_t vertex) const
  {
    const auto v = static_cast<std::size_t>(vertex);
    return {spokes_.data() + first_spoke_[v], spokes_.data() + first_spoke_[v + 1]};
  }

  Triangles
  triangles(std::int32_t vertex) const
  {
    const auto v = static_cast<std::size_t>(vertex);
    return {owned_.data() + first_owned_[v], owned_.data() + first_owned_[v + 1]};
  }

  /** Mean length of all edges, metres. */
  double
  meanEdge() const
  {
    return mean_edge_;
  }

private:
  LargeVector<std::size_t> first_spoke_, first_owned_;
  LargeVector<Spoke> spokes_;
  LargeVector<std::uint32_t> owned_;
  double mean_edge_ = 0;
};

} // namespace pcl::acmap::voting
