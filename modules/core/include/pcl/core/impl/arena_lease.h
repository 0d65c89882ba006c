#pragma once

#include <pcl/core/export.h>

#include <oneapi/tbb/task_arena.h>

#include <memory>

namespace pcl::acmap {

/** \brief A TBB arena that is used exclusively during the lifetime of this object. It
 * is reused by the next lease with the same number of threads, because oneTBB 2021.8
 * with its own allocator leaks some kilobytes for each destroyed arena. */
class ACMAP_EXPORT ArenaLease {
public:
  /** \param[in] threads number of threads, 0 for all */
  explicit ArenaLease(unsigned threads);

  ArenaLease(const ArenaLease&) = delete;
  ArenaLease&
  operator=(const ArenaLease&) = delete;

  ~ArenaLease();

  oneapi::tbb::task_arena&
  operator*() const
  {
    return *arena_;
  }

private:
  int threads_;
  std::unique_ptr<oneapi::tbb::task_arena> arena_;
};

} // namespace pcl::acmap
