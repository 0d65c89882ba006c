#pragma once

#include <pcl/Vertices.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/point_cloud.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <memory>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Mesh, source cloud and labels of \ref PlaneHypothesisClustering and
 * \ref CylinderHypothesisClustering, for clouds of points and of rows.
 * \ingroup segmentation */
class ACMAP_EXPORT ClusteringInputs {
public:
  /** \brief Sets the mesh whose vertices the points are: it defines the neighbours, and
   * the outlines of planes are computed from it. */
  void
  setTriangles(const std::vector<Vertices>& polygons);

  void
  setTriangles(TriangleMesh mesh)
  {
    triangles_ = std::move(mesh.triangles);
  }

  /** \brief Sets the cloud from which the input was consolidated.
   * \param[in] cloud it is kept until another one is set
   * \param[in] viewpoints sensor positions of the observations to which the field
   * `view` of the cloud refers, in metres; without that field, the sensor position of
   * all points is sensor_origin_
   * \throws BadArgumentException when a viewpoint is not finite */
  template <typename SourceT>
  void
  setSourceCloud(const std::shared_ptr<const PointCloud<SourceT>>& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {});

  template <typename SourceT>
  void
  setSourceCloud(const std::shared_ptr<PointCloud<SourceT>>& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {})
  {
    setSourceCloud(std::shared_ptr<const PointCloud<SourceT>>(cloud), viewpoints);
  }

  /** \brief The same for a cloud of any fields, as files have them.
   * \param[in] viewpoints of a cloud without an int32 field `view`: the position of its
   * sensor alone, or none where that is unknown
   * \throws InitFailedException if it has no float32 fields x, y, z side by side */
  void
  setSourceCloud(const CloudRows& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {});

  /** \brief For each point of the input cloud the number of its patch in the last
   * result, -1 for none. */
  const PointLabels&
  getLabels() const
  {
    return labels_;
  }

  /** \brief For each point of the source cloud the number of its patch; empty without a
   * source cloud. */
  const PointLabels&
  getSourceLabels() const
  {
    return source_labels_;
  }

protected:
  ClusteringInputs() = default;

  /** \brief The sensors of the points of the input, which have the observations of the
   * source.
   * \param[in] chosen indices of points, nullptr for all */
  template <typename PointT>
  acmap::SensorView
  pointSensors(const PointCloud<PointT>& points, const std::int32_t* chosen) const;

  /** \brief The points of rows with their normals and sensors.
   * \param[in] normals one row per point; none: those of the points, if they have any
   * \throws InitFailedException as the classes for rows do */
  acmap::PlaneHypotheses
  hypothesesOf(const CloudRows& points, const CloudRows& normals) const;

  /** \brief Throws InitFailedException unless there is one for each point.
   * \param[in] what in the plural */
  static void
  requireAsMany(const char* what, std::size_t number, std::size_t points);

  /** \brief Keeps the labels of a result.
   * \param[in] of_hypotheses for each point, or for each of the chosen ones
   * \param[in] chosen indices of points, nullptr for all */
  void
  keepLabels(PointLabels of_hypotheses,
             const std::vector<std::int32_t>* chosen,
             std::size_t points);

  TriangleMesh::Triangles triangles_;
  acmap::PointView source_points_;
  acmap::SensorView source_sensors_;
  bool has_known_sensors_ = false; ///< of the source
  PointLabels source_labels_;

private:
  acmap::SensorView
  pointSensors(const CloudRows& points) const;

  std::shared_ptr<const void> source_;
  std::vector<Eigen::Vector3f> viewpoints_; ///< of the source
  PointLabels labels_;
};

template <typename SourceT>
void
ClusteringInputs::setSourceCloud(
    const std::shared_ptr<const PointCloud<SourceT>>& cloud,
    const std::vector<Eigen::Vector3f>& viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  if (cloud)
    acmap::requireCloud<acmap::BadArgument>(cloud);
  source_ = cloud;
  const bool is_empty = !cloud || cloud->empty();
  source_points_ = is_empty ? acmap::PointView() : acmap::pointsOf(*cloud);
  source_sensors_ =
      is_empty ? acmap::SensorView() : acmap::sensorsOf(*cloud, viewpoints);
  viewpoints_ = is_empty ? std::vector<Eigen::Vector3f>() : viewpoints;
  has_known_sensors_ =
      !is_empty &&
      (acmap::has_view<SourceT> || !cloud->sensor_origin_.template head<3>().isZero(0));
  if (!is_empty && !acmap::has_view<SourceT>)
    viewpoints_ = {cloud->sensor_origin_.template head<3>()};
}

template <typename PointT>
acmap::SensorView
ClusteringInputs::pointSensors(const PointCloud<PointT>& points,
                               const std::int32_t* chosen) const
{
  if (viewpoints_.size() == 1)
    return acmap::SensorView(viewpoints_.front());
  if constexpr (acmap::has_view<PointT>)
    if (!points.empty() && !viewpoints_.empty())
      return acmap::SensorView(
          &points.front().view, sizeof(PointT), viewpoints_, chosen);
  return {};
}

} // namespace pcl
