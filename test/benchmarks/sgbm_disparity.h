#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <vector>

namespace pcl::acmap::bench {

/** \brief How OpenCV's StereoSGBM is called. */
struct SgbmSetting {
  int least = 0;        ///< px
  int disparities = 64; ///< a multiple of 16
  int prefilter = 15;   ///< grey levels, where its gradients are cut off; its default

  /** \brief Uniqueness (5 %), speckles (100 px, 2 px) and the left-right check (1 px);
   * else only what cannot be switched off. */
  bool filters = true;

  /** \brief Whether the images are widened by the largest disparity: it leaves as many
   * columns empty that others search. */
  bool padded = true;
};

/** \brief Disparities of the reference and its horizontal neighbour by OpenCV's
 * semi-global block matching, of their grey images. */
DisparityImage
sgbmDisparity(const TrinocularFrame& frame,
              const TrinocularRig& rig,
              const SgbmSetting& setting);

/** \brief Of each shot. */
std::vector<DisparityImage>
sgbmDisparities(const std::vector<TrinocularFrame::ConstPtr>& frames,
                const TrinocularRig& rig,
                const SgbmSetting& setting);

/** \brief The lower median at each pixel with at least 3 disparities. */
DisparityImage
medianDisparity(const std::vector<DisparityImage>& images);

} // namespace pcl::acmap::bench
