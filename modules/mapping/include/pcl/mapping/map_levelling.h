#pragma once

#include <pcl/core/build_config.h>
#include <pcl/mapping/impl/levelling_kernel.h>
#include <pcl/mapping/map_levelling_types.h>
#include <pcl/mapping/posed_clouds.h>
#include <pcl/memory.h>

#include <Eigen/Geometry>

#include <optional>

namespace pcl {

/** \brief Finds the vertical of a map from its floors, ceilings and walls, and turns the
 * map so that an axis of its frame is vertical.
 *
 * "Active Stereo Based Compact Mapping" (II-B) assumes a robot whose camera is level, so
 * that the map frame, that of the first camera, is level, too: y is vertical, and poses
 * differ in x, z and a turn about y (\ref EntropyRectification). That of a tilted or
 * hand-held camera is not level, and scanners have a vertical z.
 *
 * The up direction is the one with respect to which most of the surface is horizontal or
 * vertical, to within 10 degrees, by robust least squares on the normals. A room has three such
 * directions: the one nearest to what is expected is taken, none that deviates from it
 * by more than 60 degrees. A camera (all points within 65 degrees of its z axis) is
 * expected to have -y up. Other sensors have z or -y up: that about which the sensor
 * turned; else that along which it did not move; else that along which the map is thin
 * and most surface faces. The map is then turned about its origin until the axis of its
 * frame that is nearest to the up direction coincides with it. A map that is level within
 * half a degree, or within three standard deviations, is not turned, nor is one where less than a third of the surface agrees.
 *
 * Units are metres. The time is O(n). The result is bitwise the same for any number of
 * threads.
 * \code
 * pcl::MapLevelling<pcl::PointNormal> levelling;
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   levelling.addPointCloud (clouds[i], T_map_camera[i]);
 * levelling.compute ();
 * T_level_camera = levelling.getPose (0);
 * \endcode
 * \ingroup mapping */
template <typename PointT>
class MapLevelling
: public acmap::PosedClouds<PointT, Eigen::Isometry3d, MapLevellingReport> {
  using Base = acmap::PosedClouds<PointT, Eigen::Isometry3d, MapLevellingReport>;

public:
  using Ptr = shared_ptr<MapLevelling<PointT>>;
  using ConstPtr = shared_ptr<const MapLevelling<PointT>>;

  /** \brief Sets the up direction instead of estimating it.
   * \param[in] up in the given map frame, of any length above 0
   * \throws BadArgumentException if it is not finite or zero */
  void
  setUpDirection(const Eigen::Vector3d& up);

  /** \brief Estimates the up direction again (default). */
  void
  resetUpDirection()
  {
    given_up_.reset();
  }

  /** \brief The up direction that was set, of length 1; nothing if it is estimated. */
  const std::optional<Eigen::Vector3d>&
  getUpDirection() const
  {
    return given_up_;
  }

  /** \brief Removes all observations. */
  void
  clear();

  /** \brief Finds the up direction, always of the given poses.
   * \throws InitFailedException without an observation
   * \throws CancelledException when the progress callback requested to stop; nothing is
   * changed */
  void
  compute();

  /** \brief The rotation from the given map frame to the level one. */
  const Eigen::Quaterniond&
  getRotation() const
  {
    return rotation_;
  }

private:
  std::optional<Eigen::Vector3d> given_up_;
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/mapping/impl/map_levelling.hpp>
#endif
