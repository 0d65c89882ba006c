#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/large_memory.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

namespace acmap {
class ScratchScope;
} // namespace acmap

/** \brief A vector of about as many values as a cloud has points. Its memory is returned to
 * the system as soon as it is released, and is in a file if it was allocated while a
 * ScratchMemory was in effect. \ingroup core */
template <typename Value>
using LargeVector = std::vector<Value, acmap::SystemAllocator<Value>>;

/** \brief For each point of a cloud the number of what it belongs to, -1 for nothing.
 * \ingroup core */
using PointLabels = LargeVector<std::int32_t>;

/** \brief While it exists, the large arrays of this process are in files instead of in
 * memory, so that clouds can be larger than the memory.
 *
 * Each LargeVector of 256 KB or more that is allocated meanwhile gets a file without a
 * name, which is mapped into memory: algorithms do not notice, and their results are the same.
 * The pages that are in memory at the same time are limited; the others stay in the file
 * cache of the system as long as it has room. If the disk has no room for an array, it stays
 * in memory, which \ref getRefused tells.
 * \code
 * pcl::ScratchMemory scratch ("/var/tmp", std::size_t{256} << 20);
 * mapping.compute (map);
 * \endcode
 * The one made last is in effect for the whole process. An array stays where it was
 * allocated until it is released. \ingroup core */
class ACMAP_EXPORT ScratchMemory {
public:
  /** \param[in] folder that exists, on a disk with room for the arrays
   * \param[in] resident bytes of the files that may be in memory at the same time, at least
   * 16 MB; what is used within a few milliseconds may exceed it
   * \param[in] of_process bytes that this process may have in memory: while it has less than
   * three quarters of them, the files may have what is left of these; 0: \a resident
   * always holds
   * \throws BadArgumentException if \a resident is less
   * \throws OutputFileException if no file can be made in the folder */
  ScratchMemory(const std::string& folder,
                std::size_t resident,
                std::size_t of_process = 0);

  ~ScratchMemory();

  ScratchMemory(const ScratchMemory&) = delete;

  ScratchMemory&
  operator=(const ScratchMemory&) = delete;

  /** \brief The allowance of the one that is in effect in this process, in bytes; 0 if there
   * is none. */
  static std::size_t
  getResidentInEffect();

  /** \brief Bytes of all arrays that were put into files. */
  std::size_t
  getBytes() const;

  /** \brief Bytes of arrays that stayed in memory because the disk had no room. */
  std::size_t
  getRefused() const;

private:
  std::shared_ptr<acmap::ScratchScope> scope_;
};

} // namespace pcl
