#include <pcl/core/cloud_assessment.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/impl/up_direction.h>
#include <pcl/core/noise_scale.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/pipeline/cloud_meshing.h>
#include <pcl/pipeline/picture.h>

#include <memory>
#include <utility>

namespace pcl {

namespace {

// fractions of the progress
constexpr double cloud_read = 0.1, cloud_meshing = 0.4;

/** A run of \ref meshCloud. */
class MeshingRun {
public:
  MeshingRun(CloudRows rows, const PointCloudFile& file, const CloudMeshing& meshing)
  : meshing_(meshing)
  , file_(file)
  , triangulation_(meshing.triangulation)
  {
    made_.vertices = std::move(rows);
    made_.names_views =
        acmap::findField(made_.vertices.layout(), "view", PCLPointField::INT32);
  }

  MeshedCloud
  run()
  {
    acmap::StepTimer timer(made_.steps);
    assess();
    timer.finish("assess");
    const bool is_automatic = meshing_.consolidation.getVoxelSize() == 0;
    const auto picture =
        is_automatic
            ? acmap::pictureOf(points(), made_.vertices.layout().width, meshing_.sensor)
            : std::nullopt;
    if (picture && meshing_.consolidates) {
      refine(*picture);
      timer.finish("refine");
    }
    else if (meshing_.consolidates) {
      consolidate();
      timer.finish("consolidate");
    }
    else
      made_.shows_steps = picture && acmap::measureDepthStep(points()) > 0;
    triangulate();
    timer.finish("triangulate");
    return std::move(made_);
  }

private:
  acmap::PointView
  points() const
  {
    return acmap::requirePoints(made_.vertices);
  }

  /** Finds out what the sides of the surfaces depend on. */
  void
  assess()
  {
    made_.sensor = acmap::sensorEvidence(made_.vertices, file_);
    if (const auto stated = acmap::statedUp(std::nullopt, file_))
      made_.up = *stated;
    else if (!made_.sensor.isKnown()) {
      const NoiseScale scale = measureNoiseScale(points(), {}, meshing_.threads);
      made_.up = acmap::findUp(points(),
                               scale.spacing,
                               scale.sigma,
                               file_.usual_up,
                               meshing_.threads,
                               made_.sensor);
    }
    findSides(true);
  }

  /** \param[in] sensors_fit can the surface have been seen from the sensor? */
  void
  findSides(bool sensors_fit)
  {
    made_.tells_sides = acmap::upWithoutSensors(
        made_.vertices, made_.up, made_.sensor.isKnown(), sensors_fit);
  }

  /** Removes the quantisation steps of the cloud, which becomes organized. */
  void
  refine(const acmap::Picture& picture)
  {
    auto cloud = std::make_shared<PCLPointCloud2>(made_.vertices.copy());
    if (picture.order)
      *cloud = picture.order->arrange(*cloud);
    DepthRefinement<PCLPointCloud2> refinement;
    refinement.setNumberOfThreads(meshing_.threads);
    refinement.setProgressCallback(
        acmap::partOf(meshing_.progress, cloud_read, cloud_meshing));
    refinement.setInputCloud(cloud);
    const auto refined = std::make_shared<PCLPointCloud2>();
    refinement.filter(*refined);
    made_.vertices = refined;
    made_.refinement = refinement.getReport();
  }

  void
  consolidate()
  {
    VoxelConsolidation<PCLPointCloud2> consolidation = meshing_.consolidation;
    consolidation.setViewpoints(meshing_.viewpoints);
    if (made_.sensor.isKnown())
      consolidation.setSensorOrigin(file_.sensor_origin);
    consolidation.setNumberOfThreads(meshing_.threads);
    consolidation.setProgressCallback(
        acmap::partOf(meshing_.progress, cloud_read, cloud_meshing));
    consolidation.setInputCloud(made_.vertices);
    consolidation.filter(made_.vertices);
    made_.consolidation = consolidation.getReport();
    findSides(made_.consolidation->sensors_fit);
    if (triangulation_.getMaximumEdgeLength() == 0)
      triangulation_.setMaximumEdgeLength(mesh_edge_in_voxels *
                                          made_.consolidation->voxel_size);
  }

  void
  triangulate()
  {
    if (meshing_.cost)
      meshing_.cost("triangulating this cloud",
                    acmap::estimateDeWallMemory(made_.vertices.size(),
                                                true,
                                                triangulation_.getAcceptanceRule()),
                    0);
    triangulation_.setInputCloud(made_.vertices);
    if (made_.sensor.outcome == SensorOutcome::Stated)
      triangulation_.setSensorOrigin(file_.sensor_origin);
    if (made_.tells_sides)
      triangulation_.setUpDirection(*made_.tells_sides);
    triangulation_.setNumberOfThreads(meshing_.threads);
    triangulation_.setProgressCallback(
        acmap::partOf(meshing_.progress, cloud_meshing, 1));
    triangulation_.reconstruct(made_.mesh);
    made_.triangulation = triangulation_.getReport();
  }

  const CloudMeshing& meshing_;
  const PointCloudFile& file_;
  DeWallTriangulation<PCLPointCloud2> triangulation_;
  MeshedCloud made_;
};

} // namespace

MeshedCloud
meshCloud(CloudRows rows, const PointCloudFile& file, const CloudMeshing& meshing)
{
  return MeshingRun(std::move(rows), file, meshing).run();
}

} // namespace pcl
