#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

#if defined(__BYTE_ORDER__)
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "binary point files are read and written on little-endian machines only");
#endif

/** \brief Size in bytes of a value of a PCLPointField datatype, 0 for an unknown one.
 */
std::size_t
sizeOfType(std::uint8_t datatype);

/** \brief Converts a value of a PCLPointField datatype to double. */
double
valueOfType(std::uint8_t datatype, const std::uint8_t* from);

/** \brief Rounds to the closest float; infinite if the number is out of range. */
float
narrowed(double value);

/** \brief Moves bytes from an offset in a record to an offset in another record. */
struct RecordMove {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t bytes = 0;

  /** \brief 0 copies the bytes; a PCLPointField datatype converts one value of this
   * type to float. */
  std::uint8_t float_from = 0;

  /** \brief The three bytes are written in reverse order. */
  bool reverses = false;

  /** \brief Subtracted from a value that is converted, before it is rounded. */
  double minus = 0;
};

/** \brief Appends a copy, or extends the last one if the bytes are contiguous in both
 * records. Three copies of a byte to contiguous places in reverse order become one move.
 */
void
appendCopy(std::vector<RecordMove>& moves, const RecordMove& copy);

/** \brief Applies moves to \a count records at constant steps. */
void
moveRecords(const std::vector<RecordMove>& moves,
            const std::uint8_t* from,
            std::size_t from_step,
            std::uint8_t* to,
            std::size_t to_step,
            std::size_t count);

/** \brief Reverses the byte order of \a count values of 2, 4 or 8 bytes, in place. */
void
swapValues(std::uint8_t* at, std::size_t size, std::size_t step, std::size_t count);

} // namespace pcl::acmap
