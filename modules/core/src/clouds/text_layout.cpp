#include "clouds/text_layout.h"

#include "clouds/digit_groups.h"
#include "clouds/field_names.h"
#include "files/text_number.h"

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::array<const char*, text_roles> role_names = {"-",
                                                            "x",
                                                            "y",
                                                            "z",
                                                            "red",
                                                            "green",
                                                            "blue",
                                                            "intensity",
                                                            "normal_x",
                                                            "normal_y",
                                                            "normal_z"};

std::string_view
trimmed(std::string_view text)
{
  constexpr const char* around = " \t\r\"'";
  const std::size_t begin = text.find_first_not_of(around);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(around) - begin + 1);
}

/** Fields with exactly one separator between two of them; one at the end of a line is no
 * field. */
void
splitStrictly(std::string_view line,
              char separator,
              std::vector<std::string_view>& fields)
{
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos)
      break;
    line.remove_prefix(end + 1);
  }
  while (!fields.empty() && fields.back().empty())
    fields.pop_back();
}

/** In small letters, with umlauts and accents of UTF-8 and Latin-1 written out. */
std::string
plainText(std::string_view text)
{
  static constexpr std::pair<std::string_view, std::string_view> letters[] = {
      {"\xc3\xb6", "oe"},
      {"\xc3\xbc", "ue"},
      {"\xc3\xa9", "e"},
      {"\xf6", "oe"},
      {"\xfc", "ue"},
      {"\xe9", "e"}};
  text = trimmed(text);
  std::string plain;
  while (!text.empty()) {
    const auto letter =
        std::find_if(std::begin(letters), std::end(letters), [&](const auto& pair) {
          return text.substr(0, pair.first.size()) == pair.first;
        });
    const char c = text.front();
    if (letter != std::end(letters))
      plain += letter->second;
    else
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    text.remove_prefix(letter != std::end(letters) ? letter->first.size() : 1);
  }
  return plain;
}

/** Where the unit of a name begins, as of x_mm and X (ft); npos without one. */
std::size_t
unitBegin(std::string_view name)
{
  const std::size_t bracket = name.find_first_of("[("), bar = name.rfind('_');
  if (bracket != name.npos || bar == name.npos)
    return bracket;
  return metresInUnit(name.substr(bar + 1)) ? bar : name.npos;
}

/** The same of a name without its unit. */
std::string
plainName(std::string_view name)
{
  name = trimmed(name);
  return plainText(name.substr(0, unitBegin(name)));
}

} // namespace

std::size_t
TextLayout::needed() const
{
  std::size_t needed = roles.size();
  while (needed > 0 && roles[needed - 1] == TextRole::None)
    --needed;
  return needed;
}

bool
TextLayout::has(TextRole role) const
{
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

std::string
TextLayout::told() const
{
  std::string text;
  for (std::size_t i = 0; i < std::max(roles.size(), names.size()); ++i) {
    text += i > 0 ? ", " : "";
    if (i < roles.size() && roles[i] != TextRole::None)
      text += nameOf(roles[i]);
    else
      text +=
          (i < names.size() && !names[i].empty() ? inPrint(names[i], 40)
                                                 : "column " + std::to_string(i + 1)) +
          " (left out)";
  }
  return text + (has_decimal_commas ? ", with decimal commas" : "");
}

void
splitRow(std::string_view line,
         TextLayout::Separators separators,
         std::vector<std::string_view>& fields)
{
  using Separators = TextLayout::Separators;
  fields.clear();
  for (const auto& [strict, separator] : {std::pair{Separators::Commas, ','},
                                          std::pair{Separators::Semicolons, ';'},
                                          std::pair{Separators::Bars, '|'},
                                          std::pair{Separators::Tabs, '\t'}})
    if (separators == strict)
      return splitStrictly(line, separator, fields);
  Words words(line,
              separators == Separators::Blanks ? Words::Separators::blanks
                                               : Words::Separators::blanks_and_commas);
  for (std::string_view word; words.next(word);)
    fields.push_back(trimmed(word));
}

bool
parseField(std::string_view field, bool has_decimal_comma, double& value)
{
  const std::size_t comma = has_decimal_comma ? field.find(',') : field.npos;
  if (comma == field.npos && parseNumber(field, value))
    return true;
  std::string text = withoutGroups(field).value_or(std::string(field));
  if (comma != field.npos)
    text[text.find(',')] = '.';
  return parseNumber(text, value);
}

TextRole
roleOfName(std::string_view name)
{
  static constexpr std::pair<std::string_view, TextRole> spellings[] = {
      {"r", TextRole::Red},
      {"g", TextRole::Green},
      {"b", TextRole::Blue},
      {"rf", TextRole::Red},
      {"gf", TextRole::Green},
      {"bf", TextRole::Blue},
      {"i", TextRole::Intensity},
      {"intensity", TextRole::Intensity},
      {"reflectance", TextRole::Intensity},
      {"scalar_intensity", TextRole::Intensity},
      {"east", TextRole::X},
      {"easting", TextRole::X},
      {"north", TextRole::Y},
      {"northing", TextRole::Y},
      {"height", TextRole::Z},
      {"elevation", TextRole::Z},
      {"altitude", TextRole::Z},
      {"points:0", TextRole::X},
      {"points:1", TextRole::Y},
      {"points:2", TextRole::Z},
      {"points_m_xyz:0", TextRole::X},
      {"points_m_xyz:1", TextRole::Y},
      {"points_m_xyz:2", TextRole::Z}};
  std::string lower = plainName(name);
  for (const auto& [spelling, role] : spellings)
    if (lower == spelling)
      return role;
  for (const char axis : {'x', 'y', 'z'})
    for (const char* form : {"?_coord", "coord_?", "coord?", "?coord", "pos_?"}) {
      std::string spelling(form);
      std::replace(spelling.begin(), spelling.end(), '?', axis);
      if (lower == spelling)
        lower = std::string(1, axis);
    }
  const std::string standard = standardName(lower);
  for (std::size_t role = 1; role < text_roles; ++role)
    if (standard == role_names[role])
      return static_cast<TextRole>(role);
  return TextRole::None;
}

TextRole
roleOfForeignName(std::string_view name)
{
  static constexpr std::pair<std::string_view, TextRole> spellings[] = {
      {"e", TextRole::X},          {"ostwert", TextRole::X},
      {"rechtswert", TextRole::X}, {"abscisse", TextRole::X},
      {"est", TextRole::X},        {"este", TextRole::X},
      {"n", TextRole::Y},          {"nordwert", TextRole::Y},
      {"hochwert", TextRole::Y},   {"ordonnee", TextRole::Y},
      {"nord", TextRole::Y},       {"norte", TextRole::Y},
      {"h", TextRole::Z},          {"ellipsoidal height", TextRole::Z},
      {"hoehe", TextRole::Z},      {"hauteur", TextRole::Z},
      {"altura", TextRole::Z},     {"altitud", TextRole::Z},
      {"cota", TextRole::Z},       {"quota", TextRole::Z},
      {"rot", TextRole::Red},      {"rouge", TextRole::Red},
      {"rojo", TextRole::Red},     {"rosso", TextRole::Red},
      {"gruen", TextRole::Green},  {"vert", TextRole::Green},
      {"verde", TextRole::Green},  {"blau", TextRole::Blue},
      {"bleu", TextRole::Blue},    {"azul", TextRole::Blue},
      {"blu", TextRole::Blue}};
  const std::string plain = plainName(name);
  for (const auto& [spelling, role] : spellings)
    if (plain == spelling)
      return role;
  return TextRole::None;
}

std::optional<double>
metresInUnit(std::string_view unit)
{
  constexpr double us_foot = 1200.0 / 3937;
  static constexpr std::pair<std::string_view, double> units[] = {
      {"m", 1},
      {"meter", 1},
      {"meters", 1},
      {"metre", 1},
      {"metres", 1},
      {"mm", 0.001},
      {"cm", 0.01},
      {"km", 1000},
      {"ft", 0.3048},
      {"foot", 0.3048},
      {"feet", 0.3048},
      {"us ft", us_foot},
      {"usft", us_foot},
      {"us-ft", us_foot},
      {"ftus", us_foot},
      {"ft us", us_foot},
      {"us feet", us_foot},
      {"survey feet", us_foot},
      {"us survey foot", us_foot},
      {"us survey feet", us_foot},
      {"in", 0.0254},
      {"inch", 0.0254},
      {"inches", 0.0254}};
  const std::string plain = plainText(unit);
  for (const auto& [spelling, metres] : units)
    if (plain == spelling)
      return metres;
  return std::nullopt;
}

std::string_view
unitOfName(std::string_view name)
{
  name = trimmed(name);
  const std::size_t begin = unitBegin(name);
  if (begin == std::string_view::npos)
    return {};
  if (name[begin] == '_')
    return name.substr(begin + 1);
  const std::size_t end = name.find_first_of("])", begin);
  return end == std::string_view::npos ? std::string_view()
                                       : name.substr(begin + 1, end - begin - 1);
}

std::vector<TextRole>
rolesOfColumns(const std::vector<std::string>& columns)
{
  std::vector<TextRole> roles;
  for (const std::string& column : columns) {
    const TextRole role = roleOfName(column);
    if (role == TextRole::None && column != "-")
      throw acmap::BadArgument("columns: ",
                               inQuotes(column),
                               " is none of x, y, z, red, green, blue, intensity, "
                               "normal_x, normal_y, normal_z and -");
    if (role != TextRole::None &&
        std::find(roles.begin(), roles.end(), role) != roles.end())
      throw acmap::BadArgument("columns: ", nameOf(role), " comes twice");
    roles.push_back(role);
  }
  for (const TextRole role : {TextRole::X, TextRole::Y, TextRole::Z})
    if (std::find(roles.begin(), roles.end(), role) == roles.end())
      throw acmap::BadArgument("columns: there is no ", nameOf(role));
  return roles;
}

const char*
nameOf(TextRole role)
{
  return role_names[static_cast<std::size_t>(role)];
}

bool
isTextComment(std::string_view line)
{
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (line.substr(0, 1) == ";" ||
      line.substr(0, 1) == "%") // or a row without its first
    return !isTextRow(line);
  return line.substr(0, 1) == "#" || line.substr(0, 2) == "//";
}

} // namespace pcl::acmap
