#pragma once

#include <array>

namespace pcl::acmap {

/** Of surfaces without a colour of their own, seen from the front and from behind. */
constexpr std::array<double, 3> front_color = {0.80, 0.80, 0.78};
constexpr std::array<double, 3> back_color = {0.55, 0.62, 0.78};

} // namespace pcl::acmap
