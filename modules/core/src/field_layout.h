#pragma once

#include "record_moves.h"

#include <pcl/PCLPointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Most fields, properties or elements of a header: a longer one is an attack on
 * the memory, in which a field takes more than its few letters in the file. */
constexpr std::size_t most_fields = 1000;

/** \brief A field as a file declares it; fields follow each other without gaps. */
struct SourceField {
  /** \brief PCL's name; `_` is padding. */
  std::string name;
  std::uint8_t datatype = 0;

  /** \brief Number of values. That of padding may be negative: PCL's writer goes back so
   * when the fields of a cloud do not stand in the order of their offsets. */
  std::int64_t count = 1;

  /** \brief Place in a binary record; \ref planLayout sets it. */
  std::size_t offset = 0;

  std::size_t
  bytes() const
  {
    return sizeOfType(datatype) * static_cast<std::size_t>(count);
  }

  bool
  isPadding() const
  {
    return name == "_";
  }
};

/** \brief How the points of a file become the points of a cloud: x y z float32 and
 * together, a colour of three or four bytes packed as PCL does. */
struct FieldLayout {
  std::vector<SourceField> source;
  std::size_t source_step = 0;

  std::vector<PCLPointField> fields;
  std::size_t point_step = 0;

  /** \brief For each field of the source its place in a point and its datatype there. */
  struct Target {
    std::size_t offset = 0;
    std::uint8_t datatype = 0;
  };
  std::vector<Target> targets;

  /** \brief Points can be taken over as they are. */
  bool same = false;

  /** \brief The coordinates of the file are finer than float32. */
  bool narrows = false;

  /** \brief The moves that bring a field of a record that holds only this field. */
  RecordMove
  moveOf(std::size_t field) const;

  /** \brief The moves from a record of the file to a point. */
  std::vector<RecordMove>
  moves() const;
};

/** \brief Plans a layout.
 * \throws InputFileException when x, y or z is missing, twice there or no single number,
 * when a field lies outside the record or a record is longer than 2^31 - 1 bytes */
FieldLayout
planLayout(std::vector<SourceField> source, const ByteSource& file);

} // namespace pcl::acmap
