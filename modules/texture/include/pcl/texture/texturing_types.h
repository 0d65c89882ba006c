#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/report.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl {

/** \brief What PlaneTexturing tells about its last run. \ingroup texture */
struct TexturingReport : Report {
  std::size_t observations = 0; ///< that were given
  std::size_t pinholes =
      0; ///< of them organized, as a pinhole camera sees: projected into
  std::size_t splatted = 0;  ///< of them others: each point colours the texel it is in
  std::size_t colorless = 0; ///< of them without colour; their texels stay unknown
  std::size_t invalid_points = 0; ///< of all observations, not finite
  std::size_t charts = 0;
  std::size_t texels = 0; ///< inside the polygons
  std::size_t seen = 0;   ///< of them coloured by observations
  std::size_t filled = 0; ///< of them coloured after neighbours
  double texel_size = 0;  ///< metres
  std::vector<double>
      gains; ///< by which the colours of each observation were multiplied
};

/** \brief An observation that PlaneTexturing paints with, of any fields, as files have them.
 * \ingroup texture */
struct TexturedObservation {
  PCLPointCloud2ConstPtr cloud; ///< camera frame, metres; colour as `rgb` or `rgba`
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  double stamp = 0; ///< seconds, for the trajectory of the map

  /** \brief Was it seen from the origin of its frame? Otherwise each point colours the
   * texel that it lies in, and the map has neither poses nor observations. */
  bool has_sensor = true;
};

/** \brief Loads an observation when it is painted; nothing if it is to be left out.
 * \ingroup texture */
using TexturedObservationLoader = std::function<std::optional<TexturedObservation>()>;

} // namespace pcl
