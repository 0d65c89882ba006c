#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace pcl::acmap {

class ByteSource;

constexpr std::uint64_t max_pixels = std::uint64_t{1} << 28;

/** \brief Thrown by a decoder; the caller adds the file name. */
class DamagedImage : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

using ImageBytes = std::vector<std::uint8_t>;

bool
isPng(const ImageBytes& bytes);

bool
isJpeg(const ImageBytes& bytes);

/** \brief Returns true for a binary PGM or PPM. */
bool
isPnm(const ImageBytes& bytes);

/** \throws DamagedImage */
RgbImage
decodePng(const ImageBytes& bytes);

/** \throws DamagedImage */
GrayImage16
decodeGrayPng(const ImageBytes& bytes);

/** \throws DamagedImage */
RgbImage
decodeJpeg(const ImageBytes& bytes);

/** \brief Decodes an image of 8 bits; grey is converted to colour.
 * \throws DamagedImage */
RgbImage
decodePnm(const ImageBytes& bytes);

/** \brief Decodes a PGM of 8 or 16 bits.
 * \throws DamagedImage */
GrayImage16
decodeGrayPnm(const ImageBytes& bytes);

/** \brief Rejects sizes that are not valid, or too large for the number of bytes.
 * \param[in] pixels_per_byte maximum number of pixels that the format can store in a
 * byte
 * \throws DamagedImage */
void
requireImageSize(std::uint64_t width,
                 std::uint64_t height,
                 double pixels_per_byte,
                 std::size_t bytes);

/** \throws BadArgumentException if the image is empty or its array of values is
 * incomplete */
void
requireImageValues(std::int32_t width,
                   std::int32_t height,
                   std::size_t channels,
                   std::size_t values);

/** \throws BadArgumentException as above */
void
requireWholeImage(const RgbImage& image);

/** \brief Implementation of \ref loadPfm.
 * \throws InputFileException naming the fault */
DisparityImage
readPfm(ByteSource& source);

/** \brief Returns the bytes that \ref savePfm writes.
 * \throws BadArgumentException as \ref savePfm */
std::vector<std::uint8_t>
encodePfm(const DisparityImage& image);

} // namespace pcl::acmap
