#pragma once

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap::test {

using ViewedPoint = PointXYZRGBNormalView;

/** \brief Points at the poses of a room's way, two of each, and poses that were 1 m
 * higher before; a mesh of four triangles: of walls of depth 0 and 1, of depth 2, and of none; the room. */
LayeredScene
makeViewedRoom();

PointCloud<ViewedPoint>
typed(const PCLPointCloud2& cloud);

} // namespace pcl::acmap::test
