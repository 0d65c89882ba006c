#pragma once

#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What a frame file tells of one image, before it comes. */
struct ImageRecord {
  std::uint32_t width = 0; ///< pixels; 0: there is no such camera
  std::uint32_t height = 0;
  std::uint32_t channels = 1;
  std::uint32_t packing = 0; ///< 0: as it is, 1: packed by packImage
  std::uint64_t bytes = 0;   ///< in the file

  std::uint64_t
  values() const
  {
    return std::uint64_t{width} * height * channels;
  }
};

/** \brief What stands before the images of a frame file. */
struct FrameHeader {
  std::uint64_t number = 0;
  std::int32_t observation = 0;
  std::int32_t pattern = TrinocularFrame::no_pattern;
  std::uint64_t stamp = 0; ///< microseconds
  std::array<ImageRecord, 3> images;
};

/** \brief Length of the header in a file, magic word and version with it. */
constexpr std::size_t frame_header_bytes = 108;

/** \brief The header of a frame whose images are not packed. */
FrameHeader
headerOf(const TrinocularFrame& frame);

/** \brief Why no frame can be like this; empty when one can. */
std::string
faultOf(const FrameHeader& header);

/** \brief The bytes of a frame file; see doc/acquisition/frame_file.md.
 * \throws BadArgumentException when a frame cannot be like this, naming its number */
std::vector<std::uint8_t>
encodeFrame(const TrinocularFrame& frame);

/** \brief Reads the header and holds it against the length of the file.
 * \param[in] name stands for the file in messages
 * \param[in] data at least min(frame_header_bytes, file_bytes) bytes
 * \throws InputFileException naming file, frame as far as known, and fault */
FrameHeader
decodeFrameHeader(const std::string& name,
                  const std::uint8_t* data,
                  std::uint64_t file_bytes);

/** \brief Reads a whole file.
 * \throws InputFileException as above; also when the checksum is wrong */
TrinocularFrame
decodeFrame(const std::string& name, const std::vector<std::uint8_t>& bytes);

/** \brief The checksum that ends a file: CRC-32 of all bytes before it. */
std::uint32_t
checksumOf(const std::uint8_t* data, std::size_t bytes);

/** \brief Reads and checks no more than the header of a file. */
FrameHeader
loadFrameHeader(const std::string& path);

} // namespace pcl::acmap
