#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/simulation/simulated_scene.h>
#include <pcl/simulation/simulated_truth.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Nonzero for pixels of an image that are evaluated. */
using PixelMask = std::vector<std::uint8_t>;

/** \brief Rectified shots of one place, with its true disparities. */
struct StereoShots {
  TrinocularRig rig;
  std::vector<TrinocularFrame::ConstPtr> frames;
  DisparityImage truth;
};

/** \brief Creates shots with a left image as the reference and a right one as its
 * neighbour; truth and frames must be added. */
StereoShots
binocularShots(int width, int height, double focal_length, double baseline);

/** \brief A shot of a reference and its horizontal neighbour. */
TrinocularFrame::ConstPtr
frameOf(CameraImage reference, CameraImage horizontal, std::int32_t pattern);

/** \brief Loads an image of the test data as grey. Colours are converted by OpenCV, so
 * that all methods get the same image.
 * \throws InputFileException */
CameraImage
loadGreyImage(const std::string& relative);

/** \brief Loads a true disparity image of the test data that is stored as a grey PNG; 0
 * is unknown.
 * \param[in] steps stored units per px
 * \throws InputFileException */
DisparityImage
loadPngDisparity(const std::string& relative, double steps);

/** \brief The pixels with a true disparity. */
PixelMask
pixelsWithTruth(const DisparityImage& truth);

/** \brief An observation of a simulated scene: ten shots with patterns, one without,
 * and the complete truth. */
struct SimulatedShots {
  StereoShots shots; ///< with patterns; the truth for the horizontal neighbour
  TrinocularFrame::ConstPtr off;
  SimulatedTruth truth;
};

/** \brief The standard rig in front of a blank wall at 3 m, with a box at 1.5 m that
 * occludes a part of it; two oblique views, so that the wall has many disparities. */
SimulatedScene
wallWithBox();

/** \brief The wall alone, from more oblique views. */
SimulatedScene
slantedWall();

/** \brief Simulates the shots of a view, under ten patterns of random lines. */
SimulatedShots
takeShots(const SimulatedScene& scene, std::size_t view);

/** \brief The same shots without the vertical neighbour. */
StereoShots
withoutVertical(const StereoShots& shots);

} // namespace pcl::acmap::bench
