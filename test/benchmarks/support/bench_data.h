#pragma once

#include "test_data.h"

#include <iostream>
#include <optional>
#include <string>

namespace pcl::acmap::bench {

/** \brief The path of a file of the test data; nothing, with a message on stderr, if it
 * is missing. */
inline std::optional<std::string>
pathOfData(const std::string& relative)
{
  if (test::hasTestData(relative))
    return test::testDataPath(relative).string();
  std::cerr << "left out: no " << relative << " in ACMAP_TEST_DATA\n";
  return std::nullopt;
}

} // namespace pcl::acmap::bench
