#pragma once

#include "file_numbers.h"

#include <nlohmann/json.hpp>

namespace pcl::acmap::test {

/** \brief What is kept of many numbers. The last bits of some may differ without a
 * difference here that is above \ref unit; another decision makes one. */
struct NumberSummary {
  std::size_t count = 0;   ///< all of them
  std::size_t missing = 0; ///< not finite
  double mean = 0;         ///< of the finite ones, as below
  double spread = 0;       ///< standard deviation
  double order =
      0; ///< mean product with random weights: changes where two change places

  explicit NumberSummary(const std::vector<double>& numbers);

  explicit NumberSummary(const nlohmann::json& stored);

  nlohmann::json
  json() const;

  /** \brief How far mean, spread and order may be off the stored ones. */
  double
  unit() const;

  bool
  agreesWith(const NumberSummary& stored) const;
};

/** \brief Summaries by file and field. */
nlohmann::json
fingerprintOf(const FileNumbers& numbers);

/** \brief What differs between two fingerprints, a line each. */
std::vector<std::string>
differencesOf(const nlohmann::json& found, const nlohmann::json& stored);

} // namespace pcl::acmap::test
