#pragma once

#include "blocked_range.h"
#include "fork_join.h"

namespace oneapi::tbb {

template <typename Index, typename Body>
void
parallel_for(Index first, Index last, const Body& body)
{
  if (first >= last)
    return;
  std::atomic<Index> next{first};
  observed::fork(static_cast<std::size_t>(last - first), [&] {
    for (Index index; (index = next.fetch_add(1, std::memory_order_relaxed)) < last;)
      body(index);
  });
}

template <typename Value, typename Body>
void
parallel_for(const blocked_range<Value>& range, const Body& body)
{
  const auto grain = static_cast<Value>(range.grainsize());
  const Value blocks = (range.end() - range.begin() + grain - 1) / grain;
  parallel_for(Value{0}, blocks, [&](Value block) {
    const Value begin = range.begin() + block * grain;
    body(blocked_range<Value>(begin, std::min(begin + grain, range.end()), 1));
  });
}

} // namespace oneapi::tbb
