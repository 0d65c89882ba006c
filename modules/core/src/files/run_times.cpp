#include <pcl/core/impl/json_text.h>
#include <pcl/core/run_times.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>

namespace pcl {

namespace {

namespace fs = std::filesystem;

/** \brief The path that a variable of the environment holds; empty if it is not absolute. */
fs::path
placeIn(const char* variable)
{
  const char* const value = std::getenv(variable);
  const fs::path path = value ? value : "";
  return path.is_absolute() ? path : fs::path();
}

std::optional<fs::path>
fileOfTimes()
{
  constexpr const char* name = "acmap/run_times.json";
  if (const fs::path cache = placeIn("XDG_CACHE_HOME"); !cache.empty())
    return cache / name;
  if (const fs::path home = placeIn("HOME"); !home.empty())
    return home / ".cache" / name;
  return {};
}

bool
areInOrder(const RunTimes& times)
{
  constexpr double longest = 1e7; // seconds
  if (times.size() < 2 || times.front() != std::make_pair(0.0, 0.0) ||
      times.back().first != 1 || !(times.back().second < longest))
    return false;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i].first > times[i - 1].first &&
          times[i].second >= times[i - 1].second))
      return false;
  return true;
}

} // namespace

RunTimes
recallRunTimes(const std::string& kind)
{
  const auto file = fileOfTimes();
  if (!file)
    return {};
  try {
    RunTimes times = acmap::readJson(file->string()).at(kind).get<RunTimes>();
    return areInOrder(times) ? times : RunTimes();
  }
  catch (const nlohmann::json::exception&) {
    return {};
  }
}

void
rememberRunTimes(const std::string& kind, const RunTimes& times)
{
  const auto file = fileOfTimes();
  if (!file)
    return;
  try {
    nlohmann::ordered_json all = acmap::readJson(file->string());
    if (!all.is_object())
      all = nlohmann::ordered_json::object();
    all[kind] = times;
    fs::create_directories(file->parent_path());
    acmap::saveJson(file->string(), all, -1);
  }
  catch (const std::exception&) {
    return; // the next run estimates without
  }
}

} // namespace pcl
