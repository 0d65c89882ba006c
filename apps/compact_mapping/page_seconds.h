#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Duration of a stage. */
struct StageSeconds {
  std::string name;
  bool is_reused = false; ///< its seconds are those of an earlier run
  std::vector<std::pair<std::string, double>> steps;

  double
  total() const;
};

/** \brief Duration of a run. */
struct RunSeconds {
  std::vector<StageSeconds> stages;

  /** \brief Sum over the steps of this run, without reused ones. */
  double
  total() const;
};

/** \brief The seconds of the stages; the seconds of the run outside of its stages are
 * an additional entry. */
RunSeconds
secondsOfRun(const nlohmann::ordered_json& report);

/** \brief Table of the stages and their steps with a bar for each; empty if no seconds
 * are known. */
std::string
secondsTable(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
