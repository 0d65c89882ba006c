#pragma once

#include <pcl/core/trinocular_frame.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Coverage of a view by the patterns so far: the share of its pixels whose grey
 * level has changed enough from shot to shot. Grey levels are smoothed over 3 x 3
 * pixels first, so that the noise of the camera does not count: it reduces a standard
 * deviation of 4 levels to 1.5. A shot costs two sums per pixel. */
class ShotCoverage {
public:
  /** \brief Sums of up to this many shots do not overflow. */
  static constexpr std::size_t max_shots = 257;

  /** \param[in] width, height of the images, px */
  ShotCoverage(int width, int height);

  /** \brief Sets the view without a pattern, with which the first shot is compared
   * while there is no second one. Runs in the caller's arena, as \ref add does.
   * \param[in] image complete, of the given size */
  void
  setDark(const CameraImage& image);

  /** \brief Adds a shot with a pattern. */
  void
  add(const CameraImage& image);

  /** \brief Share of the pixels, in [0, 1], whose standard deviation over the shots so
   * far is at least this, in grey levels; 0 if there is nothing to compare. */
  double
  share(double deviation) const;

private:
  void
  smooth(const CameraImage& image, std::vector<std::uint16_t>& smoothed) const;

  int width_;
  int height_;
  std::uint32_t shots_ = 0;
  std::vector<std::uint16_t> dark_; // 16ths of a grey level, like the following members
  std::vector<std::uint16_t> last_;
  std::vector<std::uint32_t> sums_;
  std::vector<std::uint32_t> squares_;
};

} // namespace pcl::acmap
