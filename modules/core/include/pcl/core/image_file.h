#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief A colour image: rows from the top, each from the left; red, green, blue.
 * \ingroup core */
struct RgbImage {
  std::int32_t width = 0; ///< pixels
  std::int32_t height = 0;
  std::vector<std::uint8_t> values; ///< 3 * width * height

  std::uint8_t*
  at(std::int32_t column, std::int32_t row)
  {
    return &values[3 *
                   (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column))];
  }

  const std::uint8_t*
  at(std::int32_t column, std::int32_t row) const
  {
    return const_cast<RgbImage*>(this)->at(column, row);
  }
};

/** \brief An image with one number per pixel, such as a depth image in millimetres.
 * \ingroup core */
struct GrayImage16 {
  std::int32_t width = 0; ///< pixels
  std::int32_t height = 0;
  std::vector<std::uint16_t> values; ///< width * height, rows from the top
};

/** \brief Reads a PNG, a JPEG, or a binary PGM or PPM of 8 bits. The format is
 * determined from the first bytes of the file, not from its name. Grey images are
 * converted to colour, transparency is dropped.
 * \throws InputFileException when it is missing, of another format, truncated, damaged,
 * or has more than 2^28 pixels \ingroup core */
ACMAP_EXPORT RgbImage
loadRgbImage(const std::string& path);

/** \brief Reads a PNG or a PGM of one channel, of 8 or 16 bits; the values are not scaled.
 * \throws InputFileException as above, and when it has colour \ingroup core */
ACMAP_EXPORT GrayImage16
loadGrayImage16(const std::string& path);

/** \brief Encodes an image as PNG.
 * \throws BadArgumentException if the image is empty, has more than 2^28 pixels or an
 * incomplete array of values \ingroup core */
ACMAP_EXPORT std::vector<std::uint8_t>
encodePng(const RgbImage& image);

/** \brief Encodes a grey image as PNG: 8 bits per pixel, rows from the top.
 * \throws BadArgumentException as above \ingroup core */
ACMAP_EXPORT std::vector<std::uint8_t>
encodePng(std::int32_t width,
          std::int32_t height,
          const std::vector<std::uint8_t>& values);

/** \brief Writes a PNG.
 * \throws BadArgumentException as above
 * \throws OutputFileException when the file could not be written completely
 * \ingroup core */
ACMAP_EXPORT void
savePng(const std::string& path, const RgbImage& image);

/** \brief Writes a grey image as PNG; throws as above. \ingroup core */
ACMAP_EXPORT void
savePng(const std::string& path,
        std::int32_t width,
        std::int32_t height,
        const std::vector<std::uint8_t>& values);

/** \brief Encodes an image as JPEG.
 * \param[in] quality 1 to 100
 * \throws BadArgumentException as above, if the quality is outside of its range, or if
 * a side is longer than 65,500 pixels \ingroup core */
ACMAP_EXPORT std::vector<std::uint8_t>
encodeJpeg(const RgbImage& image, int quality);

} // namespace pcl
