#pragma once

#include <pcl/core/image_file.h>

#include <stdexcept>

namespace pcl::acmap {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;

/** \brief What a decoder throws; the file's name is added where it is known. */
class DamagedImage : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

using ImageBytes = std::vector<std::uint8_t>;

bool
isPng(const ImageBytes& bytes);

bool
isJpeg(const ImageBytes& bytes);

/** \brief A binary PGM or PPM. */
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

/** \brief Of 8 bits; grey becomes colour.
 * \throws DamagedImage */
RgbImage
decodePnm(const ImageBytes& bytes);

/** \brief Refuses sizes that no image can have, or that this many bytes cannot fill.
 * \param[in] pixels_per_byte more than these the format cannot pack into a byte
 * \throws DamagedImage */
void
requireImageSize(std::uint64_t width,
                 std::uint64_t height,
                 double pixels_per_byte,
                 std::size_t bytes);

/** \throws BadArgumentException when the image is empty or has not all its values */
void
requireImageValues(std::int32_t width,
                   std::int32_t height,
                   std::size_t channels,
                   std::size_t values);

/** \throws BadArgumentException as above */
void
requireWholeImage(const RgbImage& image);

} // namespace pcl::acmap
