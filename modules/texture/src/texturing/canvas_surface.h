#pragma once

#include "texturing/chart_frame.h"

#include <pcl/core/compact_map.h>

#include <Eigen/Geometry>

#include <variant>

namespace pcl::acmap::texturing {

/** The surface that a canvas shows: the rectangle of a chart on a plane, or a cylinder
 * whose arc and extent are divided into texels. Places are in texels from the top left;
 * lengths in metres, in the frame of the map. */
class CanvasSurface {
public:
  CanvasSurface(const TextureChart& chart, const PlanePatch& plane);

  /** \param[in] size of the picture, texels */
  CanvasSurface(const CylinderPatch& cylinder, const RgbImage& size);

  /** Coefficients of the plane; nullptr for a cylinder. */
  const Eigen::Vector4d*
  plane() const
  {
    const auto* const flat = std::get_if<Rectangle>(&surface_);
    return flat ? &flat->plane : nullptr;
  }

  /** Distance of a point from the plane or the cylinder. */
  double
  distance(const Eigen::Vector3d& point) const;

  /** Can any part of the surface be seen from here? */
  bool
  faces(const Eigen::Vector3d& eye) const;

  /** Is this place of the surface seen from its front, and if it is curved, not grazed? */
  bool
  faces(const Eigen::Vector3d& eye, const Eigen::Vector3d& place) const;

  /** Unit normal at a place of the surface, towards its front. */
  Eigen::Vector3d
  normalAt(const Eigen::Vector3d& place) const;

  /** Projection of a point onto the surface. */
  Eigen::Vector2d
  placeOf(const Eigen::Vector3d& point) const;

  /** Centre of a texel. */
  Eigen::Vector3d
  middleOf(double column, double row) const
  {
    const auto* const flat = std::get_if<Rectangle>(&surface_);
    return flat ? texturing::middleOf(flat->chart, column, row)
                : middleOn(std::get<Unrolled>(surface_), column, row);
  }

  /** Width of a texel. */
  double
  texelWidth() const;

  Eigen::AlignedBox3d
  box() const;

private:
  struct Rectangle {
    TextureChart chart; ///< without colours
    Eigen::Vector4d plane;
  };
  struct Unrolled {
    CylinderPatch cylinder;
    Eigen::Vector2d size; ///< texels
  };

  static Eigen::Vector3d
  middleOn(const Unrolled& surface, double column, double row);

  std::variant<Rectangle, Unrolled> surface_;
};

} // namespace pcl::acmap::texturing
