#pragma once

#include "enumerable_thread_specific.h"

namespace oneapi::tbb {

template <typename Value>
using combinable = enumerable_thread_specific<Value>;

} // namespace oneapi::tbb
