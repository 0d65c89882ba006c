#pragma once

#include <cstdint>
#include <deque>

namespace pcl::acmap {

/** \brief Measures the recent frame rate, from time stamps. */
class RateMeter {
public:
  void
  add(std::uint64_t stamp)
  {
    stamps_.push_back(stamp);
    while (stamps_.size() > 2 && stamps_.back() - stamps_.front() > window)
      stamps_.pop_front();
  }

  /** \return 0 before the second frame */
  double
  perSecond() const
  {
    if (stamps_.size() < 2 || stamps_.back() <= stamps_.front())
      return 0;
    return static_cast<double>(stamps_.size() - 1) * 1e6 /
           static_cast<double>(stamps_.back() - stamps_.front());
  }

private:
  static constexpr std::uint64_t window = 2000000; // microseconds
  std::deque<std::uint64_t> stamps_;
};

} // namespace pcl::acmap
