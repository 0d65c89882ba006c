#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Asks the system to back memory that is not used yet by pages of 2 MB. It only
 * concerns speed: the first use of a page of 4 KB takes longer than reading its content
 * from a file. Blocks of less than a few megabytes are left as they are. */
ACMAP_EXPORT void
adviseLargePages(void* begin, std::size_t bytes);

/** \brief Returns memory that the heap keeps for later to the system: between steps, whose
 * arrays have different sizes, it would not be used again. */
ACMAP_EXPORT void
returnFreeMemory();

/** \brief Reserves memory for \a count values that are appended soon. */
template <typename Vector>
void
reserveLarge(Vector& values, std::size_t count)
{
  values.reserve(count);
  adviseLargePages(values.data(), values.capacity() * sizeof(values[0]));
}

/** \brief Replaces the content of a vector by \a count copies of a value. */
template <typename Vector>
void
assignLarge(Vector& values, std::size_t count, const typename Vector::value_type& value)
{
  reserveLarge(values, count);
  values.assign(count, value);
}

/** \brief Memory from the system itself, in a file if a ScratchMemory is in effect; small
 * blocks are from the heap. It begins at a line of the cache (64 bytes).
 * \throws std::bad_alloc */
ACMAP_EXPORT void*
allocateFromSystem(std::size_t bytes);

ACMAP_EXPORT void
returnToSystem(void* memory, std::size_t bytes);

/** \brief Takes pages of arrays in files out of memory if they are more than the
 * ScratchMemory allows; its own thread may have to wait for a processor. Loops call
 * pollRun. */
ACMAP_EXPORT void
keepScratchSmall();

/** \brief Allocator of large arrays. Unlike the heap, which keeps the memory of
 * each thread for later, it returns them to the system as soon as they are released. */
template <typename Value>
struct SystemAllocator {
  static_assert(alignof(Value) <= 64);

  using value_type = Value;

  SystemAllocator() = default;

  template <typename Other>
  SystemAllocator(const SystemAllocator<Other>&)
  {}

  Value*
  allocate(std::size_t count)
  {
    return static_cast<Value*>(allocateFromSystem(count * sizeof(Value)));
  }

  void
  deallocate(Value* memory, std::size_t count)
  {
    returnToSystem(memory, count * sizeof(Value));
  }

  bool
  operator==(const SystemAllocator&) const
  {
    return true;
  }

  bool
  operator!=(const SystemAllocator&) const
  {
    return false;
  }
};

/** \brief Allocator of large arrays that are filled, by several threads, right after
 * they got their size: resize () leaves their values undefined, and large pages back
 * them. */
template <typename Value>
struct UnfilledAllocator : SystemAllocator<Value> {
  static_assert(std::is_trivially_destructible_v<Value>);

  UnfilledAllocator() = default;

  template <typename Other>
  UnfilledAllocator(const UnfilledAllocator<Other>&)
  {}

  template <typename Other>
  struct rebind {
    using other = UnfilledAllocator<Other>;
  };

  Value*
  allocate(std::size_t count)
  {
    Value* const memory = SystemAllocator<Value>::allocate(count);
    adviseLargePages(memory, count * sizeof(Value));
    return memory;
  }

  void
  construct(Value*)
  {}

  template <typename Argument, typename... Arguments>
  void
  construct(Value* place, Argument&& first, Arguments&&... others)
  {
    ::new (static_cast<void*>(place))
        Value(std::forward<Argument>(first), std::forward<Arguments>(others)...);
  }
};

/** \brief Array whose values are undefined until they are assigned. */
template <typename Value>
using UnfilledArray = std::vector<Value, UnfilledAllocator<Value>>;

} // namespace pcl::acmap
