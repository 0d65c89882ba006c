#pragma once

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Values in a row of bytes, which another process on the same kind of machine
 * takes out in the order in which they were put in. */
class ByteParcel {
public:
  using Bytes = std::vector<std::uint8_t>;

  ByteParcel() = default;

  explicit ByteParcel(Bytes bytes)
  : bytes_(std::move(bytes))
  {}

  const Bytes&
  bytes() const
  {
    return bytes_;
  }

  /** \brief Number of bytes that were not taken yet. */
  std::size_t
  left() const
  {
    return bytes_.size() - next_;
  }

  template <typename Value>
  void
  put(const Value& value)
  {
    putAll(&value, 1);
  }

  /** \brief Puts adjacent values, without their number. */
  template <typename Value>
  void
  putAll(const Value* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + count * sizeof(Value));
    std::copy_n(reinterpret_cast<const std::uint8_t*>(values),
                count * sizeof(Value),
                bytes_.begin() + static_cast<std::ptrdiff_t>(begin));
  }

  void
  putText(const std::string& text)
  {
    put(text.size());
    putAll(text.data(), text.size());
  }

  template <typename Value>
  Value
  take()
  {
    Value value;
    takeAll(&value, 1);
    return value;
  }

  /** \throws IOException if there are fewer bytes */
  template <typename Value>
  void
  takeAll(Value* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    requireLeft(count, sizeof(Value));
    if (count > 0)
      std::memcpy(values, bytes_.data() + next_, count * sizeof(Value));
    next_ += count * sizeof(Value);
  }

  /** \brief Takes a number of values of which as many follow.
   * \throws IOException if there are fewer */
  template <typename Value>
  std::size_t
  takeCount()
  {
    const auto count = take<std::size_t>();
    requireLeft(count, sizeof(Value));
    return count;
  }

  std::string
  takeText()
  {
    std::string text(takeCount<char>(), '\0');
    takeAll(text.data(), text.size());
    return text;
  }

private:
  void
  requireLeft(std::size_t count, std::size_t bytes) const
  {
    if (count > left() / bytes)
      throw acmap::IoFault("a message of another process ends early");
  }

  Bytes bytes_;
  std::size_t next_ = 0;
};

} // namespace pcl::acmap
