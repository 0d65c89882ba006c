#pragma once

#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/moments.h>

namespace pcl::acmap::depth {

/** Coefficients (a, b, c) of 1/z = a x + b y + c. */
using InversePlane = Eigen::Vector3d;

/** Regression of the inverse depth of some pixels against their rays. */
struct InverseFit {
  InversePlane plane = InversePlane::Zero();
  double rms = 0; ///< 1/m, about the plane
};

/** \param[in] moments of (x, y, 1/z) */
InverseFit
fitInverse(const Moments& moments);

/** Residuals of pixels to a plane. */
struct Residual {
  double mean = 0; ///< 1/m
  double rms = 0;  ///< 1/m, about zero
};

Residual
residualOf(const Moments& moments, const InversePlane& plane);

/** Moments of (x, y, 1/z) over square tiles of a view. */
class TileMoments {
public:
  /** \param[in] view the depth view
   * \param[in] edge pixels; tiles at the right and lower border may be smaller */
  TileMoments(const DepthView& view, std::size_t edge);

  /** Pixels. */
  std::size_t
  edge() const
  {
    return edge_;
  }

  std::size_t
  columns() const
  {
    return columns_;
  }

  std::size_t
  rows() const
  {
    return rows_;
  }

  std::size_t
  size() const
  {
    return tiles_.size();
  }

  const Moments&
  operator[](std::size_t tile) const
  {
    return tiles_[tile];
  }

private:
  std::size_t edge_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<Moments> tiles_;
};

} // namespace pcl::acmap::depth
