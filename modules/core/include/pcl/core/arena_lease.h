#pragma once

#include <pcl/core/export.h>

#include <oneapi/tbb/task_arena.h>

#include <memory>

namespace pcl::acmap {

/** \brief An arena of threads that is nobody else's as long as this lives. The next lease of
 * as many threads has the same one: with its own allocator, oneTBB 2021.8 does not get back
 * some kilobytes of each arena that is destroyed. */
class ACMAP_EXPORT ArenaLease {
public:
  /** \param[in] threads 0: all */
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
