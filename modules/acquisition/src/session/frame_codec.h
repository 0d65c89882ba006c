#pragma once

#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Header of one image in a frame file. */
struct ImageRecord {
  std::uint32_t width = 0; ///< pixels; 0: there is no such camera
  std::uint32_t height = 0;
  std::uint32_t channels = 1;
  std::uint32_t packing = 0; ///< 0: none, 1: packed by packImage
  std::uint64_t bytes = 0;   ///< length of the data in the file

  std::uint64_t
  values() const
  {
    return std::uint64_t{width} * height * channels;
  }
};

/** \brief Header of a frame file, which precedes the images. */
struct FrameHeader {
  std::uint64_t number = 0;
  std::int32_t observation = 0;
  std::int32_t pattern = TrinocularFrame::no_pattern;
  std::uint64_t stamp = 0; ///< microseconds
  std::array<ImageRecord, 3> images;
};

/** \brief Length of the header in a file, including magic word and version. */
constexpr std::size_t frame_header_bytes = 108;

/** \brief The header of a frame, for images that are not packed. */
FrameHeader
headerOf(const TrinocularFrame& frame);

/** \brief The reason why a frame is invalid; empty if it is valid. */
std::string
faultOf(const FrameHeader& header);

/** \brief Encodes a frame as the content of a file; see doc/acquisition/frame_file.md.
 * \throws BadArgumentException naming the frame's number when the frame is invalid */
std::vector<std::uint8_t>
encodeFrame(const TrinocularFrame& frame);

/** \brief Reads the header and checks it against the length of the file.
 * \param[in] name of the file, for messages
 * \param[in] data at least min(frame_header_bytes, file_bytes) bytes
 * \param[in] file_bytes length of the file
 * \throws InputFileException naming the file, the frame if it is known, and the
 * fault */
FrameHeader
decodeFrameHeader(const std::string& name,
                  const std::uint8_t* data,
                  std::uint64_t file_bytes);

/** \brief Decodes the content of a complete file.
 * \throws InputFileException as above; also when the checksum is wrong */
TrinocularFrame
decodeFrame(const std::string& name, const std::vector<std::uint8_t>& bytes);

/** \brief The checksum at the end of a file: CRC-32 of all preceding bytes. */
std::uint32_t
checksumOf(const std::uint8_t* data, std::size_t bytes);

/** \brief Reads and checks only the header of a file. */
FrameHeader
loadFrameHeader(const std::string& path);

} // namespace pcl::acmap
