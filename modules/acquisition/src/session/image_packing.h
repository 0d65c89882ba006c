#pragma once

#include <pcl/core/trinocular_frame.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Packs an image without loss: each value less the one above it, then deflated by
 * runs and Huffman's code alone. Neighbours in a noisy image repeat too seldom for a
 * search to pay: it takes twice the time and finds less.
 * \return nothing when it would not become smaller */
std::optional<std::vector<std::uint8_t>>
packImage(const CameraImage& image);

/** \brief Undoes \ref packImage.
 * \param[in,out] image has its shape, and room for its values
 * \return false when the bytes are no packed image of just this shape */
bool
unpackImage(const std::uint8_t* packed, std::size_t bytes, CameraImage& image);

/** \brief More values than these no packed byte holds. */
constexpr std::uint64_t most_values_per_packed_byte = 1032;

} // namespace pcl::acmap
