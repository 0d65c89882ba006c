#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief The disparity of each pixel of a reference view with respect to a
 * neighbouring view, in px: focal length times baseline over depth. Rows from the top,
 * each from the left; NaN for pixels without a disparity. \ingroup core */
struct DisparityImage {
  std::int32_t width = 0;    ///< pixels
  std::int32_t height = 0;   ///< pixels
  std::vector<float> values; ///< width * height, px

  float&
  at(std::int32_t column, std::int32_t row)
  {
    return values[index(column, row)];
  }

  float
  at(std::int32_t column, std::int32_t row) const
  {
    return values[index(column, row)];
  }

private:
  std::size_t
  index(std::int32_t column, std::int32_t row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

/** \brief Writes a grey PFM ("Pf"), little-endian. NaN becomes infinity, which is the
 * convention of the Middlebury benchmark.
 * \throws BadArgumentException if the image is empty, has more than 2^28 pixels or an
 * incomplete array of values
 * \throws OutputFileException when the file could not be written completely
 * \ingroup core */
ACMAP_EXPORT void
savePfm(const std::string& path, const DisparityImage& image);

/** \brief Reads a grey PFM of either byte order; its scale is not applied. Values that
 * are not finite become NaN.
 * \throws InputFileException naming file and fault: missing, not a grey PFM, invalid
 * size, fewer or more bytes than the header claims \ingroup core */
ACMAP_EXPORT DisparityImage
loadPfm(const std::string& path);

} // namespace pcl
