#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief What a stage took. */
struct StageSeconds {
  std::string name;
  bool is_reused = false; ///< then its seconds are those of an earlier run
  std::vector<std::pair<std::string, double>> steps;

  double
  total() const;
};

/** \brief What a run took. */
struct RunSeconds {
  std::vector<StageSeconds> stages;

  /** \brief Of what this run did itself. */
  double
  total() const;
};

/** \brief The seconds of the stages, and, as one more, those of the run that are of
 * none. */
RunSeconds
secondsOfRun(const nlohmann::ordered_json& report);

/** \brief Stages and their steps with a bar each; empty where no seconds are known. */
std::string
secondsTable(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
