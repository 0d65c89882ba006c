#pragma once

#include "array_view.h"

#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl::acmap::python {

using Poses = std::vector<Eigen::Isometry3d>;

/** \brief Reads a pose from an array of (4, 4) float64.
 * \throws py::type_error when it is not an array of float64
 * \throws py::value_error when its shape is another one, or it is not a rigid motion */
Eigen::Isometry3d
poseOf(const std::string& name, const py::handle& argument);

/** \brief Reads poses from an array of (k, 4, 4) float64. \throws as \ref poseOf */
Poses
posesOf(const std::string& name, const py::handle& argument);

/** \brief An array of (k, 4, 4) float64 that refers to poses.
 * \param[in] owner of the poses; the array keeps a reference to it */
py::array_t<double>
arrayOfPoses(const Poses& poses, const py::handle& owner);

} // namespace pcl::acmap::python
