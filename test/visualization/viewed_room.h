#pragma once

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap::test {

using ViewedPoint = PointXYZRGBNormalView;

/** \brief The room; two points at each pose of a trajectory, whose poses were 1 m
 * higher before rectification; a mesh of four triangles, of walls of depth 0, 1 and 2
 * and of no wall. */
LayeredScene
makeViewedRoom();

PointCloud<ViewedPoint>
typed(const PCLPointCloud2& cloud);

} // namespace pcl::acmap::test
