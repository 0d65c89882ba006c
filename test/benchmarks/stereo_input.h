#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Pixels of an image that are judged, 0 for the others. */
using PixelMask = std::vector<std::uint8_t>;

/** \brief Shots of one place, rectified, and its true disparities. */
struct StereoShots {
  TrinocularRig rig;
  std::vector<TrinocularFrame::ConstPtr> frames;
  DisparityImage truth;
};

/** \brief A left image as the reference and a right one as its neighbour; truth and shots
 * are to be added. */
StereoShots
binocularShots(int width, int height, double focal_length, double baseline);

/** \brief A shot of a reference and its horizontal neighbour. */
TrinocularFrame::ConstPtr
frameOf(CameraImage reference, CameraImage horizontal, std::int32_t pattern);

/** \brief An image of the test data, grey: of colours what OpenCV makes of them, so that
 * all methods have the same.
 * \throws InputFileException */
CameraImage
loadGreyImage(const std::string& relative);

/** \brief A true disparity image of the test data that is stored as a grey PNG; 0 is
 * unknown.
 * \param[in] steps stored values that make 1 px
 * \throws InputFileException */
DisparityImage
loadPngDisparity(const std::string& relative, double steps);

/** \brief The pixels with a truth. */
PixelMask
pixelsWithTruth(const DisparityImage& truth);

/** \brief Whether all files of a section are there; says so where they are not. */
bool
hasAllData(const char* section, const std::vector<std::string>& files);

} // namespace pcl::acmap::bench
