#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pcl::acmap {

/** \brief Counts the frames of a stream that did not arrive: by the camera's counter
 * or, without a counter, by the time between frames. */
class FrameCount {
public:
  /** \brief Begins a new stream and discards the state of the previous one.
   * \param[in] period seconds between two frames */
  void
  begin(double period);

  /** \brief Adds a frame.
   * \param[in] counter the value that the camera wrote into the frame
   * \param[in] stamp time of arrival, microseconds
   * \return number of frames that were lost before it; negative if fewer were lost than
   * counted so far, since waiting frames arrive in a burst; nothing if the counter
   * value is impossible */
  std::optional<int>
  add(std::optional<std::uint32_t> counter, std::uint64_t stamp);

private:
  std::optional<int>
  lostByCounter(std::uint32_t counter, double periods);

  int
  lostByTime(double periods);

  double period_ = 1;
  std::optional<std::uint64_t> stamp_;
  std::optional<std::uint32_t> counter_;
  std::optional<std::uint32_t> odd_; // impossible value of the last frame's counter
  double behind_ = 0;                // periods that the counter is behind the clock
  int missing_ = 0;                  // lost frames, estimated by time
};

} // namespace pcl::acmap
