#include "files/record_moves.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap {

namespace {

template <typename Value>
double
loadAs(const std::uint8_t* from)
{
  Value value;
  std::memcpy(&value, from, sizeof(value));
  return static_cast<double>(value);
}

// With a length known at compile time, each copy takes one or two instructions.
template <std::size_t Bytes>
void
copyFixed(const std::uint8_t* from,
          std::size_t from_step,
          std::uint8_t* to,
          std::size_t to_step,
          std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(to + i * to_step, from + i * from_step, Bytes);
}

void
copyAny(std::size_t bytes,
        const std::uint8_t* from,
        std::size_t from_step,
        std::uint8_t* to,
        std::size_t to_step,
        std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(to + i * to_step, from + i * from_step, bytes);
}

void
copyRecords(std::size_t bytes,
            const std::uint8_t* from,
            std::size_t from_step,
            std::uint8_t* to,
            std::size_t to_step,
            std::size_t count)
{
  switch (bytes) {
  case 1:
    return copyFixed<1>(from, from_step, to, to_step, count);
  case 2:
    return copyFixed<2>(from, from_step, to, to_step, count);
  case 4:
    return copyFixed<4>(from, from_step, to, to_step, count);
  case 8:
    return copyFixed<8>(from, from_step, to, to_step, count);
  case 12:
    return copyFixed<12>(from, from_step, to, to_step, count);
  case 16:
    return copyFixed<16>(from, from_step, to, to_step, count);
  default:
    return copyAny(bytes, from, from_step, to, to_step, count);
  }
}

// A colour of three bytes: red green blue in files, blue green red in PCL.
void
reverseTriples(const std::uint8_t* from,
               std::size_t from_step,
               std::uint8_t* to,
               std::size_t to_step,
               std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i, from += from_step, to += to_step) {
    to[0] = from[2];
    to[1] = from[1];
    to[2] = from[0];
  }
}

template <typename Value>
void
narrowRecords(double minus,
              const std::uint8_t* from,
              std::size_t from_step,
              std::uint8_t* to,
              std::size_t to_step,
              std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i) {
    const float value = narrowed(loadAs<Value>(from + i * from_step) - minus);
    std::memcpy(to + i * to_step, &value, sizeof value);
  }
}

void
convertRecords(const RecordMove& move,
               const std::uint8_t* from,
               std::size_t from_step,
               std::uint8_t* to,
               std::size_t to_step,
               std::size_t count)
{
  switch (move.float_from) {
  case PCLPointField::INT8:
    return narrowRecords<std::int8_t>(move.minus, from, from_step, to, to_step, count);
  case PCLPointField::BOOL:
  case PCLPointField::UINT8:
    return narrowRecords<std::uint8_t>(move.minus, from, from_step, to, to_step, count);
  case PCLPointField::INT16:
    return narrowRecords<std::int16_t>(move.minus, from, from_step, to, to_step, count);
  case PCLPointField::UINT16:
    return narrowRecords<std::uint16_t>(
        move.minus, from, from_step, to, to_step, count);
  case PCLPointField::INT32:
    return narrowRecords<std::int32_t>(move.minus, from, from_step, to, to_step, count);
  case PCLPointField::UINT32:
    return narrowRecords<std::uint32_t>(
        move.minus, from, from_step, to, to_step, count);
  case PCLPointField::INT64:
    return narrowRecords<std::int64_t>(move.minus, from, from_step, to, to_step, count);
  case PCLPointField::UINT64:
    return narrowRecords<std::uint64_t>(
        move.minus, from, from_step, to, to_step, count);
  case PCLPointField::FLOAT32:
    return narrowRecords<float>(move.minus, from, from_step, to, to_step, count);
  default:
    return narrowRecords<double>(move.minus, from, from_step, to, to_step, count);
  }
}

void
moveRecord(const RecordMove& move,
           const std::uint8_t* from,
           std::size_t from_step,
           std::uint8_t* to,
           std::size_t to_step,
           std::size_t count)
{
  from += move.from;
  to += move.to;
  if (move.float_from != 0)
    convertRecords(move, from, from_step, to, to_step, count);
  else if (move.reverses)
    reverseTriples(from, from_step, to, to_step, count);
  else
    copyRecords(move.bytes, from, from_step, to, to_step, count);
}

bool
isCopy(const RecordMove& move)
{
  return move.float_from == 0 && !move.reverses;
}

/** \brief Whether three copies move contiguous bytes to contiguous places in reverse
 * order. */
bool
formReversal(const RecordMove& a, const RecordMove& b, const RecordMove& c)
{
  for (const RecordMove* move : {&a, &b, &c})
    if (!isCopy(*move) || move->bytes != 1)
      return false;
  const bool forward = b.from == a.from + 1 && c.from == b.from + 1 &&
                       a.to == b.to + 1 && b.to == c.to + 1;
  const bool backward = a.from == b.from + 1 && b.from == c.from + 1 &&
                        b.to == a.to + 1 && c.to == b.to + 1;
  return forward || backward;
}

template <std::size_t Bytes>
void
swapFixed(std::uint8_t* at, std::size_t step, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
    std::reverse(at + i * step, at + i * step + Bytes);
}

} // namespace

std::size_t
sizeOfType(std::uint8_t datatype)
{
  switch (datatype) {
  case PCLPointField::BOOL:
  case PCLPointField::INT8:
  case PCLPointField::UINT8:
    return 1;
  case PCLPointField::INT16:
  case PCLPointField::UINT16:
    return 2;
  case PCLPointField::INT32:
  case PCLPointField::UINT32:
  case PCLPointField::FLOAT32:
    return 4;
  case PCLPointField::INT64:
  case PCLPointField::UINT64:
  case PCLPointField::FLOAT64:
    return 8;
  default:
    return 0;
  }
}

double
valueOfType(std::uint8_t datatype, const std::uint8_t* from)
{
  switch (datatype) {
  case PCLPointField::INT8:
    return loadAs<std::int8_t>(from);
  case PCLPointField::BOOL:
  case PCLPointField::UINT8:
    return loadAs<std::uint8_t>(from);
  case PCLPointField::INT16:
    return loadAs<std::int16_t>(from);
  case PCLPointField::UINT16:
    return loadAs<std::uint16_t>(from);
  case PCLPointField::INT32:
    return loadAs<std::int32_t>(from);
  case PCLPointField::UINT32:
    return loadAs<std::uint32_t>(from);
  case PCLPointField::INT64:
    return loadAs<std::int64_t>(from);
  case PCLPointField::UINT64:
    return loadAs<std::uint64_t>(from);
  case PCLPointField::FLOAT32:
    return loadAs<float>(from);
  default:
    return loadAs<double>(from);
  }
}

float
narrowed(double value)
{
  constexpr double maximum = std::numeric_limits<float>::max();
  if (std::abs(value) > maximum)
    return static_cast<float>(
        std::copysign(std::numeric_limits<double>::infinity(), value));
  return static_cast<float>(value);
}

void
appendCopy(std::vector<RecordMove>& moves, const RecordMove& copy)
{
  if (!moves.empty() && isCopy(moves.back()) &&
      moves.back().from + moves.back().bytes == copy.from &&
      moves.back().to + moves.back().bytes == copy.to)
    moves.back().bytes += copy.bytes;
  else
    moves.push_back(copy);
  if (moves.size() < 3)
    return;
  const auto last = moves.end() - 3;
  if (!formReversal(last[0], last[1], last[2]))
    return;
  *last = {std::min(last[0].from, last[2].from),
           std::min(last[0].to, last[2].to),
           3,
           0,
           true};
  moves.resize(moves.size() - 2);
}

void
moveRecords(const std::vector<RecordMove>& moves,
            const std::uint8_t* from,
            std::size_t from_step,
            std::uint8_t* to,
            std::size_t to_step,
            std::size_t count)
{
  // All moves of a block find it in the first-level cache.
  constexpr std::size_t block_bytes = 16 * 1024;
  const std::size_t block = std::max<std::size_t>(
      1, block_bytes / std::max<std::size_t>(1, from_step + to_step));
  for (std::size_t done = 0; done < count; done += block)
    for (const RecordMove& move : moves)
      moveRecord(move,
                 from + done * from_step,
                 from_step,
                 to + done * to_step,
                 to_step,
                 std::min(block, count - done));
}

void
swapValues(std::uint8_t* at, std::size_t size, std::size_t step, std::size_t count)
{
  switch (size) {
  case 2:
    return swapFixed<2>(at, step, count);
  case 4:
    return swapFixed<4>(at, step, count);
  case 8:
    return swapFixed<8>(at, step, count);
  default:
    return;
  }
}

} // namespace pcl::acmap
