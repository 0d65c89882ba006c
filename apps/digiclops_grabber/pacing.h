#pragma once

#include "grabber_options.h"

#include <chrono>
#include <functional>
#include <optional>

namespace pcl::acmap {

/** \brief Decides when the next observation begins: by a clock, by the Enter key, or
 * immediately. */
class Pacing {
public:
  /** \param[in] every seconds from start to start; none: wait for the key, if standard
   * input is a terminal */
  explicit Pacing(const std::optional<double>& every);

  /** \brief Does it wait for the key? */
  bool
  asks() const
  {
    return asks_;
  }

  /** \brief Marks the start of an observation. */
  void
  begin();

  /** \brief Waits for the next one.
   * \param[in] idle is called repeatedly; may throw
   * \return false when the user ends the run: q, or the end of the input */
  bool
  wait(const std::function<void()>& idle);

private:
  using Clock = std::chrono::steady_clock;

  std::optional<double> every_;
  bool asks_;
  Clock::time_point begin_ = Clock::now();
};

} // namespace pcl::acmap
