#pragma once

#include "figure_plan.h"

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap {

/** \brief A view from an eye, by default 640 x 480 px; up is -y. */
template <typename View = SceneView>
View
viewFrom(const FigureEye& eye, int width = 640, int height = 480)
{
  View view;
  view.width = width;
  view.height = height;
  view.from = eye.from;
  view.look = eye.look;
  view.up = -Eigen::Vector3f::UnitY();
  return view;
}

/** \brief Connects neighbouring pixels of an observation by triangles that face the
 * camera. Pixels whose depths differ by more than those of a slanted wall are not
 * connected. */
TriangleMesh
surfaceOf(const PointCloud<PointXYZRGBSigma>& observation);

} // namespace pcl::acmap
