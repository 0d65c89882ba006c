#pragma once

#include <cmath>

namespace pcl::acmap::bench {

constexpr double degree = M_PI / 180, ///< radians
    centi = 100, milli = 1000;        ///< centimetres and millimetres of a metre

} // namespace pcl::acmap::bench
