#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/file_of_cloud.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/depth_sensor.h>
#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/pipeline/ranks.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>
#include <pcl/segmentation/depth_plane_segmentation.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/surface/dewall_triangulation.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Finds the planes of a cloud: the steps II-C.1 and II-C.2 of "Active Stereo
 * Based Compact Mapping" in one call.
 *
 * A cloud in space is consolidated if its noise requires it (\ref VoxelConsolidation),
 * triangulated (\ref DeWallTriangulation), its vertices get voted normals
 * (\ref NormalVectorVoting), and the planes are clustered from them
 * (\ref PlaneHypothesisClustering); the planes are verified and fitted with the points
 * of the cloud. The planes of one view with quantised depth are found in its picture
 * instead (\ref DepthPlaneSegmentation), and its mesh is that of the refined view
 * (\ref DepthRefinement).
 *
 * On request, cylinders replace the planes and the mesh that they describe in fewer bits
 * (\ref CylinderHypothesisClustering, \ref setComputeCylinders), and planes that are the
 * sides of boxes, or leaves of recesses such as closed doors, are named (\ref BoxFitting,
 * \ref RecessFitting, \ref setComputeBoxes).
 *
 * Each step is an object that can be set; its threads and progress are those of this
 * object. Any mesh construction of PCL can take the place of DeWallTriangulation.
 * \code
 * pcl::PlaneMapping mapping;
 * mapping.setInputCloud (cloud);                 // pcl::PointCloud<pcl::PointXYZRGB>::Ptr
 * pcl::MappedPlanes result;
 * mapping.compute (result);
 * for (const pcl::PlanePatch& plane : result.planes)
 *   std::cout << plane.coefficients.transpose () << "\n";
 * \endcode
 * Metres, frame of the cloud. The result is the same for every number of threads.
 * \ingroup pipeline */
class ACMAP_EXPORT PlaneMapping : public StageControls<PlaneMappingReport> {
public:
  using Vertex = PointXYZRGBNormalView;
  using Consolidation = VoxelConsolidation<PCLPointCloud2>;
  using Refinement = DepthRefinement<PCLPointCloud2>;
  using Voting = NormalVectorVoting<PCLPointCloud2>;
  using Clustering = PlaneHypothesisClustering<PCLPointCloud2>;
  using CylinderClustering = CylinderHypothesisClustering<PCLPointCloud2>;
  using DepthSegmentation = DepthPlaneSegmentation<PointXYZ>;

  PlaneMapping();

  /** \brief Sets the cloud, with all its fields and its sensor. An int32 field `view`
   * names the observation of each point, see \ref setViewpoints. */
  void
  setInputCloud(std::shared_ptr<const PointCloudFile> cloud);

  /** \brief The same for rows that may be larger than the memory.
   * \param[in] file sensor and remarks of the rows; none: their sensor is at the origin */
  void
  setInputCloud(const CloudRows& rows,
                std::shared_ptr<const PointCloudFile> file = nullptr);

  /** \brief The same for a cloud of a point type, which is copied.
   * \throws InitFailedException without a cloud */
  template <typename PointT>
  void
  setInputCloud(const std::shared_ptr<const PointCloud<PointT>>& cloud);

  template <typename PointT>
  void
  setInputCloud(const std::shared_ptr<PointCloud<PointT>>& cloud)
  {
    setInputCloud(std::shared_ptr<const PointCloud<PointT>>(cloud));
  }

  /** \brief Sets the points of the cloud that are used, as in PCLBase; a null pointer
   * (default): all. They hold for clouds that are set later, too.
   *
   * The other points have no label and support no plane. They stay in their places, as
   * points without coordinates: an organized cloud stays organized. */
  void
  setIndices(const IndicesConstPtr& indices)
  {
    indices_ = indices;
  }

  void
  setIndices(const PointIndicesConstPtr& indices);

  IndicesConstPtr
  getIndices() const
  {
    return indices_;
  }

  /** \brief Sets the mesh whose vertices the points of the cloud are; nothing is then
   * consolidated or triangulated. Empty (default): a mesh is made. */
  void
  setInputMesh(TriangleMesh mesh)
  {
    input_mesh_ = std::move(mesh);
  }

  /** \brief Sets the positions of the sensor for the observations that the field `view`
   * refers to, in metres, in the frame of the cloud. Clouds without that field use the
   * sensor position of the file. Not used with \ref setInputMesh.
   * \throws BadArgumentException when one is not finite */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  /** \brief Sets the up direction of the cloud instead of finding it, whatever its file
   * states.
   * \param[in] up of any length above 0
   * \throws BadArgumentException if it is not finite or zero */
  void
  setUpDirection(const Eigen::Vector3d& up);

  /** \brief Finds the up direction again (default). */
  void
  resetUpDirection()
  {
    given_up_.reset();
  }

  /** \brief The up direction that was set, of length 1; nothing if it is found. */
  const std::optional<Eigen::Vector3d>&
  getUpDirection() const
  {
    return given_up_;
  }

  /** \brief Sets the kind of sensor that measured the cloud (default Automatic). */
  void
  setDepthSensor(DepthSensor sensor)
  {
    sensor_ = sensor;
  }

  DepthSensor
  getDepthSensor() const
  {
    return sensor_;
  }

  /** \brief The sensor whose noise the steps make use of: Laser, so that all is done in
   * space, where all clouds are consolidated or none are, or where the distance of points
   * from their planes was set (\ref setClustering). \ref CompactMapping then leaves
   * quantised depth as it is. */
  DepthSensor
  getUsedDepthSensor() const
  {
    return policy_ != ConsolidationPolicy::WhereNoisy ||
                   clustering_.getDistanceThreshold()
               ? DepthSensor::Laser
               : sensor_;
  }

  /** \brief Sets all steps to the paper's way, or back to the default one (Accurate).
   *
   * Paper: raw points are never consolidated and no plane is searched for in a picture;
   * the mesh is that of \ref DeWallRule::Strict, with its loops as outlines; votes and
   * hypotheses are the literal ones of \ref NormalVectorVoting and
   * \ref PlaneHypothesisClustering. The mesh construction becomes a new
   * DeWallTriangulation; other settings of the steps stay. A step that is set later
   * replaces what this call set: each departure from the paper can be taken back
   * alone. */
  void
  setMode(MappingMode mode);

  MappingMode
  getMode() const
  {
    return mode_;
  }

  /** \brief Sets which clouds are consolidated (default WhereNoisy). */
  void
  setConsolidationPolicy(ConsolidationPolicy policy)
  {
    policy_ = policy;
  }

  ConsolidationPolicy
  getConsolidationPolicy() const
  {
    return policy_;
  }

  /** \brief Requests the mesh of a view whose planes are found in its picture (default
   * true). In space there is always one. */
  void
  setComputeMesh(bool compute)
  {
    compute_mesh_ = compute;
  }

  bool
  getComputeMesh() const
  {
    return compute_mesh_;
  }

  void
  setConsolidation(const Consolidation& consolidation)
  {
    consolidation_ = consolidation;
  }

  const Consolidation&
  getConsolidation() const
  {
    return consolidation_;
  }

  /** \brief Sets how the mesh is made (default: \ref DeWallTriangulation with its
   * defaults).
   *
   * The maximum edge length of a DeWallTriangulation, if it is 0, becomes
   * \ref mesh_edge_in_voxels after a consolidation.
   * \throws BadArgumentException without one */
  void
  setMeshConstruction(const MeshConstruction<Vertex>::Ptr& construction);

  MeshConstruction<Vertex>::Ptr
  getMeshConstruction() const
  {
    return construction_;
  }

  void
  setVoting(const Voting& voting)
  {
    voting_ = voting;
  }

  const Voting&
  getVoting() const
  {
    return voting_;
  }

  /** \brief Sets how planes are found in space (default: driven by the noise). The
   * planes are verified and fitted with the points of the cloud unless it uses the
   * paper's thresholds. */
  void
  setClustering(const Clustering& clustering)
  {
    clustering_ = clustering;
  }

  const Clustering&
  getClustering() const
  {
    return clustering_;
  }

  /** \brief Searches cylinders after the planes (default false): columns, pipes and
   * curved walls, on the mesh. A mesh is then always made. Planes that a cylinder
   * replaces are removed. */
  void
  setComputeCylinders(bool compute)
  {
    compute_cylinders_ = compute;
  }

  bool
  getComputeCylinders() const
  {
    return compute_cylinders_;
  }

  /** \brief Sets how cylinders are found. */
  void
  setCylinderClustering(const CylinderClustering& clustering)
  {
    cylinder_clustering_ = clustering;
  }

  const CylinderClustering&
  getCylinderClustering() const
  {
    return cylinder_clustering_;
  }

  /** \brief Searches boxes and recesses, such as closed doors, among the planes (default
   * false), after the cylinders. Their sides and leaves stay in the planes. */
  void
  setComputeBoxes(bool compute)
  {
    compute_boxes_ = compute;
  }

  bool
  getComputeBoxes() const
  {
    return compute_boxes_;
  }

  /** \brief Sets how planes are found in the picture of a view. */
  void
  setDepthSegmentation(const DepthSegmentation& segmentation)
  {
    depth_segmentation_ = segmentation;
  }

  const DepthSegmentation&
  getDepthSegmentation() const
  {
    return depth_segmentation_;
  }

  void
  setCostCallback(CostCallback callback)
  {
    cost_callback_ = std::move(callback);
  }

  /** \brief Shares the sums of voxels out over processes, whose others call
   * \ref serveRanks (default: none). Points of \ref RankedWork are shared out already. The
   * planes have the same bytes. */
  void
  setRanks(std::shared_ptr<Ranks> ranks)
  {
    ranks_ = std::move(ranks);
  }

  /** \brief Finds the planes of the input cloud.
   * \param[out] result no planes, with the reason in the report, if there are none
   * \throws InitFailedException without a cloud, with an index outside of it, and as the
   * steps do
   * \throws UnorganizedPointCloudException if the sensor that was set requires a
   * picture and the cloud is not one view in its sensor's frame
   * \throws CancelledException if the progress callback stopped it
   * \throws what the cost callback throws */
  void
  compute(MappedPlanes& result);

  /** \brief The same in the types of OrganizedMultiPlaneSegmentation, for any cloud; no
   * mesh of a view is made whose planes are found in its picture.
   * \param[out] coefficients four values for each plane, in the order of decreasing area
   * \param[out] inliers for each plane its points in the input cloud */
  void
  compute(std::vector<ModelCoefficients>& coefficients,
          std::vector<PointIndices>& inliers);

  /** \brief The largest plane alone, as SACSegmentation gives it. All planes are found
   * for it: who wants all of them calls \ref compute once.
   * \param[out] inliers its points in the input cloud; none if there is no plane
   * \param[out] coefficients its four values; none if there is no plane */
  void
  segment(PointIndices& inliers, ModelCoefficients& coefficients);

private:
  /** \param[in] compute_mesh also of a view whose planes are found in its picture */
  void
  runSteps(bool compute_mesh, MappedPlanes& result);

  CloudRows rows_;
  std::shared_ptr<const PointCloudFile> input_; ///< sensor and remarks of the rows
  IndicesConstPtr indices_;                     ///< null: all points
  TriangleMesh input_mesh_;
  std::vector<Eigen::Vector3f> viewpoints_;
  std::optional<Eigen::Vector3d> given_up_;
  DepthSensor sensor_ = DepthSensor::Automatic;
  MappingMode mode_ = MappingMode::Accurate;
  ConsolidationPolicy policy_ = ConsolidationPolicy::WhereNoisy;
  bool compute_mesh_ = true;
  Consolidation consolidation_;
  MeshConstruction<Vertex>::Ptr construction_;
  Voting voting_;
  Clustering clustering_;
  bool compute_cylinders_ = false;
  CylinderClustering cylinder_clustering_;
  bool compute_boxes_ = false;
  DepthSegmentation depth_segmentation_;
  CostCallback cost_callback_;
  std::shared_ptr<Ranks> ranks_; ///< null: this process alone
};

template <typename PointT>
void
PlaneMapping::setInputCloud(const std::shared_ptr<const PointCloud<PointT>>& cloud)
{
  setInputCloud(acmap::fileOf(cloud));
}

} // namespace pcl
