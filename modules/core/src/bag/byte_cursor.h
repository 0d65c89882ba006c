#pragma once

#include <pcl/core/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace pcl::acmap {

/** \brief Reads little-endian numbers and texts from bytes in memory, one after the other. */
class ByteCursor {
public:
  /** \param[in] name of the bytes, for error messages */
  ByteCursor(std::string_view bytes, std::string name)
  : bytes_(bytes)
  , name_(std::move(name))
  {}

  std::size_t
  place() const
  {
    return place_;
  }

  std::size_t
  remaining() const
  {
    return bytes_.size() - place_;
  }

  [[noreturn]] void
  fail(const std::string& fault) const
  {
    throw InputFileException(name_ + ": " + fault);
  }

  std::string_view
  take(std::uint64_t count)
  {
    if (count > remaining())
      fail("ends early: " + std::to_string(count) + " bytes are needed at byte " +
           std::to_string(place_) + ", " + std::to_string(remaining()) + " follow");
    const std::string_view taken = bytes_.substr(place_, count);
    place_ += count;
    return taken;
  }

  template <typename Number>
  Number
  number()
  {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  /** \brief Bytes after their number as 32 bits. */
  std::string_view
  sized()
  {
    return take(number<std::uint32_t>());
  }

private:
  std::string_view bytes_;
  std::string name_;
  std::size_t place_ = 0;
};

} // namespace pcl::acmap
