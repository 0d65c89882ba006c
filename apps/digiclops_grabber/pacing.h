#pragma once

#include "grabber_options.h"

#include <chrono>
#include <functional>
#include <optional>

namespace pcl::acmap {

/** \brief What begins the next observation: a clock, the Enter key, or nothing. */
class Pacing {
public:
  /** \param[in] every seconds from begin to begin; none: the key, where standard input
   * is a terminal */
  explicit Pacing(const std::optional<double>& every);

  /** \brief Whether the key is waited for. */
  bool
  asks() const
  {
    return asks_;
  }

  /** \brief An observation begins. */
  void
  begin();

  /** \brief Waits for the next one.
   * \param[in] idle is called now and then; may throw
   * \return false when the user wants no more: q, or the end of the input */
  bool
  wait(const std::function<void()>& idle);

private:
  using Clock = std::chrono::steady_clock;

  std::optional<double> every_;
  bool asks_;
  Clock::time_point begin_ = Clock::now();
};

} // namespace pcl::acmap
