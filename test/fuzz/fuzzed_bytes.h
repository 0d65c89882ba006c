#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace pcl::acmap::test {

/** \brief Reads a fuzzer's bytes one after another; returns zeros after their end. */
class FuzzedBytes {
public:
  FuzzedBytes(const std::uint8_t* data, std::size_t size)
  : data_(data)
  , size_(size)
  {}

  std::size_t
  left() const
  {
    return size_;
  }

  std::uint8_t
  byte()
  {
    if (size_ == 0)
      return 0;
    --size_;
    return *data_++;
  }

  std::int8_t
  small()
  {
    return static_cast<std::int8_t>(byte());
  }

  /** \brief A number with these bytes in memory. */
  template <typename Number>
  Number
  number()
  {
    Number value{};
    const std::size_t bytes = std::min(sizeof value, size_);
    std::memcpy(&value, data_, bytes);
    data_ += bytes;
    size_ -= bytes;
    return value;
  }

private:
  const std::uint8_t* data_;
  std::size_t size_;
};

/** \brief Ends the program if a guarantee is violated. */
inline void
require(bool holds, int line = __builtin_LINE())
{
  if (holds)
    return;
  std::fprintf(stderr, "line %d does not hold\n", line);
  std::abort();
}

} // namespace pcl::acmap::test
