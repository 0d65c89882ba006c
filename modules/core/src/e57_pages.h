#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief Checksum of a page of an E57 file, CRC-32C. */
std::uint32_t
e57Checksum(const char* bytes, std::size_t count);

/** \brief The bytes of an E57 file (ASTM E2807) without the checksums of its pages. */
class E57Pages {
public:
  /** \brief Reads the whole file.
   * \throws InputFileException for what is no E57 file, is truncated, or has a page whose
   * checksum is wrong */
  explicit E57Pages(ByteSource& source);

  /** \brief The part that describes the file. */
  const std::string&
  xml() const
  {
    return xml_;
  }

  /** \brief All bytes. */
  const std::string&
  bytes() const
  {
    return bytes_;
  }

  /** \brief Offset in \ref bytes of an offset in the file.
   * \throws InputFileException for that of a checksum */
  static std::uint64_t
  logical(std::uint64_t physical, const ByteSource& source);

private:
  std::string bytes_, xml_;
};

} // namespace pcl::acmap
