#pragma once

#include "color_camera.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/image_file.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Conversion of the numbers of a depth image to metres. */
struct DepthMeaning {
  double scale = 1000.0; ///< number that is one metre
  double most = 0.0;     ///< metres; points beyond are left out; 0 for no limit

  /** \brief Converts a number to metres; 0 if nothing was measured. */
  double
  metres(std::uint16_t number) const
  {
    constexpr std::uint16_t saturated = 65535;
    const double z = number == saturated ? 0.0 : number / scale;
    return most > 0.0 && z > most ? 0.0 : z;
  }
};

/** \brief Standard deviation of a depth measured by a Kinect, along z, metres: axial
 * noise of surfaces that are not slanted, from Nguyen, Izadi, Lovell: Modeling Kinect
 * Sensor Noise for Improved 3D Reconstruction and Tracking, 3DIMPVT 2012. */
inline double
kinectDepthSigma(double z)
{
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
}

/** \brief The points of a depth image, one per pixel, metres; NaN if nothing was
 * measured. */
std::vector<Eigen::Vector3f>
measuredPoints(const GrayImage16& depth,
               const Pinhole& camera,
               const DepthMeaning& meaning);

/** \brief An organized cloud of x y z rgb sigma in the camera's frame, one point per
 * pixel.
 *
 * x y z and sigma are NaN if nothing was measured; rgb is valid at every pixel. sigma
 * is along the ray, which is longer than z for pixels off the centre.
 * \param[in] color one pixel per point */
PCLPointCloud2
observationCloud(const RgbImage& color, const std::vector<Eigen::Vector3f>& points);

/** \brief The same in the frame and the pixels of a separate colour camera.
 *
 * A point keeps its measured position, which is up to half a pixel from the centre of
 * its pixel; of several points in a pixel the nearest is used. Pixels without a point
 * have only rgb. sigma is along the ray of the depth camera.
 * \param[in] color of any size
 * \param[in] points of the depth camera. O(n) */
PCLPointCloud2
registeredCloud(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ColorCamera& color_camera);

} // namespace pcl::acmap
