#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/cloud_assessment_types.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/cylinder_patch.h>
#include <pcl/core/fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/recess_patch.h>
#include <pcl/core/report.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_evidence.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/features/voting_types.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/filters/depth_refinement_types.h>
#include <pcl/segmentation/box_fitting_types.h>
#include <pcl/segmentation/cylinder_clustering_types.h>
#include <pcl/segmentation/depth_plane_types.h>
#include <pcl/segmentation/plane_clustering_types.h>
#include <pcl/segmentation/recess_fitting_types.h>
#include <pcl/surface/dewall_types.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {

/** \brief How PlaneMapping and CompactMapping compute their result. \ingroup pipeline */
enum class MappingMode {
  Accurate, ///< with all that acmap adds to the paper
  Paper     ///< every step as the paper has it, with nothing added
};

namespace acmap {

/** \brief The names of \ref MappingMode in files and in Python. */
inline constexpr std::array<const char*, 2> mapping_mode_names{"accurate", "paper"};

} // namespace acmap

/** \brief Which clouds PlaneMapping consolidates. \ingroup pipeline */
enum class ConsolidationPolicy {
  WhereNoisy, ///< those whose noise is large compared with their spacing
  Always,     ///< all, also organized views
  Never       ///< none: raw points are triangulated in space, also those of one view
};

/** \brief Planes of a cloud, and the mesh on which they were found.
 *
 * \ingroup pipeline */
struct MappedPlanes {
  std::vector<PlanePatch> planes; ///< in the order of decreasing area
  PointLabels labels;             ///< plane of each input point, -1 for none
  std::size_t finite_points = 0;  ///< of the input; in a picture, those with depth

  /** \brief Vertices of the mesh with all fields of the input: the consolidated cloud,
   * or the input itself. No cloud if no mesh was made. */
  CloudRows vertices;
  TriangleMesh mesh;
  double spacing = 0; ///< between neighbouring vertices, metres; 0 without a mesh
  PointLabels vertex_labels; ///< plane of each vertex, -1 for none

  /** \brief From normal voting, one row per vertex: float32 fields normal_x, normal_y,
   * normal_z, curvature, and uint8 vertex_class, which is a \ref VertexClass. */
  CloudRows normals;

  /** \brief Pose of the sensor of the input; metres, in the frame of the cloud. */
  Eigen::Vector3f sensor_origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  /** \brief Up direction of the input, if it is known: stated, or found. */
  std::optional<Eigen::Vector3f> up;

  /** \brief The direction that is taken for it otherwise, of length 1; zero if the cloud was
   * not asked. */
  Eigen::Vector3f assumed_up = Eigen::Vector3f::Zero();

  /** \brief Columns, pipes and curved walls, in the order of decreasing area, if
   * \ref PlaneMapping::setComputeCylinders was called. The planes for which they stand
   * are not among the planes. */
  std::vector<CylinderPatch> cylinders;
  PointLabels cylinder_labels;  ///< cylinder of each input point, or -1
  PointLabels vertex_cylinders; ///< the same for each vertex

  /** \brief Furniture, crates and pillars, in the order of decreasing volume, if
   * \ref PlaneMapping::setComputeBoxes was called. Their sides are among the planes. */
  std::vector<BoxPatch> boxes;

  /** \brief Closed doors, windows and niches, in the same order, if boxes were searched.
   * Their walls and leaves are among the planes. */
  std::vector<RecessPatch> recesses;
};

/** \brief Report of PlaneMapping on its last run; steps that did not run have no
 * report.
 * \ingroup pipeline */
struct PlaneMappingReport : Report {
  MappingMode mode = MappingMode::Accurate; ///< as \ref PlaneMapping::setMode set it
  std::size_t consolidated_points = 0; ///< on which planes were found; 0: on raw points
  /** \brief What the input is; none if the sensors of its observations are known, which are
   * then in its field `view`. In a picture neither noise nor surfaces are asked. */
  std::optional<CloudAssessmentReport> assessment;
  std::optional<NoiseScale> noise_scale; ///< of a cloud in space
  std::optional<ConsolidationReport> consolidation;
  std::optional<DepthPlaneReport> depth_planes; ///< if planes were found in a picture
  std::optional<DepthRefinementReport> refinement; ///< the same, with a mesh
  std::optional<DeWallReport> mesh;
  std::optional<VotingReport> votes;
  std::optional<PlaneClusteringReport> planes;       ///< if planes were found in space
  std::optional<CylinderClusteringReport> cylinders; ///< if they were searched
  std::optional<BoxFittingReport> boxes;             ///< the same
  std::optional<RecessFittingReport> recesses;       ///< the same, with the boxes
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PlaneMappingReport& report, Visitor&& visit)
{
  visit({"mode"}, acmap::Named{report.mode, acmap::mapping_mode_names});
  visit({"consolidated_points"}, report.consolidated_points);
  visit({"assessment"}, report.assessment);
  visit({"noise_scale"}, report.noise_scale);
  visit({"consolidation"}, report.consolidation);
  visit({"depth_planes"}, report.depth_planes);
  visit({"refinement"}, report.refinement);
  visit({"mesh"}, report.mesh);
  visit({"votes"}, report.votes);
  visit({"planes"}, report.planes);
  visit({"cylinders"}, report.cylinders);
  visit({"boxes"}, report.boxes);
  visit({"recesses"}, report.recesses);
}

} // namespace pcl
