#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief Checksum of a page of an E57 file, CRC-32C. */
std::uint32_t
e57Checksum(const char* bytes, std::size_t count);

/** \brief The bytes of an E57 file (ASTM E2807) without the checksums of its pages, read
 * where they are needed. */
class E57Pages {
public:
  /** \brief Reads the header of the file.
   * \throws InputFileException for what is no E57 file, or is truncated */
  explicit E57Pages(ByteSource& source);

  /** \brief Compares all pages with their checksums.
   * \throws InputFileException naming the first one that differs */
  void
  requireChecksums();

  /** \brief The part that describes the file. */
  std::string
  xml();

  /** \brief Number of bytes without checksums. */
  std::uint64_t
  size() const;

  /** \brief Reads bytes from a logical offset on; the caller has compared them with
   * \ref size. */
  std::string
  read(std::uint64_t offset, std::uint64_t count);

  /** \brief Logical offset of an offset in the file.
   * \throws InputFileException for that of a checksum */
  std::uint64_t
  logical(std::uint64_t physical) const;

  const ByteSource&
  source() const
  {
    return source_;
  }

private:
  ByteSource& source_;
  std::uint64_t page_; ///< the one in \ref content_
  std::string content_;
};

} // namespace pcl::acmap
