#pragma once

#include <cstdlib>

namespace pcl::acmap::test {

/** \brief Number of repetitions of a test that takes long: one number for CI, another one
 * for `sh cmake/bootstrap long`, which sets ACMAP_LONG. */
inline int
repetitions(int in_ci, int in_long)
{
  return std::getenv("ACMAP_LONG") ? in_long : in_ci;
}

} // namespace pcl::acmap::test
