#pragma once

#include "file_numbers.h"

#include <nlohmann/json.hpp>

namespace pcl::acmap::test {

/** \brief Summary of many numbers. Differences in the last bits of some numbers
 * change it by less than \ref unit; a different decision of an algorithm changes
 * it by more. */
struct NumberSummary {
  std::size_t count = 0;   ///< of all numbers
  std::size_t missing = 0; ///< numbers that are not finite
  double mean = 0;         ///< of the finite ones, as are the following
  double spread = 0;       ///< standard deviation
  double order =
      0; ///< mean product with random weights: changes if two numbers are swapped

  explicit NumberSummary(const std::vector<double>& numbers);

  explicit NumberSummary(const nlohmann::json& stored);

  nlohmann::json
  json() const;

  /** \brief Tolerance of mean, spread and order. */
  double
  unit() const;

  bool
  agreesWith(const NumberSummary& stored) const;
};

/** \brief Summaries by file and field. */
nlohmann::json
fingerprintOf(const FileNumbers& numbers);

/** \brief Differences between two fingerprints, one line each. */
std::vector<std::string>
differencesOf(const nlohmann::json& found, const nlohmann::json& stored);

} // namespace pcl::acmap::test
