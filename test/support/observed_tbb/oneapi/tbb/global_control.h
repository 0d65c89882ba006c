#pragma once

#include <cstddef>
#include <limits>

namespace oneapi::tbb {

/** \brief Does nothing, because this implementation has no global limits. */
class global_control {
public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t) {}

  static std::size_t
  active_value(parameter)
  {
    return std::numeric_limits<std::size_t>::max();
  }
};

} // namespace oneapi::tbb
