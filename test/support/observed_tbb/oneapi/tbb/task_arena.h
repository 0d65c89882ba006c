#pragma once

#include "fork_join.h"

namespace oneapi::tbb {

class task_arena {
public:
  static constexpr int automatic = -1;

  explicit task_arena(int threads)
  : arena_(threads == automatic ? observed::arena().concurrency : threads)
  {}

  template <typename Function>
  auto
  execute(Function&& function)
  {
    const Entry entry(arena_);
    return function();
  }

private:
  struct Entry {
    explicit Entry(observed::Arena& arena)
    : before(observed::entered)
    {
      observed::entered = &arena;
    }

    ~Entry()
    {
      observed::entered = before;
    }

    observed::Arena* before;
  };

  observed::Arena arena_;
};

namespace this_task_arena {

inline int
max_concurrency()
{
  return observed::arena().concurrency;
}

} // namespace this_task_arena

} // namespace oneapi::tbb
