#pragma once

#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>

#include <string>

namespace pcl::acmap::bench {

/** \brief Rows of pictures of one size, each made smaller; in 64 levels a colour, for a
 * small file. */
class PictureSheet {
public:
  /** \param[in] width of a picture, px
   * \param[in] height of a picture, px
   * \param[in] smaller how many times smaller it becomes */
  PictureSheet(int columns, int rows, int width, int height, int smaller);

  /** \param[in] image in colour or grey, of the set size */
  void
  put(int column, int row, const CameraImage& image);

  /** \throws OutputFileException when it could not be written */
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
