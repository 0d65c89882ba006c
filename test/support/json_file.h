#pragma once

#include "temporary_folder.h"

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap::test {

inline nlohmann::json
jsonOfFile(const std::string& path)
{
  return nlohmann::json::parse(contentOf(path));
}

/** \brief The report in a folder. */
inline nlohmann::json
reportOf(const std::string& folder)
{
  return jsonOfFile(folder + "/report.json");
}

} // namespace pcl::acmap::test
