#include "record_moves.h"

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
  if (!moves.empty() && moves.back().float_from == 0 &&
      moves.back().from + moves.back().bytes == copy.from &&
      moves.back().to + moves.back().bytes == copy.to)
    moves.back().bytes += copy.bytes;
  else
    moves.push_back(copy);
}

void
moveRecords(const std::vector<RecordMove>& moves,
            const std::uint8_t* from,
            std::size_t from_step,
            std::uint8_t* to,
            std::size_t to_step,
            std::size_t count)
{
  for (const RecordMove& move : moves) {
    const std::uint8_t* const source = from + move.from;
    std::uint8_t* const target = to + move.to;
    if (move.float_from == 0) {
      copyRecords(move.bytes, source, from_step, target, to_step, count);
      continue;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double wide = valueOfType(move.float_from, source + i * from_step);
      const float value = narrowed(wide);
      std::memcpy(target + i * to_step, &value, sizeof(value));
    }
  }
}

void
swapValues(std::uint8_t* at, std::size_t size, std::size_t step, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
    std::reverse(at + i * step, at + i * step + size);
}

} // namespace pcl::acmap
