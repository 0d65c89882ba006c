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

/** \brief A camera's image in colour; a grey one becomes grey in colour. */
RgbImage
rgbOf(const CameraImage& image);

/** \brief A picture in another size, each pixel the mean of what it covers. */
RgbImage
resized(const RgbImage& image, int width, int height);

/** \brief Rows of pictures below each other, each row as wide as the sheet: its pictures
 * become equally high. \param[in] width pixels */
RgbImage
sheetOf(const std::vector<std::vector<RgbImage>>& rows, int width);

/** \brief A picture whose colours have fewer levels, which makes a small file of one with
 * noise. \param[in] step from a level to the next */
RgbImage
withFewLevels(RgbImage image, int step = 8);

/** \brief A level of a picture that was taken in the dark, 2.5 times as light. */
std::uint8_t
lightened(std::uint8_t level);

/** \brief A picture as much lighter. */
RgbImage
lightened(RgbImage image);

/** \brief Makes the colours of points as much lighter. */
void
lighten(PCLPointCloud2& cloud);

/** \brief Disparities as colours, from blue (far) over green to red (near); black where
 * there is none. \param[in] least,most px, the ends of the colours */
RgbImage
coloredDisparity(const DisparityImage& image, float least, float most);

/** \brief What a function draws into the file that it is told.
 * \param[in] folder for that file, which is removed again */
RgbImage
drawn(const OutputFolder& folder,
      const std::function<void(const std::string& path)>& draw);

} // namespace pcl::acmap
