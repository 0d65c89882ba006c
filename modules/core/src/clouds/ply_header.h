#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief A property of a PLY element: a value, or a list preceded by its length. */
struct PlyProperty {
  std::string name;
  std::uint8_t datatype = 0; // type of a value, as in PCLPointField

  /** \brief Datatype of the length of a list; 0 for a single value. */
  std::uint8_t length_datatype = 0;

  bool
  isList() const
  {
    return length_datatype != 0;
  }
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;
  std::vector<PlyProperty> properties;

  /** \brief Number of bytes of a binary row if all its lists are empty. */
  std::uint64_t
  leastBytes() const;

  bool
  hasList() const;
};

struct PlyHeader {
  enum class Encoding { ascii, little_endian, big_endian };

  Encoding encoding = Encoding::ascii;
  std::vector<PlyElement> elements;
};

/** \brief Reads the lines up to and including end_header.
 * \throws InputFileException when it is not a PLY header or does not have exactly one
 * vertex element */
PlyHeader
readPlyHeader(ByteSource& source);

} // namespace pcl::acmap
