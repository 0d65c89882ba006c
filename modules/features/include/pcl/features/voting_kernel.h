#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/features/voting_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref voteNormals; see NormalVectorVoting. */
struct VotingSettings {
  double radius = 0;          ///< metres along the surface; 0: automatic
  double crease_weight = 12;  ///< eps
  double corner_weight = 0.3; ///< eta
  bool compute_curvatures = false;
  unsigned threads = 0; ///< 0: all
};

/** \brief Principal curvatures at a vertex, 1/m, the larger one by magnitude first. */
struct VotedCurvature {
  Eigen::Vector3f direction; ///< unit, of the first one
  float first = 0;
  float second = 0;
};

/** \brief The votes' outcome at a vertex. */
struct VotedNormal {
  Eigen::Vector3f normal;    ///< unit; NaN for VertexClass::Unknown
  Eigen::Vector3f direction; ///< unit, e3: along the crease; NaN as the normal
  float saliency = 0;        ///< (l1 - l2) / (l1 + l2 + l3); NaN as the normal

  VertexClass vertex_class = VertexClass::Unknown;
};

struct VotedNormals {
  std::vector<VotedNormal> normals;       ///< one a vertex
  std::vector<VotedCurvature> curvatures; ///< the same, where asked for
};

/** \brief The kernel behind NormalVectorVoting, free of PCL's point types.
 * \param[in] points the vertices: the whole array under the triangles
 * \param[in] triangles whose corners lie inside of the array
 * \param[in] sensors towards which the normals are turned; unknown: as the faces
 * \param[out] report counts, seconds, remarks; begun anew
 * \throws CancelledException when the progress was told to stop \ingroup features */
ACMAP_EXPORT VotedNormals
voteNormals(const PointView& points,
            const std::vector<TriangleMesh::Triangle>& triangles,
            const SensorView& sensors,
            const VotingSettings& settings,
            const Progress& progress,
            VotingReport& report);

} // namespace pcl::acmap
