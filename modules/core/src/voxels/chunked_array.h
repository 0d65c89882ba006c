#pragma once

#include <pcl/core/impl/large_memory.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace pcl::acmap {

/** \brief Array that grows without moving its values: they are in chunks of equal
 * length. A vector would copy all of them each time its capacity doubles, into memory
 * that the system clears before. */
template <typename Value>
class ChunkedArray {
public:
  static_assert(std::is_trivially_destructible_v<Value>);

  std::size_t
  size() const
  {
    return size_;
  }

  bool
  empty() const
  {
    return size_ == 0;
  }

  Value&
  operator[](std::size_t i)
  {
    return chunks_[i >> bits][i & mask];
  }

  const Value&
  operator[](std::size_t i) const
  {
    return chunks_[i >> bits][i & mask];
  }

  /** \brief Appends a value with the initial values of its members. */
  Value&
  append()
  {
    if (size_ >> bits == chunks_.size())
      chunks_.emplace_back(SystemAllocator<Value>().allocate(std::size_t{1} << bits));
    Value& value = (*this)[size_++];
    value = Value();
    return value;
  }

  /** \brief Appends values until there are \a size ones. */
  void
  extendTo(std::size_t size)
  {
    while (size_ < size)
      append();
  }

  /** \brief Removes all values, but keeps their memory. */
  void
  clear()
  {
    size_ = 0;
  }

private:
  static constexpr int bits = 12;
  static constexpr std::size_t mask = (std::size_t{1} << bits) - 1;

  struct Return {
    void
    operator()(Value* values) const
    {
      SystemAllocator<Value>().deallocate(values, std::size_t{1} << bits);
    }
  };

  std::vector<std::unique_ptr<Value[], Return>> chunks_;
  std::size_t size_ = 0;
};

} // namespace pcl::acmap
