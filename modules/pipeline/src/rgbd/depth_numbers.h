#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Histogram of the numbers in depth images. */
class DepthNumbers {
public:
  /** \brief Adds the numbers of an image; 0 and 65535 measured nothing. */
  void
  add(const std::vector<std::uint16_t>& numbers);

  /** \brief How many numbers were added. */
  std::uint64_t
  count() const
  {
    return count_;
  }

  /** \brief The median number; 0 if there is none. */
  int
  median() const;

  /** \brief The greatest common divisor of all numbers; 0 if there is none. */
  int
  commonDivisor() const;

  /** \brief Numbers in a metre if the steps between depths grow with their square, as those
   * of a Kinect do: 2.85 mm at 1 m. Nothing if there are no such steps. */
  std::optional<double>
  scaleOfSteps() const;

private:
  std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(65536);
  std::uint64_t count_ = 0;
};

} // namespace pcl::acmap
