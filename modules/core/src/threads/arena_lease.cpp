#include <pcl/core/impl/arena_lease.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

using Arena = std::unique_ptr<oneapi::tbb::task_arena>;

/** \brief The arenas that are not leased. */
class ArenaStock {
public:
  Arena
  take(int threads)
  {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::find_if(arenas_.begin(), arenas_.end(), [&](const auto& entry) {
          return entry.first == threads;
        });
    if (found == arenas_.end())
      return nullptr;
    Arena arena = std::move(found->second);
    arenas_.erase(found);
    return arena;
  }

  void
  put(int threads, Arena arena)
  {
    const std::lock_guard lock(mutex_);
    arenas_.emplace_back(threads, std::move(arena));
  }

private:
  std::mutex mutex_;
  std::vector<std::pair<int, Arena>> arenas_;
};

ArenaStock&
stock()
{
  static ArenaStock arenas;
  return arenas;
}

} // namespace

ArenaLease::ArenaLease(unsigned threads)
: threads_(threads ? static_cast<int>(threads) : oneapi::tbb::task_arena::automatic)
, arena_(stock().take(threads_))
{
  if (!arena_)
    arena_ = std::make_unique<oneapi::tbb::task_arena>(threads_);
}

ArenaLease::~ArenaLease()
{
  try {
    stock().put(threads_, std::move(arena_));
  }
  catch (const std::bad_alloc&) {
    // if there is no memory to store the arena, it is destroyed
  }
}

} // namespace pcl::acmap
