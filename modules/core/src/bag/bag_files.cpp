#include "bag/bag_files.h"

#include <pcl/core/bag_file.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/impl/yaml_node.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace pcl {

namespace acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* metadata_name = "metadata.yaml";
constexpr const char* metadata_key = "rosbag2_bagfile_information";

[[noreturn]] void
fail(const std::string& path, const std::string& fault)
{
  throw InputFileException(path + ": " + fault);
}

bool
isPacked(const fs::path& path)
{
  return path.extension() == ".zstd" || path.extension() == ".zst";
}

/** \brief Ending of a file of a bag, also of one that is packed or was not closed. */
std::string
endingOfBag(fs::path path)
{
  if (isPacked(path) || path.extension() == ".active")
    path = path.stem();
  return path.extension().string();
}

bool
isNameOfBag(const fs::path& path)
{
  constexpr std::array<const char*, 3> endings = {".mcap", ".db3", ".bag"};
  return std::count(endings.begin(), endings.end(), endingOfBag(path)) > 0;
}

std::string
listOf(const std::vector<std::string>& paths)
{
  constexpr std::size_t max_named = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(paths.size(), max_named); ++i)
    list += (i > 0 ? ", " : "") + fs::path(paths[i]).filename().string();
  return list + (paths.size() > max_named ? ", ..." : "");
}

/** \brief Names of files that belong together if only their numbers differ, and the number
 * at their end. */
struct NumberedName {
  std::string others; ///< with # for each number
  std::size_t number = 0;
};

std::optional<NumberedName>
numberedName(const fs::path& path)
{
  const std::string stem = path.stem().string();
  const std::size_t line = stem.rfind('_');
  constexpr std::size_t max_digits = 6;
  const std::string digits = line == stem.npos ? "" : stem.substr(line + 1);
  if (digits.empty() || digits.size() > max_digits ||
      digits.find_first_not_of("0123456789") != digits.npos)
    return {};
  NumberedName name{{}, std::stoul(digits)};
  for (const char letter : stem.substr(0, line)) {
    const bool is_digit = letter >= '0' && letter <= '9';
    if (!is_digit || name.others.empty() || name.others.back() != '#')
      name.others += is_digit ? '#' : letter;
  }
  name.others += path.extension().string();
  return name;
}

/** \brief Files of bags, numbered from 0 without gaps, in their order; nothing if they are
 * not. */
std::optional<std::vector<std::string>>
seriesOf(const std::vector<fs::path>& files)
{
  std::map<std::size_t, std::string> by_number;
  std::string others;
  for (const fs::path& file : files) {
    const std::optional<NumberedName> name = numberedName(file);
    if (!name || (!by_number.empty() && name->others != others) ||
        !by_number.emplace(name->number, file.string()).second)
      return {};
    others = name->others;
  }
  if (by_number.empty() || by_number.rbegin()->first != files.size() - 1)
    return {};
  std::vector<std::string> series;
  for (const auto& [number, path] : by_number)
    series.push_back(path);
  return series;
}

std::vector<fs::path>
bagsIn(const std::string& folder)
{
  std::vector<fs::path> bags;
  std::error_code error;
  for (const fs::path& entry : folderEntries(folder))
    if (isNameOfBag(entry) && fs::is_regular_file(entry, error))
      bags.push_back(entry);
  return bags;
}

/** \brief The files that a metadata.yaml names, by their names alone: early versions of
 * rosbag2 wrote the folder before them; empty if the YAML is another one. */
std::vector<std::string>
filesOfMetadata(const fs::path& folder)
{
  constexpr std::size_t max_files = 1000000;
  const YamlNode yaml = loadYaml((folder / metadata_name).string());
  const YamlNode* const recording = yaml.find(metadata_key);
  std::vector<std::string> files;
  if (!recording)
    return files;
  for (const YamlNode& path : recording->at("relative_file_paths").list(1, max_files)) {
    const std::string name = fs::path(path.text()).filename().string();
    if (!isPlainName(name))
      path.fail("is no name of a file");
    files.push_back((folder / name).string());
  }
  return files;
}

/** \brief A packed file, or what was unpacked of it. */
std::string
unpackedFile(const std::string& path)
{
  if (!isPacked(path))
    return path;
  const std::string unpacked = fs::path(path).replace_extension().string();
  std::error_code error;
  if (fs::exists(unpacked, error))
    return unpacked;
  fail(path, "is packed: run zstd -d " + path + ", which writes " + unpacked);
}

BagFiles
filesOfFolder(const std::string& folder)
{
  std::error_code error;
  BagFiles files;
  if (fs::exists(fs::path(folder) / metadata_name, error))
    for (const std::string& path : filesOfMetadata(folder)) {
      files.paths.push_back(unpackedFile(path));
      if (!fs::exists(files.paths.back(), error))
        fail(files.paths.back(),
             "is missing, the recording has it according to its metadata.yaml");
    }
  if (!files.paths.empty())
    return files;
  const std::vector<fs::path> bags = bagsIn(folder);
  if (bags.empty())
    fail(folder, "has no bag: no file .mcap, .db3 or .bag");
  const auto series = bags.size() == 1
                          ? std::vector<std::string>{bags.front().string()}
                          : seriesOf(bags).value_or(std::vector<std::string>());
  if (series.empty())
    fail(folder,
         "has " + std::to_string(bags.size()) +
             " bags and no metadata.yaml that orders them; give one of them");
  for (const std::string& path : series)
    files.paths.push_back(unpackedFile(path));
  if (series.size() > 1)
    files.remarks.push_back(folder + ": has no metadata.yaml; its files were taken as "
                                     "one recording in the order of their numbers");
  return files;
}

/** \brief The files of the recording of which a file is a part; empty if it is alone. */
std::vector<std::string>
recordingOf(const fs::path& path)
{
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code error;
  try {
    if (fs::exists(folder / metadata_name, error))
      return filesOfMetadata(folder);
    std::vector<fs::path> bags;
    const std::optional<NumberedName> name = numberedName(path);
    for (const fs::path& bag : bagsIn(folder.string()))
      if (const auto other = numberedName(bag); name && other)
        if (other->others == name->others)
          bags.push_back(bag);
    return seriesOf(bags).value_or(std::vector<std::string>());
  }
  catch (const InputFileException&) {
    return {}; // the file can be read without its folder
  }
}

BagFiles
filesOfFile(const std::string& path)
{
  BagFiles files{{path}, {}};
  if (isPacked(path) && isNameOfBag(path))
    files.paths.front() = unpackedFile(path);
  std::vector<std::string> others = recordingOf(path);
  const auto same = [&](const std::string& other) {
    return fs::path(other).filename() == fs::path(path).filename();
  };
  const auto part = std::find_if(others.begin(), others.end(), same);
  if (part == others.end() || others.size() < 2)
    return files;
  const std::string place = std::to_string(part - others.begin() + 1) + " of " +
                            std::to_string(others.size());
  others.erase(part);
  const std::string folder = fs::path(path).parent_path().string();
  files.remarks.push_back(
      path + ": is part " + place +
      " of a recording, the only one that was read; the others are " + listOf(others) +
      "; give the folder " + (folder.empty() ? "." : folder) + " to read them all");
  return files;
}

/** \brief Does a metadata.yaml of rosbag2 stand in the folder? It may be damaged. */
bool
hasMetadata(const fs::path& folder)
{
  std::ifstream file(folder / metadata_name, std::ios::binary);
  std::string begin(4096, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.find(metadata_key) != begin.npos;
}

} // namespace

BagFiles
findBagFiles(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(path, error) ? filesOfFolder(path) : filesOfFile(path);
}

} // namespace acmap

bool
BagFile::isBag(const std::string& path)
{
  std::error_code error;
  if (!acmap::fs::is_directory(path, error))
    return acmap::isNameOfBag(path);
  try {
    return acmap::hasMetadata(path) || !acmap::bagsIn(path).empty();
  }
  catch (const InputFileException&) {
    return false;
  }
}

} // namespace pcl
