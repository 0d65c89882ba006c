#pragma once

#include "parallel_for.h"

namespace oneapi::tbb {

template <typename First, typename Second>
void
parallel_invoke(const First& first, const Second& second)
{
  parallel_for(0, 2, [&](int which) { which == 0 ? first() : second(); });
}

} // namespace oneapi::tbb
