#pragma once

#include "vtk_pieces.h"

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief The viewing frustum of a camera as lines; its apex is the camera. */
vtkSmartPointer<vtkActor>
actorOfMarker();

/** \param[in] T_map_camera pose of the camera */
void
place(vtkActor* marker, const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap
