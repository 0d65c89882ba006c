#pragma once

#include "bad_case.h"
#include "clouds.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace pcl::acmap::test {

/** \brief A small organized view of a corner of two walls, and a room that is none. */
const Cloud&
goodView();
const Cloud&
goodRoom();

/** \brief Each kind of cloud, made of the view and of the room. */
const Kinds<Cloud::Ptr>&
badClouds();

/** \brief The same kinds, for an input that need not be set. */
template <typename Value>
Kinds<Value>
orNone(Kinds<Value> kinds)
{
  for (Kind<Value>& kind : kinds)
    if (kind.name == "null pointer")
      kind.answer = Answer::Any;
  return kinds;
}

/** \brief Kinds of indices of a cloud of so many points. */
Kinds<IndicesPtr>
badIndices(std::size_t points);

Kinds<Eigen::Matrix4d>
badPoses();

Kinds<PointCloud<Normal>::Ptr>
badNormals(std::size_t points);

Kinds<TriangleMesh>
badMeshes(std::size_t points);

Kinds<std::vector<Eigen::Vector3f>>
badViewpoints();

/** \brief Kinds of equations and frames of planes, and of their polygons. */
Kinds<std::vector<PlanePatch>>
badPlanes();
Kinds<std::vector<PlanePatch>>
badPolygons();

/** \brief A square wall of 1 m. */
PlanePatch
goodPlane();

/** \brief The cloud in another type, with colours and normals where this has them; a null
 * pointer stays one. */
template <typename PointT>
typename PointCloud<PointT>::Ptr
as(const Cloud::ConstPtr& cloud)
{
  if (!cloud)
    return nullptr;
  const typename PointCloud<PointT>::Ptr out(new PointCloud<PointT>);
  out->points.resize(cloud->size());
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    PointT& point = out->points[i];
    point.getVector3fMap() = cloud->points[i].getVector3fMap();
    setNormal(point, {0, 0, -1}, 0);
    const auto shade = static_cast<std::uint8_t>((i / 3 * 2654435761U) >> 7U);
    setColor(point, {shade, shade, shade});
  }
  out->width = cloud->width;
  out->height = cloud->height;
  out->is_dense = cloud->is_dense;
  out->sensor_origin_ = cloud->sensor_origin_;
  out->sensor_orientation_ = cloud->sensor_orientation_;
  return out;
}

/** \brief The cloud with fields of coordinates, colour, normal and view. */
PCLPointCloud2::Ptr
asRows(const Cloud::ConstPtr& cloud);

/** \brief Kinds of bytes and fields, of a cloud whose coordinates need not be used. */
const Kinds<PCLPointCloud2::Ptr>&
badLayouts();

/** \brief Kinds of clouds of any fields, those of \ref badClouds included. */
const Kinds<PCLPointCloud2::Ptr>&
badRows();

} // namespace pcl::acmap::test
