#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/progress.h>
#include <pcl/core/report.h>
#include <pcl/core/sensor_evidence.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/core/up_evidence.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/filters/depth_refinement_types.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/depth_sensor.h>
#include <pcl/surface/dewall_triangulation.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl {

/** \brief How a cloud becomes a mesh. \ingroup pipeline */
struct CloudMeshing {
  DeWallTriangulation<PCLPointCloud2> triangulation; ///< without a cloud
  /** \brief Is the noise taken out first? The steps of a depth camera's view are taken out in
   * its picture, other clouds are consolidated. */
  bool consolidates = false;
  /** \brief Without a cloud. A size of its voxels consolidates views of depth cameras, too. */
  VoxelConsolidation<PCLPointCloud2> consolidation;
  DepthSensor sensor = DepthSensor::Automatic;
  /** \brief Sensor of each observation that the field `view` of the cloud names, metres. */
  std::vector<Eigen::Vector3f> viewpoints;
  unsigned threads = 0; ///< 0 for all
  ProgressCallback progress;
  CostCallback cost; ///< gets the memory of the triangulation
};

/** \brief A cloud, as its mesh has it, and how that was made. \ingroup pipeline */
struct MeshedCloud {
  CloudRows vertices; ///< the cloud, consolidated if that was wanted
  TriangleMesh mesh;
  SensorEvidence sensor;                      ///< of a cloud without views
  UpEvidence up;                              ///< if there is no sensor
  std::optional<Eigen::Vector3d> tells_sides; ///< up, if free space told the sides
  bool names_views = false;                   ///< has the cloud a field `view`?
  bool shows_steps = false; ///< is its depth quantised, and nothing was taken out?
  std::optional<ConsolidationReport> consolidation;
  std::optional<DepthRefinementReport> refinement;
  DeWallReport triangulation;
  Report steps; ///< seconds: assess; refine or consolidate; triangulate
};

/** \brief Makes a mesh of any cloud: finds out what tells the sides of its surfaces (sensors,
 * or the up direction), takes out its noise if that is wanted, and triangulates it. Section
 * II-C.1 of "Active Stereo Based Compact Mapping".
 *
 * The edges of a consolidated cloud have at most \ref mesh_edge_in_voxels voxels, unless the
 * triangulation has a maximum of its own.
 * \code
 * pcl::CloudMeshing meshing;
 * meshing.consolidates = true;
 * pcl::PointCloudFile file;
 * pcl::CloudRows rows = pcl::PointCloudReader ().readRows ("scan.las", file);
 * const pcl::MeshedCloud made = pcl::meshCloud (std::move (rows), file, meshing);
 * pcl::saveTriangleMesh ("scan.ply", made.vertices, made.mesh);
 * \endcode
 * O(n log n) for n points.
 * \param[in] rows points, metres
 * \param[in] file what is known of them; its points are not used
 * \throws UnorganizedPointCloudException if the sensor requires a picture, and the cloud is
 * none
 * \throws CancelledException when the progress callback requests it, and what the callback for
 * the cost throws \ingroup pipeline */
ACMAP_EXPORT MeshedCloud
meshCloud(CloudRows rows, const PointCloudFile& file, const CloudMeshing& meshing);

} // namespace pcl
