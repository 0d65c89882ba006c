#pragma once

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl {

template <typename PointInT>
DeWallTriangulation<PointInT>::DeWallTriangulation()
{
  check_tree_ = false; // without a search method the internal tree is used
}

template <typename PointInT>
void
DeWallTriangulation<PointInT>::reconstruct(TriangleMesh& mesh)
{
  acmap::requireInput<PointInT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  if (!this->initCompute())
    throw acmap::InitFailed("the input cloud was refused");
  acmap::DeWallInput input;
  input.points = acmap::pointsOf(*input_, indices_.get());
  input.sensor_origin =
      input_->sensor_origin_.template head<3>().template cast<double>();
  input.normals = acmap::normalsOf(*input_);
  const bool is_picture = input_->isOrganized() && indices_->size() == input_->size();
  acmap::takeSensor(
      is_picture ? input_->width : 0, !input.sensor_origin.isZero(0), input);
  input.neighbours = givenSearch();
  input.threads = threads_;
  DeWallReport report;
  TriangleMesh result =
      acmap::triangulateDeWall(input, settings(), acmap::Progress(progress_), report);
  this->deinitCompute();
  mesh = std::move(result);
  report_ = std::move(report);
}

template <typename PointInT>
acmap::NeighbourDistances
DeWallTriangulation<PointInT>::givenSearch()
{
  if (!tree_)
    return {};
  tree_->setInputCloud(input_, this->fake_indices_ ? nullptr : indices_);
  return [this](std::int32_t point, int count) {
    Indices found;
    std::vector<float> squared_distances;
    tree_->nearestKSearch((*input_)[point], count, found, squared_distances);
    return squared_distances;
  };
}

template <typename PointInT>
void
DeWallTriangulation<PointInT>::reconstruct(std::vector<Vertices>& polygons)
{
  performReconstruction(polygons);
}

template <typename PointInT>
void
DeWallTriangulation<PointInT>::reconstruct(PolygonMesh& output)
{
  performReconstruction(output);
}

template <typename PointInT>
void
DeWallTriangulation<PointInT>::performReconstruction(std::vector<Vertices>& polygons)
{
  TriangleMesh mesh;
  reconstruct(mesh);
  std::vector<Vertices> result(mesh.triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t)
    result[t].vertices.assign(mesh.triangles[t].begin(), mesh.triangles[t].end());
  polygons = std::move(result);
}

template <typename PointInT>
void
DeWallTriangulation<PointInT>::performReconstruction(PolygonMesh& output)
{
  PolygonMesh result;
  performReconstruction(result.polygons);
  result.header = input_->header;
  toPCLPointCloud2(*input_, result.cloud);
  output = std::move(result);
}

} // namespace pcl

#define PCL_INSTANTIATE_DeWallTriangulation(T) \
  template class ACMAP_EXPORT pcl::DeWallTriangulation<T>;
