#include "report/closing_lines.h"

#include "report/report_fields.h"

#include <pcl/core/impl/size_text.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace pcl::acmap {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Lines = std::vector<std::pair<std::string, std::string>>;

/** What a stage reports; null if there was none. */
Json
detailsOfStage(const Json& report, const std::string& stage)
{
  for (const Json& made : listOf(report, "stages"))
    if (textOf(made, "name") == stage)
      return fieldOf(made, "details");
  return {};
}

/** "12 planes"; "1 plane". */
std::string
countText(std::size_t count, const std::string& one, const std::string& several)
{
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

std::string
joined(const std::vector<std::string>& parts, const char* between)
{
  std::string text;
  for (const std::string& part : parts)
    text += (text.empty() ? "" : between) + part;
  return text;
}

std::string
areaText(double area)
{
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.1f", area);
  return text.data();
}

std::string
surfacesText(const Json& report)
{
  constexpr std::array<std::array<const char*, 3>, 4> kinds = {
      {{"planes", "plane", "planes"},
       {"cylinders", "cylinder", "cylinders"},
       {"boxes", "box", "boxes"},
       {"recesses", "recess", "recesses"}}};
  std::vector<std::string> parts;
  for (const auto& [name, one, several] : kinds)
    if (const Json count = fieldOf(report, name); count.is_number() && count > 0)
      parts.push_back(countText(count.get<std::size_t>(), one, several));
  return joined(parts, ", ");
}

/** "3 rooms, 45.1 m²: 24.8, 12.0 and 8.3 m²" */
std::string
roomsText(const Json& rooms)
{
  constexpr std::size_t most = 8;
  double sum = 0;
  std::vector<std::string> areas;
  for (const Json& room : rooms) {
    const Json& told = fieldOf(room, "area");
    const double area = told.is_number() ? told.get<double>() : 0;
    sum += area;
    if (areas.size() < most)
      areas.push_back(areaText(area));
  }
  std::string text =
      countText(rooms.size(), "room", "rooms") + ", " + areaText(sum) + " m²";
  if (rooms.size() > 1)
    text += ": " + joined(areas, ", ") + (rooms.size() > most ? ", …" : "");
  return text;
}

/** "none is enclosed; 14.6 m² of floor"; empty without a floor. */
std::string
openFloorText(const Json& map)
{
  double sum = 0;
  for (const Json& plane : listOf(map, "planes"))
    if (const Json area = fieldOf(plane, "area");
        textOf(plane, "role") == "floor" && area.is_number())
      sum += area.get<double>();
  return sum > 0 ? "none is enclosed; " + areaText(sum) + " m² of floor" : "";
}

std::string
openingsText(const Json& openings)
{
  std::vector<std::string> parts;
  for (const auto& [kind, count] : openings.items())
    if (count.is_number() && count > 0)
      parts.push_back(countText(count.get<std::size_t>(), kind, kind + "s"));
  return joined(parts, ", ");
}

/** Half of the area of the planes has a smaller rmse, metres. */
double
middleNoise(const Json& planes)
{
  std::vector<std::pair<double, double>> noises; // rmse, area
  double all = 0, sum = 0;
  for (const Json& plane : planes) {
    const Json &rmse = fieldOf(plane, "rmse"), &area = fieldOf(plane, "area");
    if (!rmse.is_number() || !area.is_number())
      continue;
    noises.emplace_back(rmse.get<double>(), area.get<double>());
    all += noises.back().second;
  }
  std::sort(noises.begin(), noises.end());
  for (const auto& [noise, area] : noises)
    if ((sum += area) >= all / 2)
      return noise;
  return 0;
}

std::string
accuracyText(const Json& report, const Json& map)
{
  std::vector<std::string> parts;
  if (const double noise = middleNoise(listOf(map, "planes")); noise > 0)
    parts.push_back("points within " + shortNumber(1000 * noise) +
                    " mm of their planes (rms, half of the area)");
  if (const Json e95 = fieldOf(detailsOfStage(report, "rectification"), "verdict/e95");
      e95.is_number())
    parts.push_back("poses within " + shortNumber(e95.get<double>()) + " m (95 %)");
  return joined(parts, ", ");
}

/** "Good: surfaces are sharp to 4 mm" */
std::string
qualityText(const Json& quality)
{
  const Json outcome = fieldOf(quality, "outcome"),
             sentence = fieldOf(quality, "sentence");
  if (!outcome.is_string() || !sentence.is_string())
    return "";
  return outcome.get<std::string>() + ": " + sentence.get<std::string>();
}

std::string
unseenText(const Json& quality)
{
  const Json seen = fieldOf(quality, "coverage/value");
  if (!seen.is_number() || seen >= 1)
    return "";
  return shortNumber(100 * (1 - seen.get<double>())) +
         " % of floors, ceilings and walls; report.html tells where to look next";
}

void
add(Lines& lines, const char* name, std::string value)
{
  if (!value.empty())
    lines.emplace_back(name, std::move(value));
}

} // namespace

Lines
closingLines(const Json& report)
{
  const Json map = detailsOfStage(report, "map");
  const Json quality = fieldOf(report, "quality");
  Lines lines;
  add(lines, "map", qualityText(quality));
  add(lines, "surfaces", surfacesText(report));
  if (const Json rooms = fieldOf(map, "rooms"); rooms.is_array())
    add(lines, "rooms", rooms.empty() ? openFloorText(map) : roomsText(rooms));
  if (const Json openings = fieldOf(map, "openings"); openings.is_object())
    add(lines, "openings", openingsText(openings));
  add(lines, "accuracy", accuracyText(report, map));
  add(lines, "not seen", unseenText(quality));
  return lines;
}

} // namespace pcl::acmap
