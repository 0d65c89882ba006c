#pragma once

#include <pcl/core/image_file.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace pcl::acmap {

using Color = std::array<std::uint8_t, 3>; ///< red, green, blue

constexpr Color black = {0, 0, 0};
constexpr Color gray = {150, 150, 150};
constexpr Color red = {200, 30, 40};
constexpr Color blue = {25, 90, 190};

/** \brief Height of a letter and distance between letters for \ref drawText, pixels. */
constexpr int text_height = 10;
constexpr int text_advance = 8;

/** \brief Creates a white picture. */
RgbImage
whiteImage(int width, int height);

/** \brief Draws an anti-aliased line; parts outside of the image are clipped. A line
 * with an end that is not finite is not drawn.
 * \param[in] width pixels */
void
drawLine(RgbImage& image,
         const Eigen::Vector2d& from,
         const Eigen::Vector2d& to,
         double width,
         const Color& color);

/** \brief Draws letters, digits and `. - + /`; lower case letters are drawn as upper
 * case, other characters as blanks.
 * \param[in] column,row of the upper left pixel */
void
drawText(
    RgbImage& image, int column, int row, const std::string& text, const Color& color);

/** \brief Copies a picture into a larger one; it must fit. */
void
paste(const RgbImage& from, int column, int row, RgbImage& to);

/** \brief A round length for ticks and scale bars: the maximum of 1, 2 and 5 times
 * powers of ten that is not above \a most, which is finite and above 0. */
double
roundLength(double most);

} // namespace pcl::acmap
