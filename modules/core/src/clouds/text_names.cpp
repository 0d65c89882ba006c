#include "clouds/text_columns.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::size_t rows_that_tell = 2000;

/** \return the lines that \a text has completely */
TextHead
headOf(std::string_view text, bool is_whole)
{
  TextHead head;
  while (!text.empty() && head.rows.size() < rows_that_tell) {
    const std::size_t end = text.find('\n');
    if (end == text.npos && !is_whole && !head.rows.empty())
      break;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    if (line.find_first_not_of(" \t") == line.npos)
      continue;
    std::uint64_t count = 0;
    std::string_view word;
    if (isTextComment(line)) {
      line.remove_prefix(std::min(line.find_first_not_of(" \t#/;%"), line.size()));
      if (head.rows.empty())
        head.comments.push_back(line);
    }
    else if (isTextRow(line))
      head.rows.push_back(line);
    else if (Words words(line);
             head.rows.empty() && words.next(word) && !parseCount(word, count))
      head.lines.push_back(line);
  }
  return head;
}

/** Is a word the unit of the name before it? */
bool
isUnit(std::string_view word)
{
  return word.substr(0, 1) == "[" || word.substr(0, 1) == "(";
}

/** \throws InputFileException for names of degrees */
void
refuseDegrees(const std::vector<std::string_view>& names, const ByteSource& source)
{
  for (const std::string_view name : names) {
    std::string lower(name);
    for (char& c : lower)
      c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (const char* degrees : {"lat", "latitude", "lon", "lng", "longitude"})
      if (lower == degrees)
        source.fail("has degrees of latitude and longitude (column " + inQuotes(name) +
                    "): project them to metres first");
  }
}

/** Colours and normals of which one is missing are none. */
void
leaveOutParts(TextLayout& layout)
{
  for (const TextRole first : {TextRole::Red, TextRole::NormalX}) {
    const auto begin = static_cast<std::size_t>(first);
    const auto is_one = [&](TextRole role) {
      return static_cast<std::size_t>(role) >= begin &&
             static_cast<std::size_t>(role) < begin + 3;
    };
    if (std::count_if(layout.roles.begin(), layout.roles.end(), is_one) != 3)
      std::replace_if(layout.roles.begin(), layout.roles.end(), is_one, TextRole::None);
  }
}

/** Names of other languages where no column has a usual one. */
void
takeForeignNames(TextLayout& layout)
{
  const TextLayout usual = layout;
  for (std::size_t i = 0; i < layout.roles.size(); ++i)
    if (const TextRole role = roleOfForeignName(layout.names[i]);
        layout.roles[i] == TextRole::None && !usual.has(role))
      layout.roles[i] = role;
}

/** \brief The unit of the coordinates, if their names have one.
 * \param[in] units of the columns
 * \throws InputFileException if x, y and z have several */
void
takeUnit(const std::vector<std::string_view>& units,
         TextLayout& layout,
         const ByteSource& source)
{
  for (std::size_t i = 0; i < std::min(units.size(), layout.roles.size()); ++i) {
    const bool is_place =
        layout.roles[i] >= TextRole::X && layout.roles[i] <= TextRole::Z;
    const std::optional<double> metres = metresInUnit(units[i]);
    if (is_place && !metres && !units[i].empty())
      layout.remarks.push_back("its column " + inQuotes(layout.names[i]) + " is in " +
                               inQuotes(units[i]) +
                               ", which is no unit that is known: metres were taken; "
                               "--scale states another");
    if (!is_place || !metres)
      continue;
    if (layout.unit && *layout.unit != *metres)
      source.fail("names several units of its coordinates: write them in one");
    layout.unit = metres;
  }
}

/** Surveys of some countries name the east y and the north x, in this order. */
void
tellOrder(TextLayout& layout)
{
  constexpr std::array<char, 3> of_surveys = {'y', 'x', 'z'};
  const auto is = [](const std::string& name, char letter) {
    return name.size() == 1 && (name[0] | 0x20) == letter;
  };
  if (std::search(layout.names.begin(),
                  layout.names.end(),
                  of_surveys.begin(),
                  of_surveys.end(),
                  is) != layout.names.end())
    layout.remarks.emplace_back(
        "its columns are y, x, z: if y is the east, as of surveys, the cloud is "
        "mirrored, and --columns with x in the place of y states it");
}

/** \brief Takes a line as the names of the columns.
 * \return false if there are no coordinates among them */
bool
takeNames(std::string_view line,
          std::size_t columns,
          TextLayout& layout,
          const ByteSource& source)
{
  using Separators = TextLayout::Separators;
  for (const Separators separators : {layout.separators,
                                      Separators::Any,
                                      Separators::Commas,
                                      Separators::Semicolons,
                                      Separators::Bars}) {
    std::vector<std::string_view> names;
    splitRow(line, separators, names);
    std::vector<std::string_view> units;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (!isUnit(names[i]))
        units.push_back(unitOfName(
            i + 1 < names.size() && isUnit(names[i + 1]) ? names[i + 1] : names[i]));
    names.erase(std::remove_if(names.begin(), names.end(), isUnit), names.end());
    TextLayout named = layout;
    named.roles.clear();
    named.names.assign(names.begin(), names.end());
    for (const std::string_view name : names)
      named.roles.push_back(roleOfName(name));
    refuseDegrees(names, source);
    takeForeignNames(named);
    std::array<std::size_t, text_roles> counts{};
    for (const TextRole role : named.roles)
      ++counts[static_cast<std::size_t>(role)];
    if (counts[1] == 0 || counts[2] == 0 || counts[3] == 0) {
      if (separators == layout.separators && separators != Separators::Any &&
          names.size() == columns)
        return false; // other separators stand within names
      continue;
    }
    while (separators != Separators::Any && separators != Separators::Blanks &&
           named.roles.size() > columns && named.roles.back() == TextRole::None) {
      named.roles.pop_back(); // of a column that is empty in all rows
      named.names.pop_back();
    }
    if (std::any_of(counts.begin() + 1, counts.end(), [](auto n) { return n > 1; }) ||
        named.roles.size() > columns)
      source.fail("names its columns " + inQuotes(line) + ", its rows have " +
                  std::to_string(columns) +
                  ": --columns x,y,z says what they are, - leaves one out");
    leaveOutParts(named);
    tellOrder(named);
    takeUnit(units, named, source);
    named.roles.resize(columns, TextRole::None);
    layout = std::move(named);
    return true;
  }
  return false;
}

/** Is a line that of the units below names, as "m;m;m"? */
bool
isOfUnits(std::string_view line, const TextLayout& layout)
{
  std::vector<std::string_view> fields;
  splitRow(line, layout.separators, fields);
  return !fields.empty() &&
         std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
           const std::string_view unit = unitOfName(field);
           return field.empty() || metresInUnit(unit.empty() ? field : unit);
         });
}

/** The largest number of fields of a row. */
std::size_t
mostFields(const TextHead& head, const TextLayout& layout)
{
  std::size_t most = 0;
  std::vector<std::string_view> fields;
  for (const std::string_view row : head.rows) {
    splitRow(row, layout.separators, fields);
    most = std::max(most, fields.size());
  }
  return most;
}

/** \throws InputFileException for names that nobody understands, and for what is no cloud */
void
passLine(std::string_view line,
         std::size_t columns,
         TextLayout& layout,
         const ByteSource& source)
{
  std::vector<std::string_view> names;
  splitRow(line, layout.separators, names);
  if (names.size() == columns)
    source.fail("names its columns " + inQuotes(line) +
                ": --columns x,y,z says what they are, - leaves one out");
  layout.remarks.emplace_back("a line of text above the points was left out");
}

} // namespace

bool
isTextRow(std::string_view line)
{
  std::size_t numbers = 0;
  Words words(line, Words::Separators::blanks_and_commas);
  for (std::string_view word; numbers < 3 && words.next(word);) {
    double value = 0;
    const std::size_t begin = word.find_first_not_of("\"'");
    word.remove_prefix(std::min(begin, word.size()));
    word = word.substr(0, word.find_last_not_of("\"'") + 1);
    numbers += parseField(word, false, value) ? 1 : 0;
  }
  return numbers == 3;
}

TextLayout
findTextLayout(std::string_view text,
               bool is_pts,
               const std::vector<std::string>& columns,
               const ByteSource& source)
{
  TextHead head = headOf(text, text.size() == source.remaining());
  if (head.rows.empty())
    source.fail("has no row of three numbers");
  if (!head.lines.empty() && head.lines[0].substr(0, 5) == "ncols")
    source.fail(
        "is a grid of heights: gdal_translate -of XYZ makes a list of points of "
        "it");
  TextLayout layout;
  std::string_view units;
  if (head.lines.size() == 2 && isOfUnits(head.lines[1], {})) {
    units = head.lines[1];
    head.lines.pop_back();
  }
  if (head.lines.size() > 1)
    source.fail("begins with " + std::to_string(head.lines.size()) +
                " lines that are no points, as " + inQuotes(head.lines[0]));
  findSeparators(head, layout, source);
  const std::size_t most = mostFields(head, layout);
  if (!columns.empty()) {
    layout.roles = rolesOfColumns(columns);
    return layout;
  }
  if (!head.lines.empty() && takeNames(head.lines.back(), most, layout, source)) {
    std::vector<std::string_view> fields;
    splitRow(units, layout.separators, fields);
    takeUnit(fields, layout, source);
    return layout;
  }
  for (auto comment = head.comments.rbegin();
       head.lines.empty() && comment != head.comments.rend();
       ++comment)
    if (std::vector<std::string_view> names;
        splitRow(*comment, TextLayout::Separators::Any, names), names.size() == most)
      if (takeNames(*comment, most, layout, source))
        return layout;
  if (!head.lines.empty())
    passLine(head.lines.back(), most, layout, source);
  guessColumns(head, is_pts, layout, source);
  return layout;
}

} // namespace pcl::acmap
