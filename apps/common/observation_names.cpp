#include "observation_names.h"

#include "input_kind.h"
#include "output_target.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/folder_entries.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

std::vector<std::string>
pcdNames(const std::string& folder)
{
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputFileException(folder + ": is no folder");
  std::vector<std::string> names;
  for (const fs::path& entry : folderEntries(folder))
    if (endingOf(entry.string()) == ".pcd")
      names.push_back(entry.filename().string());
  if (names.empty())
    throw InputFileException(folder + ": holds no .pcd file");
  const InputKind kind = inputKindOf(folder);
  if (kind == InputKind::MergedMap || kind == InputKind::CompactMap)
    throw InputFileException(folder + ": its only .pcd file is a merged map, and no "
                                      "observation");
  return names;
}

/** The number in observation_0012.pcd; nothing in other names. */
std::optional<std::size_t>
numberOf(const std::string& name)
{
  constexpr std::string_view prefix = "observation_", ending = ".pcd";
  if (name.size() <= prefix.size() + ending.size() ||
      name.compare(0, prefix.size(), prefix) != 0)
    return std::nullopt;
  const char* const end = name.data() + name.size() - ending.size();
  std::size_t number = 0;
  const auto result = std::from_chars(name.data() + prefix.size(), end, number);
  if (result.ec != std::errc() || result.ptr != end)
    return std::nullopt;
  return number;
}

} // namespace

std::vector<std::string>
inSequence(std::vector<std::string> names)
{
  std::vector<std::string> numbered;
  for (const std::string& name : names)
    if (numberOf(name))
      numbered.push_back(name);
  // as text, observation_10000 would stand before observation_9999
  std::sort(
      numbered.begin(), numbered.end(), [](const std::string& a, const std::string& b) {
        return std::pair(*numberOf(a), a) < std::pair(*numberOf(b), b);
      });
  if (!numbered.empty())
    return numbered;
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string>
observationNames(const std::string& folder)
{
  return inSequence(pcdNames(folder));
}

bool
isNumbered(const std::string& name)
{
  return numberOf(name).has_value();
}

std::vector<std::size_t>
trajectoryRows(const std::string& trajectory,
               const std::vector<std::string>& names,
               std::size_t rows)
{
  std::vector<std::size_t> found(names.size());
  std::iota(found.begin(), found.end(), std::size_t{0});
  if (names.size() == rows)
    return found;
  for (std::size_t& row : found) {
    const std::string& name = names[row];
    row = numberOf(name).value_or(row);
    if (row >= rows)
      throw InputFileException(trajectory + ": has " + std::to_string(rows) +
                               " poses, none for " + name);
  }
  return found;
}

} // namespace pcl::acmap
