#include "calibrations/calibration_kinds.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace pcl::acmap {

namespace {

/** \brief A title of ost.txt, and the keys for its numbers: of a camera alone as ROS' YAML has
 * them, of a pair as OpenCV's programs do. */
struct OstTitle {
  const char* title;
  const char* key;
  const char* key_of_pair; ///< null: the same of both cameras
};

constexpr std::array<OstTitle, 6> titles = {
    {{"width", "image_width", nullptr},
     {"height", "image_height", nullptr},
     {"camera matrix", "camera_matrix", "camera_matrix"},
     {"distortion", "distortion_coefficients", "distortion"},
     {"rectification", "rectification_matrix", "rectification"},
     {"projection", "projection_matrix", "projection"}}};

std::string_view
trimmedLine(std::string_view line)
{
  constexpr const char* around = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(around), line.size()));
  return line.substr(0, line.find_last_not_of(around) + 1);
}

const OstTitle*
titleOf(std::string_view line)
{
  const auto title =
      std::find_if(titles.begin(), titles.end(), [&](const OstTitle& one) {
        return line == one.title;
      });
  return title == titles.end() ? nullptr : &*title;
}

/** Number of cameras. */
std::ptrdiff_t
countMatrices(const std::string& text)
{
  std::istringstream lines(text);
  std::ptrdiff_t count = 0;
  for (std::string line; std::getline(lines, line);)
    count += trimmedLine(line) == "camera matrix" ? 1 : 0;
  return count;
}

} // namespace

bool
isOstText(const std::string& text)
{
  return countMatrices(text) > 0;
}

std::string
yamlOfOst(const std::string& text)
{
  const bool is_pair = countMatrices(text) == 2;
  std::istringstream lines(text);
  std::string yaml;
  int camera = 0;
  bool is_open = false; // do numbers of a title follow?
  for (std::string whole; std::getline(lines, whole);) {
    const std::string_view line = trimmedLine(whole);
    if (const OstTitle* const title = titleOf(line)) {
      camera += line == "camera matrix" ? 1 : 0;
      is_open =
          title->key_of_pair || camera == 0; // the second camera has the same size
      if (is_open)
        yaml +=
            "\n" +
            (is_pair && title->key_of_pair ? title->key_of_pair + std::to_string(camera)
                                           : title->key) +
            ":";
    }
    else if (!line.empty() && (line.front() == '[' || line.front() == '#'))
      is_open = false;
    else if (is_open)
      yaml += " " + std::string(line);
  }
  return yaml + "\n";
}

} // namespace pcl::acmap
