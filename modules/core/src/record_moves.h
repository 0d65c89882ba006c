#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

#if defined(__BYTE_ORDER__)
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "binary point files are read and written on little-endian machines only");
#endif

/** \brief Bytes of one value of a PCLPointField datatype, 0 for an unknown one. */
std::size_t
sizeOfType(std::uint8_t datatype);

/** \brief One value of a PCLPointField datatype as a number. */
double
valueOfType(std::uint8_t datatype, const std::uint8_t* from);

/** \brief The nearest float; infinite where the number is too large for one. */
float
narrowed(double value);

/** \brief Takes bytes from one place of a record to a place of another record. */
struct RecordMove {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t bytes = 0;

  /** \brief 0 copies the bytes; a PCLPointField datatype turns one value of it into a
   * float. */
  std::uint8_t float_from = 0;
};

/** \brief Appends a copy, or lengthens the last one where both places go on from it. */
void
appendCopy(std::vector<RecordMove>& moves, const RecordMove& copy);

/** \brief Applies moves to \a count records that stand at fixed steps. */
void
moveRecords(const std::vector<RecordMove>& moves,
            const std::uint8_t* from,
            std::size_t from_step,
            std::uint8_t* to,
            std::size_t to_step,
            std::size_t count);

/** \brief Turns the bytes of \a count values of 2, 4 or 8 bytes around, in place. */
void
swapValues(std::uint8_t* at, std::size_t size, std::size_t step, std::size_t count);

} // namespace pcl::acmap
