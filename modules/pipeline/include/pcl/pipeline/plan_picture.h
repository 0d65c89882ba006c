#pragma once

#include <pcl/core/export.h>
#include <pcl/core/image_file.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief The part of the xz plane that a plan shows, x to the right and z upwards.
 * \ingroup pipeline */
struct PlanExtent {
  Eigen::Vector2d minimum = Eigen::Vector2d::Zero(); ///< x, z; metres
  double pixel = 1;                                  ///< metres
  int width = 1, height = 1;                         ///< pixels

  /** \brief Column and row of a point. */
  Eigen::Vector2d
  pixelOf(const Eigen::Vector3d& in_map) const
  {
    return {(in_map.x() - minimum.x()) / pixel,
            height - 1 - (in_map.z() - minimum.y()) / pixel};
  }
};

/** \brief Collects the contents of plans, so that plans with the same extent can be
 * compared. \ingroup pipeline */
class ACMAP_EXPORT PlanContents {
public:
  /** \brief Adds a point, metres. The extent ignores the outermost points. */
  void
  addPoint(const Eigen::Vector3d& in_map);

  /** \brief Adds a position that is always in the extent, unless it is farther than 1e9
   * m or not finite. */
  void
  addPlace(const Eigen::Vector3d& in_map);

  PlanExtent
  extent() const;

private:
  std::vector<float> x_, z_;
  Eigen::AlignedBox2d places_; ///< x, z
};

/** \brief A map from above: the number of points per pixel, and the way of the sensor.
 *
 * The map frame has y downwards, as that of a camera.
 * \code
 * pcl::PlanContents contents;
 * for (const auto& point : cloud)
 *   contents.addPoint (point.getVector3fMap ().cast<double> ());
 * pcl::PlanPicture plan (contents.extent ());
 * for (const auto& point : cloud)
 *   plan.add (point.getVector3fMap ().cast<double> ());
 * pcl::savePng ("plan.png", plan.draw (poses, {200, 30, 40}));
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT PlanPicture {
public:
  explicit PlanPicture(const PlanExtent& extent);

  /** \brief Counts a point, unless it is outside of the extent or not finite. */
  void
  add(const Eigen::Vector3d& in_map);

  /** \brief Draws the logarithm of the number of points as darkness, the trajectory of
   * the sensor as a line with a mark at its start, and a scale bar.
   * \param[in] poses T_map_sensor
   * \param[in] color of the trajectory: red, green, blue */
  RgbImage
  draw(const std::vector<Eigen::Isometry3d>& poses,
       const std::array<std::uint8_t, 3>& color) const;

private:
  PlanExtent extent_;
  std::vector<std::uint32_t> counts_;
};

} // namespace pcl
