#pragma once

#include "drawing.h"

#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What of the XZ plane a plan shows, x to the right and z upwards. */
struct PlanExtent {
  Eigen::Vector2d least = Eigen::Vector2d::Zero(); ///< x, z; metres
  double pixel = 1;                                ///< metres
  int width = 1, height = 1;                       ///< pixels
};

/** \brief What plans that are to be compared show. */
class PlanContents {
public:
  /** \brief Adds points, of which the extent leaves out the few outermost ones. */
  void
  addPoint(const Eigen::Vector3d& in_map);

  /** \brief Adds a place that is always shown, unless it is 1e9 m off or not finite. */
  void
  addPlace(const Eigen::Vector3d& in_map);

  PlanExtent
  extent() const;

private:
  std::vector<float> x_, z_;
  Eigen::AlignedBox2d places_; ///< x, z
};

/** \brief A map from above: how many points lie over each pixel. */
class PlanPicture {
public:
  explicit PlanPicture(const PlanExtent& extent);

  /** \brief Counts a point; one outside of the extent, or not finite, is left out. */
  void
  add(const Eigen::Vector3d& in_map);

  /** \brief The points as darkness, by the logarithm of their number, the way of the
   * sensor as a line with a mark at its begin, and a scale bar. */
  RgbImage
  draw(const std::vector<Eigen::Isometry3d>& poses, const Color& color) const;

private:
  Eigen::Vector2d
  pixelOf(const Eigen::Vector3d& in_map) const;

  PlanExtent extent_;
  std::vector<std::uint32_t> counts_;
};

/** \brief Two plans of one extent beside each other. */
RgbImage
beside(const RgbImage& left, const RgbImage& right);

} // namespace pcl::acmap
