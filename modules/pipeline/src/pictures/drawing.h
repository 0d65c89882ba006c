#pragma once

#include <pcl/core/image_file.h>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace pcl::acmap {

using Color = cv::Vec3b; ///< red, green, blue

inline std::array<std::uint8_t, 3>
channelsOf(const Color& color)
{
  return {color[0], color[1], color[2]};
}

inline const Color white(255, 255, 255);
inline const Color black(0, 0, 0);
inline const Color gray(150, 150, 150);
inline const Color red(200, 30, 40);
inline const Color blue(25, 90, 190);

/** \brief The pixels of a picture as a matrix of OpenCV, without a copy. */
cv::Mat3b
matOf(RgbImage& image);

/** \brief Copies a matrix with the channels red, green, blue. */
RgbImage
rgbImageOf(const cv::Mat3b& matrix);

/** \brief Two pictures of the same height side by side. */
RgbImage
beside(RgbImage left, RgbImage right);

/** \brief Draws a line; parts outside of the image are clipped. A line with an end that
 * is not finite is not drawn.
 *
 * Slanted and thick lines are anti-aliased.
 * \param[in] width pixels */
void
drawLine(cv::Mat3b& image,
         const Eigen::Vector2d& from,
         const Eigen::Vector2d& to,
         int width,
         const Color& color);

/** \brief Draws a filled circle. */
void
drawDot(cv::Mat3b& image, const Eigen::Vector2d& at, int radius, const Color& color);

/** \brief Draws ASCII text with a thin white border, so that it is legible on lines.
 * \param[in] at a point at half the height of the text
 * \param[in] share fraction of the text that is left of this point
 * \return width of the text in pixels */
int
drawText(cv::Mat3b& image,
         const Eigen::Vector2d& at,
         const std::string& text,
         const Color& color,
         double share = 0);

/** \brief A round length for ticks and scale bars: the maximum of 1, 2 and 5 times
 * powers of ten that is not above \a maximum, which is finite and above 0. */
double
roundLength(double maximum);

/** \brief A plot with axes, ticks and a grid: x to the right and y upwards. */
class Plot {
public:
  /** \param[in] size of the part within the axes, pixels
   * \param[in] shown range of x and y, not empty
   * \param[in] x_name,y_name titles of the axes, with their units */
  Plot(const cv::Size& size,
       const Eigen::AlignedBox2d& shown,
       const std::string& x_name,
       const std::string& y_name);

  /** \brief Position within \ref inside. */
  Eigen::Vector2d
  pixelOf(double x, double y) const;

  /** \brief The part within the axes: what is drawn into it is clipped to it. */
  cv::Mat3b&
  inside()
  {
    return inside_;
  }

  /** \brief Adds an entry to the legend, from left to right. */
  void
  addToLegend(const std::string& text, const Color& color);

  /** \brief The complete picture. */
  RgbImage
  picture();

private:
  /** \brief Draws grid lines and numbers along x (0) or y (1). */
  void
  drawTicks(int axis);

  Eigen::AlignedBox2d shown_;
  cv::Mat3b whole_, inside_; // inside_ is a part of whole_
  int legend_column_;        // of the next entry
};

} // namespace pcl::acmap
