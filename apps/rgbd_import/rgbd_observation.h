#pragma once

#include "color_camera.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/image_file.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief How numbers of a depth image become metres. */
struct DepthMeaning {
  double scale = 1000.0; ///< numbers in a metre
  double most = 0.0;     ///< metres; points beyond are left out; 0 for no limit

  /** \brief Metres of a number; 0 where nothing was measured. */
  double
  metres(std::uint16_t number) const
  {
    constexpr std::uint16_t saturated = 65535;
    const double z = number == saturated ? 0.0 : number / scale;
    return most > 0.0 && z > most ? 0.0 : z;
  }
};

/** \brief One standard deviation of a depth that a Kinect measured, along z, metres:
 * Nguyen, Izadi, Lovell: Modeling Kinect Sensor Noise for Improved 3D Reconstruction and
 * Tracking, 3DIMPVT 2012, their axial noise of surfaces that are not seen at a slant. */
inline double
kinectDepthSigma(double z)
{
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
}

/** \brief The points of a depth image, a point a pixel, metres; NaN where nothing was
 * measured. */
std::vector<Eigen::Vector3f>
measuredPoints(const GrayImage16& depth,
               const Pinhole& camera,
               const DepthMeaning& meaning);

/** \brief An organized cloud of x y z rgb sigma in the camera's frame, a point a pixel.
 *
 * x y z and sigma are NaN where nothing was measured; rgb is there at every pixel. sigma
 * is along the ray, which is longer than z by the ray's slant.
 * \param[in] color a pixel a point */
PCLPointCloud2
observationCloud(const RgbImage& color, const std::vector<Eigen::Vector3f>& points);

/** \brief The same in the frame and the pixels of a colour camera that stands beside.
 *
 * A point lies where the depth camera measured it, up to half a pixel off the middle of
 * the pixel that shows it; of several the nearest is taken. Pixels that no point falls on
 * have rgb alone. sigma is the one along the depth camera's ray.
 * \param[in] color of any size
 * \param[in] points of the depth camera. O(n) */
PCLPointCloud2
registeredCloud(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ColorCamera& color_camera);

} // namespace pcl::acmap
