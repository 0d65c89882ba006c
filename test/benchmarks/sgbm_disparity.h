#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <vector>

namespace pcl::acmap::bench {

/** \brief Parameters of OpenCV's StereoSGBM. */
struct SgbmSetting {
  int minimum = 0;      ///< px
  int disparities = 64; ///< a multiple of 16
  int prefilter = 15;   ///< grey levels, clipping of its gradients; the default

  /** \brief Uniqueness (5 %), speckles (100 px, 2 px) and the left-right check (1 px);
   * false: only those that cannot be switched off. */
  bool filters = true;

  /** \brief Widens the images by the maximum disparity, because SGBM leaves this number
   * of columns empty. */
  bool padded = true;
};

/** \brief Disparities of the reference and its horizontal neighbour from OpenCV's
 * semi-global block matching of their grey images. */
DisparityImage
sgbmDisparity(const TrinocularFrame& frame,
              const TrinocularRig& rig,
              const SgbmSetting& setting);

/** \brief As above for each shot. */
std::vector<DisparityImage>
sgbmDisparities(const std::vector<TrinocularFrame::ConstPtr>& frames,
                const TrinocularRig& rig,
                const SgbmSetting& setting);

/** \brief The lower median at each pixel with at least 3 disparities. */
DisparityImage
medianDisparity(const std::vector<DisparityImage>& images);

} // namespace pcl::acmap::bench
