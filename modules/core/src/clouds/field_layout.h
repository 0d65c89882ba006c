#pragma once

#include "files/record_moves.h"

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Maximum number of fields, properties or elements of a header. More are
 * considered an attack on the memory, because a field takes more bytes in memory than
 * its few letters in the file. */
constexpr std::size_t max_fields = 1000;

/** \brief A field as declared by a file; there are no gaps between fields. */
struct SourceField {
  /** \brief PCL's name; `_` means padding. */
  std::string name;
  std::uint8_t datatype = 0;

  /** \brief Number of values. It may be negative for padding: PCL's writer uses this to
   * go back when the fields of a cloud are not in the order of their offsets. */
  std::int64_t count = 1;

  /** \brief Offset in a binary record; set by \ref planLayout. */
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

/** \brief Conversion of the points of a file to the points of a cloud: x y z are
 * adjacent float32, and a colour of three or four bytes is packed as in PCL. */
struct FieldLayout {
  std::vector<SourceField> source;
  std::size_t source_step = 0;

  std::vector<PCLPointField> fields;
  std::size_t point_step = 0;

  /** \brief For each field of the file its offset in a point and its datatype there. */
  struct Target {
    std::size_t offset = 0;
    std::uint8_t datatype = 0;
  };
  std::vector<Target> targets;

  /** \brief Points can be copied without conversion. */
  bool same = false;

  /** \brief The coordinates of the file have a higher precision than float32. */
  bool narrows = false;

  /** \brief The fields x, y and z of the file. */
  std::array<std::size_t, 3> coordinates{};

  /** \brief Is there a field `rgb` without a field of the file, for \ref packColors? */
  bool packs_colors = false;

  /** \brief What is subtracted from the coordinates of the file. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  /** \brief Sets \ref shift. */
  void
  subtract(const Eigen::Vector3d& offset);

  /** \brief The coordinates in a record of the file. */
  Eigen::Vector3d
  placeIn(const std::uint8_t* record) const;

  /** \brief Returns the move from a record that only contains this field. */
  RecordMove
  moveOf(std::size_t field) const;

  /** \brief Returns the moves from a record of the file to a point. */
  std::vector<RecordMove>
  moves() const;
};

/** \brief Determines the layout. Colours of three numbers that are no bytes get a field `rgb`
 * beside them, which \ref packColors fills.
 * \throws InputFileException when x, y or z is missing, duplicate or not a single
 * number, if a field is outside the record or a record is longer than 2^31 - 1 bytes */
FieldLayout
planLayout(std::vector<SourceField> source, const ByteSource& file);

/** \brief Makes a packed colour of the numbers red, green and blue, which are fractions, or 0
 * to 255, or 0 to 65535, as the largest shows, and takes the three fields out of the cloud.
 * \param[in,out] data points of the cloud */
void
packColors(const FieldLayout& layout, PCLPointCloud2& cloud, std::uint8_t* data);

/** \brief Reverses the byte order of all values of \a count packed records. */
void
swapRecords(const FieldLayout& layout, std::uint8_t* records, std::size_t count);

} // namespace pcl::acmap
