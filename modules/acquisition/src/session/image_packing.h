#pragma once

#include <pcl/core/trinocular_frame.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Compresses an image without loss: differences of each row to the row above,
 * then deflate with run lengths and Huffman coding only. Noisy images contain too few
 * repetitions for a search of matches: it would take twice the time and compress less.
 * \return nothing if the image would not become smaller */
std::optional<std::vector<std::uint8_t>>
packImage(const CameraImage& image);

/** \brief Decompresses the result of \ref packImage.
 * \param[in] packed data
 * \param[in] bytes length of the data
 * \param[in,out] image its size is set, and its memory is allocated
 * \return false when the data is not a compressed image of exactly this size */
bool
unpackImage(const std::uint8_t* packed, std::size_t bytes, CameraImage& image);

/** \brief Maximum number of values per compressed byte. */
constexpr std::uint64_t max_values_per_packed_byte = 1032;

} // namespace pcl::acmap
