#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace pcl {

/** \brief Lets the time pass that passed between the shots of a session, as a camera gives them.
 * Pauses of more than a minute are cut.
 * \code
 * pcl::SessionSettings settings;
 * settings.arrived = pcl::SessionPace ([&] { window.update (); });
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT SessionPace {
public:
  /** \param[in] idle is called about ten times a second while a frame is waited for; what it
   * throws ends the session; may be empty */
  explicit SessionPace(std::function<void()> idle = {});

  /** \brief Returns when the frame is due, at once for the first one. */
  void
  operator()(const TrinocularFrame& frame);

private:
  std::function<void()> idle_;
  std::optional<std::uint64_t> stamp_;        // of the last frame, microseconds
  std::chrono::steady_clock::time_point due_; // when it was due
};

} // namespace pcl
