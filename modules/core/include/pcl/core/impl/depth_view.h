#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/pinhole.h>
#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief An organized cloud as the depth image of its sensor: inverse depth (1/z) over
 * the pixels of a pinhole camera.
 *
 * Sensors that triangulate (structured light, stereo) measure disparities, so their
 * noise and their quantisation are uniform in inverse depth, in which a plane is
 * linear: 1/z = a x + b y + c, with x = X/Z and y = Y/Z. \ingroup core */
class DepthView {
public:
  /** \brief Estimates the pinhole camera of an organized cloud in the frame of its
   * sensor (\ref fitPinhole).
   * \param[in] points metres, row by row; not finite or z <= 0 for pixels without a
   * measurement
   * \param[in] width pixels per row; points.size () is a multiple of it
   * \return nothing if fewer than 1,000 points are measured or no pinhole camera fits
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

  /** \brief Number of pixels with a measurement. */
  std::size_t
  measured() const
  {
    return measured_;
  }

  /** \brief 1/z of a pixel, 1/m; 0 for pixels without a measurement. */
  float
  inverseDepth(std::size_t pixel) const
  {
    return inverse_depths_[pixel];
  }

  /** \brief (x, y, 1) with x = X/Z, y = Y/Z at an image position in pixels. */
  Eigen::Vector3d
  ray(double column, double row) const
  {
    return {(column - camera_.cx) / camera_.fx, (row - camera_.cy) / camera_.fy, 1.0};
  }

  /** \brief The ray of a pixel. */
  Eigen::Vector3d
  rayOf(std::size_t column, std::size_t row) const
  {
    return {x_of_column_[column], y_of_row_[row], 1.0};
  }

  /** \brief Focal lengths in pixels; negative for an axis in the opposite direction. */
  Eigen::Vector2d
  focal() const
  {
    return {camera_.fx, camera_.fy};
  }

private:
  DepthView(std::size_t width, std::vector<float> inverse_depths);

  std::size_t width_;
  std::size_t height_;
  std::size_t measured_;
  std::vector<float> inverse_depths_;
  Pinhole camera_;
  std::vector<double> x_of_column_, y_of_row_; ///< of the rays
};

/** \brief Image positions of the points of a view. */
struct PictureOrder {
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  std::size_t width = 0;           ///< pixels
  std::size_t height = 0;          ///< pixels
  std::vector<std::size_t> pixels; ///< of each point; \ref nowhere for none

  /** \brief Returns the points pixel by pixel, row by row; NaN for pixels without a
   * point. */
  ACMAP_EXPORT std::vector<Eigen::Vector3f>
  arrange(const PointView& points) const;

  /** \brief The same for a cloud with all its fields: organized, not dense. */
  ACMAP_EXPORT PCLPointCloud2
  arrange(const PCLPointCloud2& cloud) const;

  /** \brief Returns for each point the label of its pixel, -1 if it has none. */
  ACMAP_EXPORT PointLabels
  labelsOfPoints(const PointLabels& of_pixels) const;
};

/** \brief Restores the image order of the points of a view, for example of an organized
 * cloud from which the pixels without a measurement were removed: x/z has one value per
 * column, y/z one per row, evenly spaced. Takes O(n log n).
 * \param[in] points metres, in the frame of their sensor, in any order
 * \return nothing if the points are not the image of one pinhole camera */
ACMAP_EXPORT std::optional<PictureOrder>
findPictureOrder(const PointView& points);

/** \brief The points of a view in the order of its image: those of an organized cloud as
 * they are, others restored by \ref findPictureOrder. Valid as long as the points are
 * unchanged. */
class PictureView {
public:
  /** \param[in] points metres, in the frame of their sensor
   * \param[in] width pixels per row; the number of all points if they are not organized
   * \return nothing if the order of points that are not organized cannot be restored */
  ACMAP_EXPORT static std::optional<PictureView>
  find(const PointView& points, std::size_t width);

  /** \brief Points row by row, NaN for pixels without a point. */
  PointView
  points() const
  {
    return order_ ? PointView(arranged_.data(), sizeof arranged_[0], arranged_.size())
                  : points_;
  }

  /** \brief Pixels per row. */
  std::size_t
  width() const
  {
    return width_;
  }

  /** \brief Set if the points were not organized. */
  const std::optional<PictureOrder>&
  order() const
  {
    return order_;
  }

private:
  PictureView(const PointView& points, std::size_t width)
  : points_(points)
  , width_(width)
  {}

  PointView points_;
  std::size_t width_;
  std::optional<PictureOrder> order_;
  std::vector<Eigen::Vector3f> arranged_;
};

/** \brief Finds the uniform step of inverse depth of points in the frame of their
 * sensor. The depth of a cloud is quantised if the number of distinct depths is small
 * compared with the number of points and the middle half of the steps between
 * neighbouring values of 1/z is within +- 20 % of their median, which is above 1e-5 1/m.
 * \return the median step, 1/m; 0 if the depth is not quantised */
ACMAP_EXPORT double
measureDepthStep(const PointView& points);

/** \brief Measures the noise of the inverse depth of a view, on tiles of 4, 8 and 32
 * pixels in width. The lower quartile of the tiles is assumed to be planar. Without
 * quantisation, noise that is independent between pixels is measured by depth, too.
 * \param[in] step see \ref measureDepthStep; 0 if the depth is not quantised */
ACMAP_EXPORT NoiseScale::InverseDepth
measureInverseDepthNoise(const DepthView& view, double step);

/** \brief A depth view and its noise. */
struct MeasuredDepthView {
  DepthView view;
  NoiseScale::InverseDepth noise;
};

/** \brief Recognizes a view (\ref DepthView::recognize) and measures its noise. */
ACMAP_EXPORT std::optional<MeasuredDepthView>
measureDepthView(const PointView& points, std::size_t width);

/** \brief Reason why there is no view, for the remarks of a report. */
inline constexpr const char* no_depth_view =
    "fewer than 1000 pixels are measured, or no pinhole camera fits them: the view is "
    "not in its sensor's frame";

} // namespace pcl::acmap
