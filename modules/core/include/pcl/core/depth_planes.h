#pragma once

#include <pcl/core/depth_view.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/progress.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What \ref findDepthPlanes goes by. \ingroup core */
struct DepthPlaneSettings {
  NoiseScale::InverseDepth noise;

  /** \brief Smallest area of a plane, square metres; 0: automatic, 0.1, or 0.3 % of the
   * surface in view where that is less. */
  double least_area = 0;
};

/** \brief A plane of a view. */
struct DepthPlane {
  /** \brief (a, b, c) of 1/z = a x + b y + c, 1/m: the plane's normal, which looks away
   * from the sensor, over its distance. */
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();

  double rms = 0;  ///< of its pixels' inverse depths about it, 1/m
  double area = 0; ///< square metres that its pixels cover on it
  std::size_t pixels = 0;

  Eigen::Vector3d
  normal() const
  {
    return inverse.normalized();
  }

  /** \brief Distance from the sensor, metres. */
  double
  distance() const
  {
    return 1 / inverse.norm();
  }
};

struct DepthPlanes {
  std::vector<DepthPlane> planes;   ///< by falling area
  std::vector<std::int32_t> labels; ///< for each pixel its plane, -1 for none
  std::size_t merged = 0;           ///< regions that were part of another one's plane
  std::size_t small = 0;            ///< regions without the area, or of unknown tilt
  std::size_t curved = 0;           ///< regions that are strips of a curved surface
};

/** \brief Finds the planes of a depth view in its picture, where its noise is even.
 *
 * Tiles of 8 x 8 pixels are summed up to their moments of (x, y, 1/z). Blocks of 6, 4, 3
 * and 2 tiles across that are planes within the noise are seeds, large ones first; a plane
 * grows over the tiles beside it that it fits, is fitted anew as it grows, and takes in
 * the parts of it that lie apart. Pixels then go to the plane that they fit; where two
 * planes meet, to the one in front at an inner edge and to the one behind at an outer one,
 * whatever their noise. Linear time; no chance, no threads. */
ACMAP_EXPORT DepthPlanes
findDepthPlanes(const DepthView& view,
                const DepthPlaneSettings& settings,
                const Progress& progress);

/** \brief Planes of a view that were found before, by their equations and the labels of
 * its pixels; the other fields stay empty.
 * \param[in] patches in the sensor's frame; none passes through the sensor
 * \param[in] labels for each pixel its patch, -1 for none
 * \throws BadArgumentException where a label names no patch, or a plane passes through the
 * sensor */
ACMAP_EXPORT DepthPlanes
depthPlanesOf(const std::vector<PlanePatch>& patches,
              const std::vector<std::int32_t>& labels);

} // namespace pcl::acmap
