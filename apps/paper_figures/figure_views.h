#pragma once

#include "figure_plan.h"

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap {

/** \brief A view of 640 x 480 px, or of another size, from an eye; up is -y. */
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

/** \brief The surface between neighbouring pixels of an observation, where their depths
 * differ by no more than a slanting wall's do; towards the camera. */
TriangleMesh
surfaceOf(const PointCloud<PointXYZRGBSigma>& observation);

} // namespace pcl::acmap
