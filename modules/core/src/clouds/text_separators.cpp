#include "clouds/digit_groups.h"
#include "clouds/text_columns.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace pcl::acmap {

namespace {

bool
areDigits(std::string_view text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return c >= '0' && c <= '9';
  });
}

std::string_view
withoutSign(std::string_view word)
{
  if (!word.empty() && (word[0] == '-' || word[0] == '+'))
    word.remove_prefix(1);
  return word;
}

/** Digits, a comma, digits, and perhaps an exponent. */
bool
hasDecimalComma(std::string_view word)
{
  word = withoutSign(word);
  word = word.substr(0, word.find_first_of("eE"));
  const std::size_t comma = word.find(',');
  return comma != word.npos && areDigits(word.substr(0, comma)) &&
         areDigits(word.substr(comma + 1));
}

/** 1,234 or 1,234,567.8: up to three digits, and groups of three. */
bool
hasGroups(std::string_view word)
{
  word = withoutSign(word);
  word = word.substr(0, word.find('.'));
  std::size_t comma = word.find(',');
  constexpr std::size_t group = 3; // digits; without a comma, its place is beyond
  if (comma > group || !areDigits(word.substr(0, comma)) || word[0] == '0')
    return false;
  for (; comma != word.npos; comma = word.find(',')) {
    word.remove_prefix(comma + 1);
    if (word.find(',') != 3 && word.size() != 3)
      return false;
  }
  return areDigits(word);
}

/** \brief What the commas of all rows can be. */
class Commas {
public:
  void
  add(std::string_view row)
  {
    std::size_t words = 0;
    while (!row.empty() && is_within_) {
      const std::size_t end = row.find_first_of(" \t;|");
      if (const std::string_view word = row.substr(0, end); !word.empty()) {
        ++words;
        addWord(word);
      }
      row.remove_prefix(end == row.npos ? row.size() : end + 1);
    }
    is_within_ = is_within_ && words >= 3;
  }

  /** \brief Are they within numbers? */
  bool
  areDecimal(const ByteSource& source) const
  {
    if (!is_within_ || !any_)
      return false;
    if (mixed_)
      source.fail("has commas beside decimal points in its numbers, as in " +
                  inQuotes(example_) + ": write them without commas");
    if (groups_ && !decimal_)
      source.fail("has commas that are decimal commas or those of thousands, as in " +
                  inQuotes(example_) + ": write its numbers with decimal points only");
    return true;
  }

private:
  void
  addWord(std::string_view written)
  {
    if (written.find(',') == written.npos)
      return;
    const std::string word = withoutGroups(written).value_or(std::string(written));
    any_ = true;
    const bool decimal = hasDecimalComma(word), groups = hasGroups(word);
    if (!decimal && !groups && word.find('.') > word.find(','))
      is_within_ = false;
    if (example_.empty() || groups)
      example_ = written;
    decimal_ = decimal_ || (decimal && !groups);
    groups_ = groups_ || groups;
    mixed_ = mixed_ || !decimal;
  }

  std::string_view example_;
  bool is_within_ = true, any_ = false;
  bool decimal_ = false; ///< one that is no comma of thousands
  bool groups_ = false;  ///< one that may be a comma of thousands
  bool mixed_ = false;   ///< one that is no decimal comma
};

/** Does each row have two of them or more, and nothing else between numbers? */
bool
isSeparator(char separator,
            TextLayout::Separators separators,
            const std::vector<std::string_view>& rows)
{
  std::vector<std::string_view> fields;
  for (const std::string_view row : rows) {
    if (std::count(row.begin(), row.end(), separator) < 2)
      return false;
    splitRow(row, separators, fields);
    for (const std::string_view field : fields) {
      if (withoutGroups(field))
        continue;
      double value = 0;
      const std::size_t end = field.find_first_of(" \t,;");
      const bool is_one = end == field.npos || field.find_first_of(" \t;", end) == end;
      if (end != field.npos && is_one && parseNumber(field.substr(0, end), value))
        return false;
    }
  }
  return true;
}

/** Digits after decimal commas stand in columns of their own if commas separate. */
void
refuseDigitColumns(const TextHead& head, const ByteSource& source)
{
  std::vector<std::string_view> fields;
  bool has_zeros = false;
  for (const std::string_view row : head.rows) {
    splitRow(row, TextLayout::Separators::Commas, fields);
    if (fields.size() < 6 || fields.size() % 2 != 0)
      return;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (!areDigits(withoutSign(fields[i])) || (i % 2 == 1 && !areDigits(fields[i])))
        return;
      has_zeros =
          has_zeros || (i % 2 == 1 && fields[i].size() > 1 && fields[i][0] == '0');
    }
  }
  if (has_zeros)
    source.fail(
        "seems to have decimal commas, and commas between its columns: write it "
        "with decimal points");
}

/** Are there numbers whose thousands are marked by blanks? */
bool
hasBlankGroups(TextLayout::Separators separators,
               const std::vector<std::string_view>& rows)
{
  std::vector<std::string_view> fields;
  for (const std::string_view row : rows) {
    splitRow(row, separators, fields);
    for (const std::string_view field : fields)
      if (field.find(' ') != field.npos && withoutGroups(field))
        return true;
  }
  return false;
}

} // namespace

void
findSeparators(const TextHead& head, TextLayout& layout, const ByteSource& source)
{
  using Separators = TextLayout::Separators;
  Commas commas;
  for (const std::string_view row : head.rows)
    commas.add(row);
  layout.has_decimal_commas = commas.areDecimal(source);
  if (layout.has_decimal_commas)
    layout.separators = Separators::Blanks;
  if (isSeparator(';', Separators::Semicolons, head.rows))
    layout.separators = Separators::Semicolons;
  else if (isSeparator('|', Separators::Bars, head.rows))
    layout.separators = Separators::Bars;
  else if (isSeparator('\t', Separators::Tabs, head.rows) &&
           hasBlankGroups(Separators::Tabs, head.rows))
    layout.separators = Separators::Tabs;
  else if (layout.has_decimal_commas)
    return;
  else if (isSeparator(',', Separators::Commas, head.rows)) {
    layout.separators = Separators::Commas;
    refuseDigitColumns(head, source);
  }
}

} // namespace pcl::acmap
