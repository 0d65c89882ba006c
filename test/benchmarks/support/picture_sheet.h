#pragma once

#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>

#include <string>

namespace pcl::acmap::bench {

/** \brief A grid of pictures of the same size, scaled down, with 64 levels per colour
 * for a small file. */
class PictureSheet {
public:
  /** \param[in] width of a picture, px
   * \param[in] height of a picture, px
   * \param[in] smaller divisor of the size */
  PictureSheet(int columns, int rows, int width, int height, int smaller);

  /** \param[in] image in colour or grey, of the given size */
  void
  put(int column, int row, const CameraImage& image);

  /** \throws OutputFileException when the file could not be written */
  void
  save(const std::string& path) const;

private:
  std::uint8_t
  meanOf(const CameraImage& image, int x, int y, int channel) const;

  int smaller_;
  int width_;
  int height_;
  RgbImage sheet_;
};

} // namespace pcl::acmap::bench
