#include "calibrations/calibration_kinds.h"

#include "files/byte_source.h"
#include "files/text_number.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace pcl::acmap {

namespace {

bool
isRig(const YamlNode& map)
{
  return map.find("baseline_horizontal") || map.find("focal_length") ||
         map.find("camera_reference");
}

void
readRig(const YamlNode& map, Calibration& calibration)
{
  calibration.rig = readTrinocularRig(map);
  calibration.has_built_rig = map.find("camera_reference") != nullptr;
  CalibratedView view;
  view.camera = calibrationOf(*calibration.rig).camera(RigCamera::Reference);
  view.width = calibration.rig->width;
  view.height = calibration.rig->height;
  calibration.cameras.push_back({nameOf(RigCamera::Reference), {}, view});
}

constexpr CalibrationKind rig_kind{
    "acmap's rig.yaml",
    "baselines are places of the neighbours along x right and y down, metres",
    isRig,
    readRig};

/** \brief The table of conventions; the first kind that a file is of is read. */
const std::array<const CalibrationKind*, 14> kinds = {&rig_kind,
                                                      &plain_matrix_kind,
                                                      &kalibr_kind,
                                                      &middlebury_kind,
                                                      &euroc_kind,
                                                      &orb_slam_kind,
                                                      &orb_slam3_kind,
                                                      &stella_kind,
                                                      &camodocal_kind,
                                                      &kitti_raw_kind,
                                                      &kitti_kind,
                                                      &camera_info_kind,
                                                      &opencv_pair_kind,
                                                      &camera_json_kind};

/** \brief Are there only numbers, besides separators and comments? */
bool
hasOnlyNumbers(const std::string& text)
{
  bool has_digit = false;
  bool is_comment = false;
  for (const char c : text) {
    is_comment = c == '#' || (is_comment && c != '\n');
    if (is_comment)
      continue;
    if (std::string_view("0123456789").find(c) != std::string_view::npos)
      has_digit = true;
    else if (std::string_view("+-.eE,;[] \t\r\n").find(c) == std::string_view::npos)
      return false;
  }
  return has_digit;
}

/** \brief The text as YAML, of which JSON is a part. */
std::string
yamlOf(const std::string& name, const std::string& text)
{
  const std::string head = text.substr(0, 4096);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && head[first] == '<')
    throw InputFileException(name + ": is XML, which is not read: OpenCV's FileStorage "
                                    "writes the same as .yml");
  if (hasOnlyNumbers(text))
    return yamlOfNumbers(text);
  if (isOstText(text))
    return yamlOfOst(text);
  const std::size_t camera = head.find("cam0");
  const bool is_first = camera == first || (camera != 0 && camera < head.size() &&
                                            head[camera - 1] == '\n');
  if (camera != std::string::npos && is_first) {
    const std::size_t sign = head.find_first_not_of(" \t", camera + 4);
    if (sign != std::string::npos && head[sign] == '=')
      return yamlOfMiddlebury(text);
  }
  return text;
}

std::string
namesOfKinds()
{
  std::string names;
  for (const CalibrationKind* const kind : kinds)
    names += (names.empty() ? "" : ", ") + std::string(kind->name);
  return names;
}

/** \brief The keys of a document, for a message. */
std::string
someKeys(const YamlNode& map)
{
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, map.keys().size()); ++i)
    text += (i > 0 ? ", " : "") + inQuotes(map.keys()[i].text());
  return text;
}

constexpr const char* numbers_advice =
    "; numbers alone, as fx fy cx cy in a text, are read, too, and --baseline states "
    "where the neighbour is";

/** \throws InputFileException for what is no YAML either, as INI files and arrays */
YamlNode
documentOf(const std::string& name, const std::string& text)
{
  const std::string yaml = yamlOf(name, text);
  try {
    return parseYaml(name, yaml);
  }
  catch (const InputFileException& fault) {
    throw InputFileException(fault.what() + std::string(numbers_advice));
  }
}

} // namespace

Calibration
readCalibration(const std::string& name, const std::string& text)
{
  const YamlNode map = documentOf(name, text);
  for (const CalibrationKind* const kind : kinds) {
    if (!kind->is(map))
      continue;
    Calibration calibration;
    calibration.kind = kind->name;
    calibration.convention = kind->convention;
    kind->read(map, calibration);
    if (calibration.cameras.empty())
      throw InputFileException(name + ": has no calibrated camera");
    return calibration;
  }
  throw InputFileException(name + ": is no calibration that is known (" +
                           namesOfKinds() + "); its keys are " + someKeys(map) +
                           numbers_advice);
}

namespace {

std::string
textOfCalibration(const std::string& path)
{
  constexpr std::uint64_t max_bytes = std::uint64_t{1} << 20;
  ByteSource source(path);
  if (source.remaining() > max_bytes)
    source.fail("has " + std::to_string(source.remaining()) +
                " bytes, more than a calibration ever has");
  std::string text(static_cast<std::size_t>(source.remaining()), ' ');
  source.read(text.data(), text.size());
  return text;
}

/** \brief A document without the lines that begin and end it. */
std::string
bodyOf(const std::string& text)
{
  std::istringstream lines(text);
  std::string body;
  std::string line;
  while (std::getline(lines, line))
    if (line.rfind('%', 0) != 0 && line.rfind("---", 0) != 0 &&
        line.rfind("...", 0) != 0)
      body += line + "\n";
  return body;
}

} // namespace

std::vector<Calibration>
loadCalibrations(const std::vector<std::string>& paths)
{
  std::vector<std::string> texts;
  for (const std::string& path : paths)
    texts.push_back(textOfCalibration(path));
  if (paths.size() == 2) {
    const YamlNode first = documentOf(paths[0], texts[0]);
    const YamlNode second = documentOf(paths[1], texts[1]);
    if (areOpenCvHalves(first, second) || areOpenCvHalves(second, first))
      return {readCalibration(paths[0], bodyOf(texts[0]) + bodyOf(texts[1]))};
  }
  std::vector<Calibration> calibrations;
  for (std::size_t i = 0; i < paths.size(); ++i)
    calibrations.push_back(readCalibration(paths[i], texts[i]));
  return calibrations;
}

} // namespace pcl::acmap

pcl::Calibration
pcl::loadCalibration(const std::string& path)
{
  return acmap::loadCalibrations({path}).front();
}
