#include <pcl/core/trinocular_rig.h>

#include "files/rig_text.h"
#include "files/text_number.h"

#include <pcl/core/file_format.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/output_file.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_grabber.h>

#include <utility>
#include <vector>

namespace pcl {

namespace {

constexpr int max_pixels = 32768; // per side
constexpr double longest_focal_length = 1e6;
constexpr double farthest_center = 1e6;
constexpr double longest_baseline = 100.0;
constexpr double largest_disparity_sigma = 1000.0;
constexpr const char* center_of_neighbour = "center_x_horizontal";

/** \brief A real value of a rig and its legal range. */
struct RealKey {
  const char* name;
  double TrinocularRig::*value;
  double minimum;
  double maximum;
  const char* unit;
};

const std::vector<RealKey>&
realKeys()
{
  using Rig = TrinocularRig;
  static const std::vector<RealKey> keys = {
      {"focal_length", &Rig::focal_length, 1.0, longest_focal_length, "px"},
      {"center_x", &Rig::center_x, -farthest_center, farthest_center, "px"},
      {"center_y", &Rig::center_y, -farthest_center, farthest_center, "px"},
      {"baseline_horizontal",
       &Rig::baseline_horizontal,
       -longest_baseline,
       longest_baseline,
       "m"},
      {"baseline_vertical",
       &Rig::baseline_vertical,
       -longest_baseline,
       longest_baseline,
       "m"},
      {"disparity_sigma", &Rig::disparity_sigma, 0.0, largest_disparity_sigma, "px"}};
  return keys;
}

} // namespace

void
requireSoundRig(const TrinocularRig& rig)
{
  acmap::requireInRange("width", rig.width, 1, max_pixels, "px");
  acmap::requireInRange("height", rig.height, 1, max_pixels, "px");
  for (const RealKey& key : realKeys())
    acmap::requireInRange(key.name, rig.*key.value, key.minimum, key.maximum, key.unit);
  if (!rig.center_x_horizontal)
    return;
  acmap::requireInRange(center_of_neighbour,
                        *rig.center_x_horizontal,
                        -farthest_center,
                        farthest_center,
                        "px");
  if (rig.baseline_horizontal == 0.0 || rig.baseline_vertical != 0.0)
    throw acmap::BadArgument(std::string(center_of_neighbour) +
                             " is for a rig with a horizontal neighbour alone");
}

TrinocularRig
loadTrinocularRig(const std::string& path)
{
  return acmap::readTrinocularRig(acmap::loadYaml(path));
}

TrinocularRig
acmap::readTrinocularRig(const YamlNode& map)
{
  requireFormat(map, file_formats::rig);
  TrinocularRig rig;
  rig.width = static_cast<int>(map.at("width").count(1, max_pixels));
  rig.height = static_cast<int>(map.at("height").count(1, max_pixels));
  for (const RealKey& key : realKeys())
    rig.*key.value = map.at(key.name).number(key.minimum, key.maximum);
  if (const YamlNode* const center = map.find(center_of_neighbour)) {
    rig.center_x_horizontal = center->number(-farthest_center, farthest_center);
    if (rig.baseline_horizontal == 0.0 || rig.baseline_vertical != 0.0)
      center->fail("is for a rig with a horizontal neighbour alone");
  }
  return rig;
}

std::string
acmap::rigText(const TrinocularRig& rig)
{
  // A reader of format 1 would take the disparities for those without an offset.
  const std::string format = rig.center_x_horizontal
                                 ? "format: " + std::to_string(file_formats::rig) + "\n"
                                 : "";
  std::string text = "%YAML:1.0\n---\n" + format +
                     "width: " + std::to_string(rig.width) +
                     "\nheight: " + std::to_string(rig.height) + "\n";
  for (const RealKey& key : realKeys())
    text += std::string(key.name) + ": " + acmap::textOf(rig.*key.value) + "\n";
  if (rig.center_x_horizontal)
    text += std::string(center_of_neighbour) + ": " +
            acmap::textOf(*rig.center_x_horizontal) + "\n";
  return text;
}

void
saveTrinocularRig(const std::string& path, const TrinocularRig& rig)
{
  requireSoundRig(rig);
  const std::string text = acmap::rigText(rig);
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

CameraImage
loadCameraImage(const std::string& path)
{
  RgbImage image = loadRgbImage(path);
  return {image.width, image.height, 3, std::move(image.values)};
}

TrinocularGrabber::~TrinocularGrabber() noexcept = default;

} // namespace pcl
