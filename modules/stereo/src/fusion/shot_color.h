#pragma once

#include <pcl/core/trinocular_frame.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Mean colour of images of one size. */
class ShotColor {
public:
  /** \brief Sums of up to this many images do not overflow. */
  static constexpr std::size_t max_images = 257;

  /** \param[in] width, height of the images, px */
  ShotColor(int width, int height);

  /** \brief Adds an image; a grey image counts as three equal channels. Runs in the
   * caller's arena.
   * \param[in] image complete, of the given size */
  void
  add(const CameraImage& image);

  std::size_t
  images() const
  {
    return images_;
  }

  /** \brief Rounded mean, three channels; empty without images. */
  CameraImage
  mean() const;

private:
  int width_;
  int height_;
  std::size_t images_ = 0;
  std::vector<std::uint16_t> sums_; // three channels
};

} // namespace pcl::acmap
