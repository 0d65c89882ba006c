#include "files/text_fields.h"

#include "files/byte_source.h"

namespace pcl::acmap {

std::string_view
nextWord(Words& row, const ByteSource& source)
{
  std::string_view word;
  if (!row.next(word))
    source.failAtLine("has fewer values than the header names");
  return word;
}

void
storeField(Words& row,
           const FieldLayout& layout,
           std::size_t field,
           std::uint8_t* point,
           const ByteSource& source)
{
  const SourceField& from = layout.source[field];
  const FieldLayout::Target& target = layout.targets[field];
  std::uint8_t* to = point + target.offset;
  for (std::int64_t i = 0; i < from.count; ++i) {
    const std::string_view word = nextWord(row, source);
    if (from.isPadding())
      continue;
    if (!storeNumber(word, target.datatype, to))
      source.failAtLine(inQuotes(word) + " is no value of field " +
                        inQuotes(from.name));
    to += sizeOfType(target.datatype);
  }
}

} // namespace pcl::acmap
