#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/trinocular_frame.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Converts a camera's image to RGB; a grey image stays grey. */
RgbImage
rgbOf(const CameraImage& image);

/** \brief Resizes a picture; each pixel is the mean of the area that it covers. */
RgbImage
resized(const RgbImage& image, int width, int height);

/** \brief Places rows of pictures below each other. Each row has the width of the
 * sheet, and its pictures have the same height.
 * \param[in] width pixels */
RgbImage
sheetOf(const std::vector<std::vector<RgbImage>>& rows, int width);

/** \brief Quantises the colours of a picture, so that the file of a noisy picture is
 * small.
 * \param[in] step between levels */
RgbImage
withFewLevels(RgbImage image, int step = 8);

/** \brief Brightens a level of a dark picture by a factor of 2.5. */
std::uint8_t
lightened(std::uint8_t level);

/** \brief Brightens a picture by the same factor. */
RgbImage
lightened(RgbImage image);

/** \brief Brightens the colours of points by the same factor. */
void
lighten(PCLPointCloud2& cloud);

/** \brief Disparities as colours, from blue (far) over green to red (near); black if
 * invalid.
 * \param[in] least,most px, the ends of the colour scale */
RgbImage
coloredDisparity(const DisparityImage& image, float least, float most);

/** \brief Returns the picture that a function draws into a given file.
 * \param[in] folder for that file, which is removed again */
RgbImage
drawn(const OutputFolder& folder,
      const std::function<void(const std::string& path)>& draw);

} // namespace pcl::acmap
