#pragma once

#include <array>

namespace pcl::acmap {

/** Front and back colour of surfaces without colours. */
constexpr std::array<double, 3> front_color = {0.80, 0.80, 0.78};
constexpr std::array<double, 3> back_color = {0.55, 0.62, 0.78};

} // namespace pcl::acmap
