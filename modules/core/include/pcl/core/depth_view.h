#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief An organized cloud as the picture that its sensor took: inverse depth (1/z) over
 * the pixels of a pinhole camera.
 *
 * Cameras that triangulate (structured light, stereo) measure disparities, so their noise
 * and their rounding are even in inverse depth, and a plane is linear in it:
 * 1/z = a x + b y + c, with x = X/Z and y = Y/Z. \ingroup core */
class DepthView {
public:
  /** \brief Recognizes the camera behind an organized cloud in its sensor's frame: x/z is
   * linear in the column, y/z in the row.
   * \param[in] points metres, row by row; not finite or z <= 0 where nothing was measured
   * \param[in] width pixels of a row; points.size () is a multiple of it
   * \return nothing where fewer than 1,000 points are measured or no pinhole camera fits
   */
  ACMAP_EXPORT static std::optional<DepthView>
  recognize(const PointView& points, std::size_t width);

  std::size_t
  width() const
  {
    return width_;
  }

  std::size_t
  height() const
  {
    return height_;
  }

  std::size_t
  size() const
  {
    return inverse_depths_.size();
  }

  /** \brief Pixels with a measurement. */
  std::size_t
  measured() const
  {
    return measured_;
  }

  /** \brief 1/z of a pixel, 1/m; 0 where nothing was measured. */
  float
  inverseDepth(std::size_t pixel) const
  {
    return inverse_depths_[pixel];
  }

  /** \brief (x, y, 1) with x = X/Z, y = Y/Z at a place in the picture, pixels. */
  Eigen::Vector3d
  ray(double column, double row) const
  {
    return {(column - center_.x()) / focal_.x(), (row - center_.y()) / focal_.y(), 1.0};
  }

  /** \brief Focal lengths in pixels; negative for an axis that runs the other way. */
  const Eigen::Vector2d&
  focal() const
  {
    return focal_;
  }

private:
  DepthView(std::size_t width, std::vector<float> inverse_depths);

  bool
  fitPinhole(const PointView& points);

  std::size_t width_;
  std::size_t height_;
  std::size_t measured_;
  std::vector<float> inverse_depths_;
  Eigen::Vector2d focal_ = Eigen::Vector2d::Ones();
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();
};

/** \brief Where the points of a view stand in the picture that their sensor took. */
struct PictureOrder {
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  std::size_t width = 0;           ///< pixels
  std::size_t height = 0;          ///< pixels
  std::vector<std::size_t> pixels; ///< for each point; \ref nowhere for none

  /** \brief The points pixel by pixel, row by row; NaN where there is none. */
  ACMAP_EXPORT std::vector<Eigen::Vector3f>
  arrange(const PointView& points) const;

  /** \brief The same for a cloud with all its fields: organized, not dense. */
  ACMAP_EXPORT PCLPointCloud2
  arrange(const PCLPointCloud2& cloud) const;

  /** \brief For each point the label of its pixel, -1 where it has none. */
  ACMAP_EXPORT std::vector<std::int32_t>
  labelsOfPoints(const std::vector<std::int32_t>& of_pixels) const;
};

/** \brief Puts the points of a view back into its picture, as when the pixels without a
 * measurement were removed from an organized cloud: x/z has one value per column, y/z one
 * per row, evenly spaced. Takes O(n log n).
 * \param[in] points metres, in their sensor's frame, in any order
 * \return nothing where the points are not those of one pinhole camera's picture */
ACMAP_EXPORT std::optional<PictureOrder>
findPictureOrder(const PointView& points);

/** \brief Finds the even step of inverse depth of points in their sensor's frame. A cloud
 * is quantised when it has few distinct depths for its points and the middle half of the
 * steps between neighbouring ones of 1/z is within +- 20 % of their median.
 * \return the median step, 1/m; 0 where the depth is not quantised */
ACMAP_EXPORT double
measureDepthStep(const PointView& points);

/** \brief Measures the noise of a view's inverse depth on tiles of 4, 8 and 32 pixels that
 * are planes as far as the lower quartile tells.
 * \param[in] step see \ref measureDepthStep; 0 where depth is not quantised */
ACMAP_EXPORT NoiseScale::InverseDepth
measureInverseDepthNoise(const DepthView& view, double step);

} // namespace pcl::acmap
