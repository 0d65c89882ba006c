#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief Throws with a fault. */
using UnpackingFault = std::function<void(const std::string& fault)>;

/** \brief Unpacks a chunk. Memory grows as bytes are unpacked, not by what is claimed.
 * \param[in] packing lz4 (frames), zstd, bz2, or empty
 * \param[in] bytes number of bytes that are expected
 * \param[in] fail is called, and has to throw, for another packing, damaged data, and
 * another number of bytes */
std::string
unpackChunk(std::string_view packing,
            std::string_view packed,
            std::uint64_t bytes,
            const UnpackingFault& fail);

} // namespace pcl::acmap
