#pragma once

#include <pcl/core/impl/nearest_points.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/egomotion/egomotion_types.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The surface that an observation without an image shows. */
class ScanSurface {
public:
  /** \param[in] scan sensor frame, metres; it is thinned, and points that are on no plane with
   * their neighbours are left out */
  explicit ScanSurface(const PointView& scan);

  std::size_t
  size() const
  {
    return points.size();
  }

  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals; ///< unit, towards the sensor
  NearestPoints tree;
};

/** \brief How far the sensor may have moved. */
struct ScanReach {
  double translation; ///< metres
  double rotation;    ///< radians
};

/** \brief Estimates the motion of a sensor from two of its scans, by distances of points from
 * planes (Chen and Medioni, "Object modelling by registration of multiple range images", 1992) with
 * a robust weight. Many starts are tried, since corridors have places that look alike; where two
 * motions explain the scans equally well, or a direction is not determined, there is no result.
 * \param[in] guess T_target_source, one of the starts
 * \param[out] report outcome and reason, points, pairs and residuals */
std::optional<EgomotionEstimate>
matchScans(const ScanSurface& source,
           const ScanSurface& target,
           const Eigen::Isometry3d& guess,
           const ScanReach& reach,
           EgomotionReport& report);

} // namespace pcl::acmap
