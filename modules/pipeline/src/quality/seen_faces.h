#pragma once

#include "quality/plan_places.h"

#include <pcl/core/plane_patch.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap {

/** \brief The polygons of a plane in coordinates of the plane, for questions where it was seen. */
class SeenFace {
public:
  explicit SeenFace(const PlanePatch& plane)
  : plane_(plane)
  {
    for (const PlanePolygon& polygon : plane.polygons) {
      Face face;
      face.loops.push_back(flat(polygon.outer));
      for (const auto& hole : polygon.holes)
        face.loops.push_back(flat(hole));
      for (const Eigen::Vector2d& corner : face.loops.front())
        face.box.extend(corner);
      faces_.push_back(std::move(face));
    }
  }

  Eigen::Vector3d
  normal() const
  {
    return plane_.coefficients.head<3>();
  }

  double
  distanceTo(const Eigen::Vector3d& point) const
  {
    return plane_.coefficients.dot(point.homogeneous());
  }

  /** \brief Is a point, projected along the normal, on one of the polygons? */
  bool
  covers(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector2d place = flat(point);
    for (const Face& face : faces_)
      if (face.box.contains(place) && isInside(face.loops, place))
        return true;
    return false;
  }

  const PlanePatch&
  plane() const
  {
    return plane_;
  }

private:
  struct Face {
    std::vector<std::vector<Eigen::Vector2d>> loops;
    Eigen::AlignedBox2d box;
  };

  Eigen::Vector2d
  flat(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d arm = point - plane_.center;
    return {arm.dot(plane_.axis_u), arm.dot(plane_.axis_v)};
  }

  std::vector<Eigen::Vector2d>
  flat(const std::vector<Eigen::Vector3f>& loop) const
  {
    std::vector<Eigen::Vector2d> places;
    for (const Eigen::Vector3f& corner : loop)
      places.push_back(flat(corner.cast<double>().eval()));
    return places;
  }

  const PlanePatch& plane_;
  std::vector<Face> faces_;
};

} // namespace pcl::acmap
