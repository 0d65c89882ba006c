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

/** \brief Heights of a letter and distance of letters for \ref drawText, pixels. */
constexpr int text_height = 10;
constexpr int text_advance = 8;

/** \brief A white picture of pixels. */
RgbImage
whiteImage(int width, int height);

/** \brief Draws a line with soft edges; what lies outside is left out, and so is a line
 * with an end that is not finite.
 * \param[in] width pixels */
void
drawLine(RgbImage& image,
         const Eigen::Vector2d& from,
         const Eigen::Vector2d& to,
         double width,
         const Color& color);

/** \brief Writes letters, digits and `. - + /`; small letters become large, what else
 * there is becomes a blank.
 * \param[in] column,row of the upper left pixel */
void
drawText(
    RgbImage& image, int column, int row, const std::string& text, const Color& color);

/** \brief Copies a picture into a larger one, which it must fit into. */
void
paste(const RgbImage& from, int column, int row, RgbImage& to);

/** \brief A round length for ticks and scale bars: the largest of 1, 2 and 5 times
 * powers of ten that is at most \a most, which is finite and above 0. */
double
roundLength(double most);

} // namespace pcl::acmap
