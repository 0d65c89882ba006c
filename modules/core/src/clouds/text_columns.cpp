#include "clouds/text_columns.h"

#include "files/byte_source.h"
#include "files/text_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace pcl::acmap {

namespace {

/** \brief The numbers of a column in the first rows. */
struct Column {
  std::vector<double> values;
  std::size_t words = 0; ///< fields that are no number
  bool are_whole = true; ///< written without a decimal point
  bool has_fractions = false;
  bool counts = true; ///< each number is that of the row before, and one more

  void
  add(std::string_view field, bool has_decimal_comma)
  {
    double value = 0;
    if (!parseField(field, has_decimal_comma, value)) {
      ++words;
      return;
    }
    are_whole = are_whole && field.find_first_of(".,eE") == field.npos;
    has_fractions = has_fractions || value != std::floor(value);
    counts = counts && are_whole && (values.empty() || value == values.back() + 1);
    values.push_back(value);
  }
};

std::vector<Column>
columnsOf(const TextHead& head, const TextLayout& layout)
{
  std::vector<Column> columns;
  std::vector<std::string_view> fields;
  for (std::size_t row = 0; row < head.rows.size(); ++row) {
    splitRow(head.rows[row], layout.separators, fields);
    if (row == 0 || fields.size() < columns.size())
      columns.resize(fields.size()); // those that all rows have
    for (std::size_t i = 0; i < columns.size(); ++i)
      columns[i].add(fields[i], layout.has_decimal_commas);
  }
  return columns;
}

/** "--columns -,x,y,z" for coordinates that follow \a before other columns. */
std::string
columnsAfter(std::size_t before)
{
  std::string text = "--columns ";
  for (std::size_t i = 0; i < before; ++i)
    text += "-,";
  return text + "x,y,z";
}

bool
areFractions(const std::vector<Column>& columns, std::size_t first)
{
  return first + 3 <= columns.size() &&
         std::all_of(columns.begin() + static_cast<std::ptrdiff_t>(first),
                     columns.begin() + static_cast<std::ptrdiff_t>(first + 3),
                     [](const Column& column) {
                       return column.words == 0 && column.has_fractions;
                     });
}

/** Do these columns of all rows have the length 1 together? */
bool
areUnit(const std::vector<Column>& columns, std::size_t first, std::size_t count)
{
  constexpr double rounding = 1e-3;
  for (std::size_t c = first; c < first + count; ++c)
    if (columns[c].words > 0)
      return false;
  for (std::size_t row = 0; row < columns[first].values.size(); ++row) {
    double square = 0;
    for (std::size_t c = first; c < first + count; ++c)
      square += columns[c].values[row] * columns[c].values[row];
    if (!(std::abs(square - 1) < rounding))
      return false;
  }
  return true;
}

/** \throws InputFileException for the rows of trajectories: a time, a place and a unit
 * quaternion, or a matrix of 3 x 4 numbers */
void
refusePoses(const std::vector<Column>& columns, const ByteSource& source)
{
  const bool is_tum = columns.size() == 8 && areUnit(columns, 4, 4);
  const bool is_kitti = columns.size() == 12 && areUnit(columns, 0, 3) &&
                        areUnit(columns, 4, 3) && areUnit(columns, 8, 3);
  if (is_tum || is_kitti)
    source.fail("is a list of poses, no cloud");
}

/** The column of x: the first one, unless that is a number of points. */
std::size_t
firstCoordinate(const std::vector<Column>& columns, const ByteSource& source)
{
  constexpr std::size_t many = 20; // rows
  std::size_t words = 0, whole = 0;
  while (words < columns.size() && columns[words].values.empty())
    ++words;
  if (words > 0 && words + 3 <= columns.size())
    source.fail("begins its rows with words: " + columnsAfter(words) +
                " leaves them out");
  if (columns.size() < 4)
    return 0;
  while (whole < columns.size() && columns[whole].words == 0 &&
         columns[whole].are_whole)
    ++whole;
  const Column& first = columns.front();
  const std::size_t rows = first.values.size();
  const bool is_number = whole > 0 && first.counts && rows > 2;
  if (is_number && (rows >= many || (whole == 1 && areFractions(columns, 1))))
    return 1;
  if (whole > 0 && (areFractions(columns, whole) || is_number))
    source.fail("may have its coordinates behind other columns: " +
                columnsAfter(is_number ? 1 : whole) +
                " says so, --columns x,y,z that they come first");
  return 0;
}

/** Are three columns colours, whole numbers up to 255 or fractions up to 1? Flags and counts
 * of echoes are whole, too, but smaller. Normals have the length 1. */
bool
areColors(const std::vector<Column>& columns, std::size_t first)
{
  constexpr double darkest = 16, unit = 0.01;
  if (first + 3 > columns.size())
    return false;
  bool are_whole = true;
  double least = 0, most = 0;
  for (std::size_t c = first; c < first + 3; ++c) {
    const Column& column = columns[c];
    if (column.words > 0)
      return false;
    are_whole = are_whole && column.are_whole;
    for (const double value : column.values) {
      if (!std::isfinite(value))
        return false;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  if (least < 0 || most > 255)
    return false;
  if (are_whole)
    return most >= darkest;
  const std::size_t rows = columns[first].values.size();
  std::size_t of_length_1 = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    double square = 0;
    for (std::size_t c = first; c < first + 3; ++c)
      square += columns[c].values[row] * columns[c].values[row];
    of_length_1 += std::abs(std::sqrt(square) - 1) < unit ? 1 : 0;
  }
  const bool are_fractions =
      std::all_of(columns.begin() + static_cast<std::ptrdiff_t>(first),
                  columns.begin() + static_cast<std::ptrdiff_t>(first + 3),
                  [](const Column& column) { return !column.are_whole; });
  return are_fractions && most <= 1 && most > 0 && 2 * of_length_1 < rows;
}

bool
isOpaque(const Column& column)
{
  return column.words == 0 &&
         std::all_of(column.values.begin(), column.values.end(), [](double value) {
           return value == 255 || value == 1;
         });
}

} // namespace

void
guessColumns(const TextHead& head,
             bool is_pts,
             TextLayout& layout,
             const ByteSource& source)
{
  const std::vector<Column> columns = columnsOf(head, layout);
  refusePoses(columns, source);
  const std::size_t x = firstCoordinate(columns, source), after = x + 3;
  layout.roles.assign(columns.size(), TextRole::None);
  if (columns.size() < after)
    return;
  const auto put = [&](std::size_t first, TextRole role) {
    for (std::size_t i = 0; i < 3; ++i)
      layout.roles[first + i] =
          static_cast<TextRole>(static_cast<std::size_t>(role) + i);
  };
  put(x, TextRole::X);
  std::vector<std::size_t> places;
  for (std::size_t c = after; c + 3 <= columns.size(); ++c)
    if (areColors(columns, c))
      places.push_back(c);
  const std::size_t others = columns.size() - after;
  if (is_pts && (others == 1 || others == 4) && columns[after].words == 0)
    layout.roles[after] = TextRole::Intensity;
  if (is_pts && others == 4)
    places.erase(std::remove(places.begin(), places.end(), after), places.end());
  else if (places.size() == 2 && places[0] == after && isOpaque(columns[after + 3]))
    places.pop_back(); // alpha
  layout.is_guessed = places.size() == 1;
  if (places.size() == 1)
    put(places.front(), TextRole::Red);
  else if (places.size() > 1)
    layout.remarks.push_back(
        "colours may be in columns " + std::to_string(places[0] + 1) + " to " +
        std::to_string(places[0] + 3) + " or " + std::to_string(places[1] + 1) +
        " to " + std::to_string(places[1] + 3) +
        " and were left out: --columns x,y,z,red,green,blue or --columns "
        "x,y,z,intensity,red,green,blue says which");
}

} // namespace pcl::acmap
