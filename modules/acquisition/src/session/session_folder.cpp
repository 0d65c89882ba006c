#include "session_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/impl/hidden_folder.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/output_file.h>
#include <pcl/core/rig_cameras.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t number_digits = 6; // minimum
constexpr const char* summary_name = "session.yaml";
const std::string frame_begin = "frame_";

/** The frame number of a file name; nothing unless it is exactly the name that the
 * recorder uses. */
std::optional<std::uint64_t>
numberOfFile(const std::string& name)
{
  if (name.size() <= frame_begin.size())
    return std::nullopt;
  std::uint64_t number = 0;
  std::from_chars(name.data() + frame_begin.size(), name.data() + name.size(), number);
  if (frameFileName(number) != name)
    return std::nullopt;
  return number;
}

std::array<bool, 3>
readCameras(const YamlNode& list)
{
  std::array<bool, 3> cameras{};
  for (const YamlNode& entry : list.list(0, cameras.size())) {
    std::size_t camera = 0;
    while (camera < cameras.size() &&
           entry.text() != nameOf(static_cast<RigCamera>(camera)))
      ++camera;
    if (camera == cameras.size() || cameras[camera])
      entry.fail("is no camera, or stands twice: reference, horizontal, vertical");
    cameras[camera] = true;
  }
  return cameras;
}

void
sync(const std::string& path, int flags)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | flags);
  const int fault = file >= 0 && ::fsync(file) == 0 ? 0 : errno;
  if (file >= 0)
    ::close(file);
  // Special files do not support fsync; some writable folders cannot be opened for
  // reading.
  if (fault != 0 && fault != EINVAL && fault != EACCES)
    throw OutputFileException(shownPath(path) + ": " + std::strerror(fault));
}

} // namespace

std::string
frameFileName(std::uint64_t number)
{
  std::string digits = std::to_string(number);
  if (digits.size() < number_digits)
    digits.insert(0, number_digits - digits.size(), '0');
  return frame_begin + digits + ".acf";
}

std::string
pathIn(const std::string& folder, const std::string& name)
{
  return (fs::path(folder) / name).string();
}

std::string
sessionText(const SessionSummary& summary)
{
  std::string cameras;
  for (std::size_t camera = 0; camera < summary.cameras.size(); ++camera)
    if (summary.cameras[camera])
      cameras += (cameras.empty() ? "" : ", ") +
                 std::string(nameOf(static_cast<RigCamera>(camera)));
  return "%YAML:1.0\n---\nversion: " + std::to_string(file_formats::session) +
         "\nrig: " + summary.rig + "\nframes: " + std::to_string(summary.frames) +
         "\nobservations: " + std::to_string(summary.observations) +
         "\npatterns: " + std::to_string(summary.patterns) + "\ncameras: [" + cameras +
         "]\n";
}

void
saveSessionSummary(const std::string& folder, const SessionSummary& summary)
{
  const std::string text = sessionText(summary);
  const std::string path = pathIn(folder, summary_name);
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
  syncToDisk(path);
}

SessionSummary
readSessionSummary(const YamlNode& map)
{
  constexpr std::size_t maximum = std::size_t{1} << 31;
  requireFormat(map, file_formats::session, "version");
  map.requireKeys({"version", "rig", "frames", "observations", "patterns", "cameras"});
  SessionSummary summary;
  summary.rig = map.at("rig").text();
  if (fs::path(summary.rig).filename() != summary.rig || summary.rig == ".." ||
      summary.rig == "." || summary.rig.find('\0') != std::string::npos)
    map.at("rig").fail("must name a file in the folder of the session");
  summary.frames = map.at("frames").count(0, maximum);
  summary.observations = map.at("observations").count(0, maximum);
  summary.patterns = map.at("patterns").count(0, maximum);
  summary.cameras = readCameras(map.at("cameras"));
  return summary;
}

std::optional<SessionSummary>
loadSessionSummary(const std::string& folder)
{
  const std::string path = pathIn(folder, summary_name);
  std::error_code error;
  if (!fs::exists(path, error) && !error)
    return std::nullopt;
  return readSessionSummary(loadYaml(path));
}

std::vector<std::uint64_t>
listFrames(const std::string& folder)
{
  std::vector<std::uint64_t> numbers;
  for (const fs::path& entry : folderEntries(folder))
    if (const auto number = numberOfFile(entry.filename().string()))
      numbers.push_back(*number);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

bool
holdsSession(const std::string& folder)
{
  std::error_code error;
  for (const char* const name : {summary_name, "rig.yaml"})
    if (fs::exists(pathIn(folder, name), error))
      return true;
  return !listFrames(folder).empty();
}

void
removeSessionFiles(const std::string& folder)
{
  std::error_code error;
  for (const char* const name : {summary_name, "rig.yaml"})
    fs::remove(pathIn(folder, name), error);
}

std::string
faultOfSize(const ImageRecord& image, const TrinocularRig& rig)
{
  if (image.width == static_cast<std::uint32_t>(rig.width) &&
      image.height == static_cast<std::uint32_t>(rig.height))
    return "";
  return sizeText(image) + " pixels, the rig has " + sizeText(rig);
}

std::string
faultUnderRig(const FrameHeader& header, const TrinocularRig& rig)
{
  for (const RigCamera camera : rig_cameras) {
    const ImageRecord& image = header.images[static_cast<std::size_t>(camera)];
    const bool is_expected = hasCamera(rig, camera);
    std::string fault;
    if (is_expected != (image.width > 0))
      fault = is_expected ? "has no image, the rig has such a camera"
                          : "has an image, the rig has no such camera";
    else if (is_expected)
      fault = faultOfSize(image, rig);
    if (!fault.empty())
      return std::string(nameOf(camera)) + " camera: " + fault;
  }
  return "";
}

void
syncToDisk(const std::string& path)
{
  sync(path, 0);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  sync(folder.empty() ? "." : folder, O_DIRECTORY);
}

} // namespace pcl::acmap
