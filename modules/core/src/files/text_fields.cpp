#include "files/text_fields.h"

#include "files/byte_source.h"

namespace pcl::acmap {

std::string_view
TextRow::next()
{
  std::string_view word;
  if (words_.next(word))
    return word;
  std::string_view line;
  if (!is_breakable_ || !source_.readFilledLine(line))
    source_.failAtLine("has fewer values than the header names");
  is_broken_ = true;
  words_ = Words(line);
  words_.next(word);
  return word;
}

bool
TextRow::finish()
{
  std::string_view word;
  const bool is_longer = words_.next(word);
  if (is_longer && is_broken_)
    source_.failAtLine(
        "goes on after the values that the row before it lacks: that row "
        "has fewer than the header names");
  return is_longer;
}

void
storeField(TextRow& row,
           const FieldLayout& layout,
           std::size_t field,
           std::uint8_t* point,
           double* place,
           const ByteSource& source)
{
  const SourceField& from = layout.source[field];
  const FieldLayout::Target& target = layout.targets[field];
  std::uint8_t* to = point + target.offset;
  for (std::int64_t i = 0; i < from.count; ++i) {
    const std::string_view word = row.next();
    if (from.isPadding())
      continue;
    if (!storeNumber(word, target.datatype, to))
      source.failAtLine(inQuotes(word) + " is no value of field " +
                        inQuotes(from.name));
    to += sizeOfType(target.datatype);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (layout.coordinates[axis] == field)
        parseNumber(word, place[axis]);
  }
}

} // namespace pcl::acmap
