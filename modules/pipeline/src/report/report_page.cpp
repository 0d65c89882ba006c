#include "report/report_page.h"

#include "report/quality_page.h"
#include "report/report_fields.h"

#include <pcl/core/image_file.h>
#include <pcl/core/impl/base64.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/map_quality.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* unknown = "–";

const Json nothing;

/** A number, or the number of entries of a list. */
std::optional<double>
numberIn(const Json& json)
{
  if (json.is_array())
    return static_cast<double>(json.size());
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

/** Prints a number with groups of three digits; a typographic minus sign stands before
 * it unless it was rounded to zero. */
std::string
printed(const char* format, int digits, double value)
{
  std::array<char, 400> buffer{}; // the largest double has 309 digits
  std::snprintf(buffer.data(), buffer.size(), format, digits, std::abs(value));
  std::string text = buffer.data();
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  if (text.find('e') == std::string::npos)
    for (std::size_t end = std::min(text.find('.'), text.size()); end > 3; end -= 3)
      text.insert(end - 3, ",");
  return value < 0 && !is_zero ? "−" + text : text;
}

std::string
fixedText(double value, int digits)
{
  return printed("%.*f", digits, value);
}

/** Three significant digits, or all digits before the decimal point. */
std::string
numberText(double value)
{
  // whole numbers are not exact in a double beyond this
  constexpr double max_whole = 1e15;
  const bool is_whole = std::abs(value) >= 999.5 && std::abs(value) < max_whole;
  return is_whole ? fixedText(value, 0) : printed("%.*g", 3, value);
}

/** "0.25 s", "12.3 s", "3 min 05 s" */
std::string
secondsText(double seconds)
{
  if (seconds < 119.95)
    return fixedText(seconds, seconds < 9.995 ? 2 : 1) + " s";
  const double minutes = std::floor(std::round(seconds) / 60);
  const double rest = std::round(seconds) - 60 * minutes;
  return fixedText(minutes, 0) + " min " + (rest < 10 ? "0" : "") + fixedText(rest, 0) +
         " s";
}

/** "813 bytes", "1.2 MB", with powers of 1000 */
std::string
bytesText(double bytes)
{
  if (bytes < 1000)
    return fixedText(bytes, 0) + " bytes";
  const char* const units[] = {"kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  for (bytes /= 1000; bytes >= 999.5 && unit + 1 < std::size(units); ++unit)
    bytes /= 1000;
  return numberText(bytes) + " " + units[unit];
}

/** \param[in] format of a number: empty, its digits after the decimal point, "bytes",
 * "mm" (of metres), "percent" (of a share), "ratio", "seconds", or a noun that is counted
 * \return a dash if there is a format, but no number */
std::string
shown(const Json& value, const std::string& format)
{
  if (value.is_string() && format.empty())
    return value;
  const std::optional<double> number = numberIn(value);
  if (!number)
    return format.empty() ? "" : unknown;
  if (format.empty())
    return numberText(*number);
  if (std::isdigit(static_cast<unsigned char>(format[0])) != 0)
    return fixedText(*number, std::stoi(format));
  if (format == "bytes")
    return bytesText(*number);
  if (format == "mm")
    return numberText(1000 * *number) + " mm";
  if (format == "percent")
    return numberText(100 * *number) + " %";
  if (format == "ratio")
    return ratioText(*number);
  if (format == "seconds")
    return secondsText(*number);
  return numberText(*number) + " " + format + (*number == 1 ? "" : "s");
}

/** Escapes a text for HTML; control characters are replaced. */
std::string
escaped(const std::string& text)
{
  static const std::string special = "&<>\"'";
  constexpr const char* names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string html;
  for (const char character : text) {
    const std::size_t at = special.find(character);
    const auto byte = static_cast<unsigned char>(character);
    if (at != std::string::npos)
      html += names[at];
    else if (byte == 0x7F || (byte < 0x20 && character != '\n' && character != '\t'))
      html += "\uFFFD";
    else
      html += character;
  }
  return html;
}

/** Fills the places of a template of an HTML page. `{{path}}` and `{{path | format}}`
 * become that text or number of the values; `{{path | drawing}}` a text of this program, as it
 * is. What stands between `{{#if path}}` and
 * `{{/if path}}` stays if there is such a value; null, false, and empty texts and lists
 * are none. `{{#unless path}}` is the contrary. What stands between `{{#each path}}` and
 * `{{/each path}}` is repeated for each entry of a list, of which it sees only the values.
 * Such a section may contain others, except of the same two words. */
std::string
filled(std::string_view page, const Json& values)
{
  std::string html;
  const auto takeUntil = [&page](const std::string& mark) {
    const std::string_view text = page.substr(0, page.find(mark));
    page.remove_prefix(std::min(page.size(), text.size() + mark.size()));
    return text;
  };
  static const std::regex place("(?:#(if|unless|each) )?(\\S*)(?: \\| (\\w+))?");
  for (;;) {
    html += takeUntil("{{");
    if (page.empty())
      return html;
    const std::string mark(takeUntil("}}"));
    std::smatch words;
    std::regex_match(mark, words, place);
    const std::string kind = words[1], name = words[2];
    const Json& value = fieldOf(values, name);
    if (kind.empty()) {
      html += words[3] == "drawing" ? textOf(values, name)
                                    : escaped(shown(value, words[3]));
      continue;
    }
    const std::string_view section = takeUntil("{{/" + mark.substr(1) + "}}");
    if (kind == "each") {
      for (const Json& entry : listOf(values, name))
        html += filled(section, entry);
      continue;
    }
    const bool is_there = !value.empty() && value != Json("") && value != Json(false);
    if (is_there == (kind == "if"))
      html += filled(section, values);
  }
}

/** The details of all stages; if several stages have one, that of the last. */
Json
detailsOf(const Json& report)
{
  Json details = Json::object();
  for (const Json& stage : listOf(report, "stages"))
    if (const Json& its = fieldOf(stage, "details"); its.is_object())
      details.update(its);
  return details;
}

/** Quotes the strings of a list as a command line for a shell. */
std::string
commandText(const Json& arguments)
{
  static const std::regex plain("[a-zA-Z0-9_./:=,+@%-]+"), quote("'");
  std::string line;
  for (const Json& json : arguments)
    if (json.is_string()) {
      const std::string argument = json;
      line += line.empty() ? "" : " ";
      line += std::regex_match(argument, plain)
                  ? argument
                  : "'" + std::regex_replace(argument, quote, "'\\''") + "'";
    }
  return line;
}

/** The warnings of the stages and of the run, without duplicates. */
Json
warningsOf(const Json& report)
{
  Json warnings = Json::array();
  std::set<Json> told;
  const auto add = [&](const Json& stage, const Json& texts) {
    for (const Json& text : texts)
      if (text.is_string() && told.insert(text).second)
        warnings.push_back({{"stage", stage}, {"text", text}});
  };
  for (const Json& stage : listOf(report, "stages"))
    add(fieldOf(stage, "name"), listOf(stage, "warnings"));
  add(nothing, listOf(report, "remarks"));
  return warnings;
}

/** The picture is read completely before it is taken: a browser would show half of a
 * damaged picture, or none, without a message. */
Json
pictureOf(const std::string& folder,
          const std::string& name,
          const std::string& caption)
{
  Json picture = {{"file", name}, {"caption", caption.empty() ? name : caption}};
  try {
    const std::string path = (std::filesystem::path(folder) / name).string();
    const RgbImage image = loadRgbImage(path);
    std::ifstream file(path, std::ios::binary);
    const std::string data =
        base64(std::string(std::istreambuf_iterator<char>(file), {}));
    if (data.rfind("iVBORw0KGgo", 0) == 0) // the signature of a PNG
      picture.update({{"width", std::to_string(image.width)},
                      {"height", std::to_string(image.height)},
                      {"data", data}});
  }
  catch (const InputFileException&) { // the page says that the picture is missing
  }
  return picture;
}

Json
picturesOf(const Json& report, const std::string& folder)
{
  Json pictures = Json::array();
  for (const Json& picture : listOf(report, "pictures"))
    if (const std::string name = textOf(picture, "file"); !name.empty())
      pictures.push_back(pictureOf(folder, name, textOf(picture, "caption")));
  return pictures;
}

/** Equation such as "1.0000 x - 0.0024 y + 0.0000 z - 1.2100 = 0", with typographic
 * minus signs; a line may only break before a sign. */
std::string
equationOf(const Json& plane)
{
  constexpr std::array<const char*, 4> factors = {
      "\u00A0x +\u00A0", "\u00A0y +\u00A0", "\u00A0z +\u00A0", "\u00A0=\u00A00"};
  // resolution: 0.006 degrees for the normal, 0.1 mm for the offset
  constexpr int digits = 4;
  std::string text;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto value = numberIn(fieldOf(plane, "coefficients/" + std::to_string(i)));
    if (!value)
      return unknown;
    text += fixedText(*value, digits) + factors[i];
  }
  static const std::regex plus_minus("\\+\u00A0−");
  return std::regex_replace(text, plus_minus, "−\u00A0");
}

Json
planesOf(const Json& details)
{
  Json planes = Json::array();
  for (const Json& plane : listOf(details, "planes")) {
    const auto rmse = numberIn(fieldOf(plane, "rmse"));
    planes.push_back({{"id", numberIn(fieldOf(plane, "id")).value_or(planes.size())},
                      {"description", fieldOf(plane, "description")},
                      {"equation", equationOf(plane)},
                      {"area", fieldOf(plane, "area")},
                      {"rmse_mm", rmse ? Json(1000 * *rmse) : nothing},
                      {"support", fieldOf(plane, "support")}});
  }
  return planes;
}

/** What describes the map in fewer bits than planes. */
Json
primitivesOf(const Json& details)
{
  static const std::pair<const char*, const char*> kinds[] = {
      {"cylinders", "cylinder_report"},
      {"boxes", "box_report"},
      {"recesses", "recess_report"}};
  Json primitives = Json::array();
  for (const auto& [kind, name] : kinds) {
    const Json& report = fieldOf(details, name);
    const auto found = numberIn(fieldOf(report, kind));
    if (found && *found > 0)
      primitives.push_back({{"kind", kind},
                            {"found", fieldOf(report, kind)},
                            {"before", fieldOf(report, "bits_before")},
                            {"after", fieldOf(report, "bits_after")}});
  }
  return primitives;
}

/** The seconds of the stages and of the run outside of its stages, and their sum
 * without stages that were reused from an earlier run. */
Json
timesOf(const Json& report)
{
  Json stages = Json::array();
  std::set<std::string> told; // names of stages and steps
  double run_seconds = 0, reused_stages = 0;
  const auto add = [&](const std::string& name, const Json& seconds, bool is_reused) {
    Json steps = Json::array();
    double sum = 0;
    for (const auto& [step, value] : seconds.items())
      if (value.is_number()) {
        steps.push_back(
            {{"name", step}, {"seconds", std::max(value.get<double>(), 0.0)}});
        sum += steps.back()["seconds"].get<double>();
        told.insert(step);
      }
    if (steps.empty())
      return;
    told.insert(name);
    (is_reused ? reused_stages : run_seconds) += is_reused ? 1 : sum;
    stages.push_back(
        {{"name", name}, {"seconds", sum}, {"is_reused", is_reused}, {"steps", steps}});
  };
  for (const Json& stage : listOf(report, "stages"))
    add(textOf(stage, "name"),
        fieldOf(stage, "seconds"),
        fieldOf(stage, "reused") == Json(true));
  Json rest = Json::object();
  for (const auto& [step, value] : fieldOf(report, "seconds").items())
    if (told.count(step) == 0)
      rest[step] = value;
  add("rest of the run", rest, false);
  return {{"stages", stages},
          {"run_seconds", run_seconds},
          {"reused_stages", reused_stages > 0 ? Json(reused_stages) : nothing}};
}

/** The files beside the page that one would open, if they are there. */
Json
linksOf(const std::string& folder)
{
  constexpr std::pair<const char*, const char*> files[] = {
      {"map.html", "the map, to walk through and measure in"},
      {"floor_plan.svg", "the floor plan"},
      {"floor_plan.dxf", "the floor plan for CAD"},
      {"map.ifc", "the building model (IFC)"},
      {"map.glb", "the textured planes (glTF)"}};
  Json links = Json::array();
  for (const auto& [file, text] : files)
    if (std::error_code error;
        std::filesystem::exists(std::filesystem::path(folder) / file, error))
      links.push_back({{"file", file}, {"text", text}});
  return links;
}

/** The roughest ones of the planes that have a description. */
Json
roughestOf(const Json& details, const Json& roughness)
{
  constexpr std::size_t most = 5;
  constexpr double min_area = 0.5; // square metres
  std::vector<std::pair<double, Json>> sorted;
  const Json& planes = listOf(details, "planes");
  for (std::size_t k = 0; k < std::min(planes.size(), roughness.size()); ++k)
    if (roughness[k].is_number() && !textOf(planes[k], "description").empty() &&
        numberIn(fieldOf(planes[k], "area")).value_or(0) >= min_area)
      sorted.emplace_back(
          roughness[k].get<double>(),
          Json{{"description", textOf(planes[k], "description")},
               {"roughness", roughness[k]},
               {"id",
                numberIn(fieldOf(planes[k], "id")).value_or(static_cast<double>(k))}});
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  sorted.resize(std::min(sorted.size(), most));
  Json list = Json::array();
  for (const auto& one : sorted)
    list.push_back(one.second);
  return list;
}

/** One of the four words; empty if the map was not judged. */
std::string
headingOf(const Json& quality)
{
  const std::string outcome = textOf(quality, "outcome");
  return std::count(map_quality_names.begin(), map_quality_names.end(), outcome) > 0
             ? outcome
             : "";
}

/** The sentence, which follows a heading. */
std::string
sentenceOf(const Json& quality)
{
  std::string sentence = textOf(quality, "sentence");
  if (!sentence.empty())
    sentence[0] =
        static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

/** Null if one of both is not known, or if the second is 0. */
Json
quotientOf(const Json& json, const char* first, const char* second)
{
  const auto a = numberIn(fieldOf(json, first)), b = numberIn(fieldOf(json, second));
  return a && b && *b != 0 ? Json(*a / *b) : nothing;
}

} // namespace

std::string
reportPage(const Json& report, const std::string& picture_folder)
{
  Json values = report.is_object() ? report : Json::object();
  const Json details = detailsOf(values);
  const Json quality = fieldOf(values, "quality");
  values.update(
      {{"details", details},
       {"share_on_planes", quotientOf(details, "points_on_planes", "finite_points")},
       {"compactness", quotientOf(details, "bytes/raw", "bytes/textured")},
       {"geometry_compactness", quotientOf(details, "bytes/raw", "bytes/geometry")},
       {"ate_ratio", quotientOf(values, "truth/ate_after_m", "truth/ate_before_m")},
       {"warnings", warningsOf(values)},
       {"command", commandText(listOf(values, "command_line"))},
       {"pictures", picturesOf(values, picture_folder)},
       {"energy", energyDrawing(fieldOf(details, "steps"))},
       {"heading", headingOf(quality)},
       {"sentence", sentenceOf(quality)},
       {"figures", figuresOf(quality)},
       {"places",
        placeDrawing(fieldOf(details, "plan"),
                     listOf(quality, "roughness"),
                     listOf(values, "next_positions/positions"))},
       {"next", listOf(values, "next_positions/positions")},
       {"roughest", roughestOf(details, listOf(quality, "roughness"))},
       {"links", linksOf(picture_folder)},
       {"planes", planesOf(details)},
       {"primitives", primitivesOf(details)},
       {"times", timesOf(values)}});
  // Nothing remains of a line with only the begin or end of a section.
  static const std::regex end("(\\{\\{[#/][^}]*\\}\\})\n");
  return filled(std::regex_replace(reportPageTemplate(), end, "$1"), values);
}

} // namespace pcl::acmap
