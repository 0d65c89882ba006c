#pragma once

#include <pcl/core/impl/point_view.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief What a sensor saw from its origin: the smallest and the largest range in directions
 * that are the pixels of a cube around it, and a sample of the points. */
class RangeView {
public:
  /** \param[in] points sensor frame, metres; those that are not finite are left out. O(n)
   * \param[in] is_depth_image is the noise that of a depth camera, which grows with the square
   * of the range, or that of a laser? */
  RangeView(const PointView& points, bool is_depth_image);

  /** \brief Some of the points, at most a few thousand. */
  const std::vector<Eigen::Vector3f>&
  sample() const
  {
    return sample_;
  }

  /** \brief How well the sample of another view agrees with this one: the mean, over the points
   * where this view saw something and over half of all points at least, of
   * log (.3 + 8 exp (-e^2 / 2 s^2)) for points that may be on a surface of this view, with their
   * distance e to it and the noise s; -2 for those through which this view looked, -.5 for those
   * behind what it saw. */
  double
  agreementWith(const RangeView& other, const Eigen::Isometry3d& T_this_other) const;

private:
  struct Ranges {
    float low = 0, high = 0; ///< metres; 0 if nothing was seen

    void
    add(float range);
  };

  /** \brief Square pixels of a face of the cube whose axis is +-x, +-y or +-z. */
  struct Face {
    std::vector<Ranges> pixels; ///< row by row; empty if nothing was seen
  };

  struct Place {
    std::size_t face;
    int column, row;
  };

  Place
  placeOf(const Eigen::Vector3f& point) const;

  void
  fill(const std::vector<Eigen::Vector3f>& points);

  double
  sigma(double range) const;

  std::optional<double>
  agreementAt(const Eigen::Vector3f& point) const;

  int edge_ = 0; ///< pixels of the edge of a face
  bool is_depth_image_;
  Face faces_[6];
  std::vector<Eigen::Vector3f> sample_;
};

/** \brief Agreement of two views, both ways, as 180 rays would give it: a good pair has some
 * 300. */
double
agreementOf(const RangeView& a, const RangeView& b, const Eigen::Isometry3d& T_a_b);

} // namespace pcl::acmap
