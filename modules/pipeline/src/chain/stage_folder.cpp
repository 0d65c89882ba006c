#include "chain/stage_folder.h"

#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/impl/hidden_folder.h>
#include <pcl/core/impl/json_text.h>
#include <pcl/pipeline/fingerprint.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Json = StageFolder::Json;

constexpr const char* state_name = "stage.json";
const std::string picture_folder = "pictures/";

/** Does a name from a state file, which may be of anybody, stay in the folder? */
bool
isResultName(const std::string& name)
{
  const bool is_picture = name.rfind(picture_folder, 0) == 0;
  return isPlainName(is_picture ? name.substr(picture_folder.size()) : name);
}

/** Reads stage.json of the folder.
 * \return a discarded value if it is missing or damaged
 * \throws OutputFileException when a newer version of acmap wrote it */
Json
readState(const fs::path& folder)
{
  const Json state = readJson((folder / state_name).string());
  if (!state.is_object() || !state.contains("format") ||
      !state["format"].is_number_unsigned())
    return state;
  const std::string fault =
      faultOfFormat(state["format"].get<std::uint64_t>(), file_formats::stage);
  if (!fault.empty())
    throw OutputFileException((folder / state_name).string() + ": " + fault);
  return state;
}

/** The JSON as it is read back from a file, with invalid UTF-8 replaced. */
Json
asWritten(const Json& json)
{
  return Json::parse(jsonText(json));
}

/** Names, sizes and times of files; a missing file has only a name. */
Json
filesStateOf(const std::string& folder, const std::vector<std::string>& names)
{
  Json state = Json::array();
  for (const std::string& name : names) {
    const fs::path path = fs::path(folder) / name;
    std::error_code error;
    const auto size = fs::file_size(path, error);
    const auto time = error ? fs::file_time_type() : fs::last_write_time(path, error);
    if (error)
      state.push_back({name});
    else
      state.push_back({name, size, time.time_since_epoch().count()});
  }
  return state;
}

/** The same as it is read back. */
Json
resultsIn(const std::string& folder, const std::vector<std::string>& names)
{
  return asWritten(filesStateOf(folder, names));
}

Json
toldIn(const StageNotes& notes)
{
  if (notes.told.empty())
    return Json::object();
  Json told = Json::parse(notes.told, nullptr, false);
  if (!told.is_object())
    throw acmap::BadArgument("what is told of a stage is no JSON object");
  return told;
}

} // namespace

StageFolder::StageFolder(std::string path,
                         const StageKey& key,
                         std::string result_folder)
: path_(std::move(path))
, made_of_(Json::object())
, result_folder_(result_folder.empty() ? path_ : std::move(result_folder))
{
  for (const auto& [name, value] : key.entries())
    made_of_[name] = value;
  made_of_["version"] = ACMAP_VERSION;
  made_of_ = asWritten(made_of_);
}

std::optional<StageNotes>
StageFolder::finished() const
{
  try {
    const Json state = readState(path_);
    if (!state.is_object() || state.at("made_of") != made_of_ ||
        !state.at("finished").get<bool>() || !state.at("told").is_object())
      return std::nullopt;
    std::vector<std::string> names;
    for (const Json& result : state.at("results"))
      names.push_back(result.at(0).get<std::string>());
    if (resultsIn(result_folder_, names) != state.at("results"))
      return std::nullopt;
    return StageNotes{jsonText(state.at("told")),
                      state.at("remarks").get<std::vector<std::string>>()};
  }
  catch (const nlohmann::json::exception&) {
    return std::nullopt; // damaged, or written by another version
  }
}

bool
StageFolder::isInterrupted() const
{
  const Json state = readState(path_);
  return state.is_object() && state.contains("made_of") &&
         state["made_of"] == made_of_ && state.contains("finished") &&
         state["finished"] == false;
}

Json
StageFolder::earlierResults() const
{
  try {
    const Json state = readState(path_);
    if (!state.is_object())
      return Json::array();
    Json entries = Json::array();
    for (const Json& entry :
         state.at(state.at("finished").get<bool>() ? "results" : "earlier"))
      if (entry.at(0).is_string() && isResultName(entry.at(0).get<std::string>()))
        entries.push_back(entry);
    return entries;
  }
  catch (const nlohmann::json::exception&) {
    return Json::array(); // damaged
  }
}

void
StageFolder::requireNoStrangers(const Json& earlier) const
{
  const auto refuse = [&](const std::string& name) {
    throw OutputFileException(path_ + ": holds " + name +
                              ", which is not of a stage; name another folder, or "
                              "remove it");
  };
  std::set<std::string> known = {state_name};
  for (const Json& entry : earlier)
    known.insert(entry.at(0).get<std::string>());
  std::error_code error;
  const bool is_stage = fs::exists(fs::path(path_) / state_name, error);
  for (fs::directory_iterator entry(path_, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool may_be_ours = is_stage && entry->is_regular_file(error) &&
                             (earlier.empty() || known.count(name) != 0);
    if (!may_be_ours)
      refuse(name);
  }
  if (error)
    throw OutputFileException(path_ + ": " + error.message());
}

void
StageFolder::abandon() const
{
  std::error_code ignored;
  if (!earlierResults().empty())
    return; // a later run must know which results it may replace
  fs::remove_all(path_, ignored);
  fs::remove(fs::path(path_).parent_path(), ignored); // fails if it is not empty
}

void
StageFolder::begin() const
{
  removeLeftoversIn(path_);
  if (isInterrupted())
    return;
  std::error_code error;
  const Json earlier = earlierResults();
  if (fs::exists(path_, error)) {
    requireNoStrangers(earlier);
    removeAllButState(error);
  }
  if (!error)
    fs::create_directories(path_, error);
  if (error)
    throw OutputFileException(path_ + ": " + error.message());
  try {
    write({{"format", file_formats::stage},
           {"made_of", made_of_},
           {"finished", false},
           {"earlier", result_folder_ == path_ ? Json::array() : earlier}});
  }
  catch (...) {
    abandon();
    throw;
  }
}

void
StageFolder::removeAllButState(std::error_code& error) const
{
  for (const std::string& name : filesIn(path_))
    if (name != state_name && !error)
      fs::remove(fs::path(path_) / name, error);
}

std::vector<std::string>
StageFolder::removeStale(const std::vector<std::string>& names) const
{
  std::vector<std::string> removed;
  for (const Json& entry : earlierResults()) {
    const auto name = entry.at(0).get<std::string>();
    const bool is_new = std::find(names.begin(), names.end(), name) != names.end();
    if (is_new || resultsIn(result_folder_, {name}) != Json::array({entry}))
      continue;
    std::error_code error;
    if (fs::remove(fs::path(result_folder_) / name, error))
      removed.push_back(name);
  }
  return removed;
}

std::vector<std::string>
StageFolder::finish(const StageNotes& notes,
                    const std::optional<std::vector<std::string>>& names) const
{
  std::vector<std::string> results = names ? *names : filesIn(path_);
  results.erase(std::remove(results.begin(), results.end(), state_name), results.end());
  std::vector<std::string> removed = removeStale(results);
  write({{"format", file_formats::stage},
         {"made_of", made_of_},
         {"finished", true},
         {"results", filesStateOf(result_folder_, results)},
         {"remarks", notes.remarks},
         {"told", toldIn(notes)}});
  return removed;
}

void
StageFolder::write(const Json& state) const
{
  saveJson((fs::path(path_) / state_name).string(), state, 1);
}

std::vector<std::string>
filesIn(const std::string& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::path& entry : folderEntries(folder)) {
    const std::string name = entry.filename().string();
    if (name.front() != '.' && fs::is_regular_file(entry, error))
      names.push_back(name);
  }
  return names;
}

std::string
pictureName(const std::string& name)
{
  return picture_folder + name;
}

std::string
stateOf(const std::string& folder, const std::vector<std::string>& names)
{
  Fingerprint hash;
  hash.add(jsonText(filesStateOf(folder, names)));
  return hash.text();
}

std::string
stateOfFile(const std::string& path)
{
  const fs::path file(path);
  return stateOf(file.parent_path().string(), {file.filename().string()});
}

} // namespace pcl::acmap
