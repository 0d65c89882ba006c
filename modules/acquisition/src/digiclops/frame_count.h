#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pcl::acmap {

/** \brief Tells which frames of a stream did not come: by the camera's own counter, or
 * without one by the time between them. */
class FrameCount {
public:
  /** \brief A new stream: what came before says nothing about it.
   * \param[in] period seconds between two frames */
  void
  begin(double period);

  /** \brief A frame came.
   * \param[in] counter that the camera wrote into it
   * \param[in] stamp microseconds
   * \return how many were lost before it; less than 0 when fewer were lost than was
   * thought before, as frames that waited come in a bunch; nothing for a frame with a
   * counter that none can have */
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
  std::optional<std::uint32_t> odd_; // what the last frame had, and none can have
  double behind_ = 0;                // periods that passed without the counter
  int missing_ = 0;                  // by time
};

} // namespace pcl::acmap
