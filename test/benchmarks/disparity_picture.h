#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

namespace pcl::acmap::bench {

/** \brief Disparities as colours, from blue (minimum) to red; black for invalid ones.
 * \param[in] minimum px
 * \param[in] maximum px */
CameraImage
coloredDisparity(const DisparityImage& image, float minimum, float maximum);

/** \brief Renders the points of a view from a position beside and above it, looking at
 * their centre; the picture has the same size.
 * \param[in] color of the reference view, grey or in colour
 * \param[in] yaw rotation of the position about the centre, rad, positive to the
 * left */
CameraImage
viewFromBeside(const DisparityImage& disparity,
               const CameraImage& color,
               const TrinocularRig& rig,
               double yaw);

} // namespace pcl::acmap::bench
