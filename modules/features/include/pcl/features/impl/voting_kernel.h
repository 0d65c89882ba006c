#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/features/voting_types.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief eps and eta of Page et al. */
inline constexpr double page_weight = 2;

/** \brief Settings of \ref voteNormals; see NormalVectorVoting. */
struct VotingSettings {
  double radius = 0;                   ///< geodesic radius, metres; 0: automatic
  std::optional<double> crease_weight; ///< eps; none: 12, with paper 2
  std::optional<double> corner_weight; ///< eta; none: 0.3, with paper 2
  bool paper = false; ///< weights and votes of Page et al., without ours
  bool compute_curvatures = false;
  unsigned threads = 0; ///< 0: all

  double
  creaseWeight() const
  {
    return crease_weight.value_or(paper ? page_weight : 12);
  }

  double
  cornerWeight() const
  {
    return corner_weight.value_or(paper ? page_weight : 0.3);
  }
};

/** \brief Principal curvatures at a vertex, 1/m; the first one has the larger
 * magnitude. */
struct VotedCurvature {
  Eigen::Vector3f direction; ///< unit, of the first curvature
  float first = 0;
  float second = 0;
};

/** \brief Result of the votes at a vertex. */
struct VotedNormal {
  Eigen::Vector3f normal;    ///< unit; NaN for VertexClass::Unknown
  Eigen::Vector3f direction; ///< unit, e3: along the crease; NaN if unknown
  float saliency = 0;        ///< (l1 - l2) / (l1 + l2 + l3); NaN if unknown
  std::uint32_t votes = 0;   ///< number of triangles that voted, 0 if unknown

  VertexClass vertex_class = VertexClass::Unknown;
};

struct VotedNormals {
  LargeVector<VotedNormal> normals;       ///< one per vertex
  std::vector<VotedCurvature> curvatures; ///< one per vertex, if requested
};

/** \brief Implementation of NormalVectorVoting, independent of PCL's point types.
 * \param[in] points the vertices: the whole array that the triangles index
 * \param[in] triangles whose corners are inside of the array
 * \param[in] sensors positions to which the normals are oriented; if unknown, the
 * normals are oriented as the faces
 * \param[out] report counts, seconds, remarks; reset at the start
 * \throws CancelledException when the progress callback requested it \ingroup features
 */
ACMAP_EXPORT VotedNormals
voteNormals(const PointView& points,
            const TriangleMesh::Triangles& triangles,
            const SensorView& sensors,
            const VotingSettings& settings,
            const Progress& progress,
            VotingReport& report);

} // namespace pcl::acmap
