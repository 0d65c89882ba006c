#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

namespace pcl::acmap::bench {

/** \brief Disparities as colours, from blue (the least) to red; black where there is none.
 * \param[in] least px
 * \param[in] most px */
CameraImage
coloredDisparity(const DisparityImage& image, float least, float most);

/** \brief What the points of a view look like from a place beside and above it, turned to
 * their middle; of the same size.
 * \param[in] color of the reference view, grey or in colour
 * \param[in] yaw how far round the middle the place lies, rad, positive to the left */
CameraImage
viewFromBeside(const DisparityImage& disparity,
               const CameraImage& color,
               const TrinocularRig& rig,
               double yaw);

} // namespace pcl::acmap::bench
