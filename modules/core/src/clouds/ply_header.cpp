#include "clouds/ply_header.h"

#include "clouds/field_layout.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace pcl::acmap {

namespace {

std::uint8_t
datatypeOf(std::string_view type, const ByteSource& source)
{
  using Field = PCLPointField;
  struct Name {
    std::string_view first;
    std::string_view second;
    int datatype; // with _t as in C, too
  };
  static constexpr Name names[] = {{"char", "int8", Field::INT8},
                                   {"uchar", "uint8", Field::UINT8},
                                   {"short", "int16", Field::INT16},
                                   {"ushort", "uint16", Field::UINT16},
                                   {"int", "int32", Field::INT32},
                                   {"uint", "uint32", Field::UINT32},
                                   {"long", "int64", Field::INT64},
                                   {"ulong", "uint64", Field::UINT64},
                                   {"bool", "boolean", Field::UINT8},
                                   {"float", "float32", Field::FLOAT32},
                                   {"double", "float64", Field::FLOAT64}};
  std::string_view word = type;
  if (word.size() > 2 && word.substr(word.size() - 2) == "_t")
    word.remove_suffix(2);
  for (const Name& name : names)
    if (word == name.first || word == name.second)
      return static_cast<std::uint8_t>(name.datatype);
  source.failAtLine(inQuotes(type) + " is no type of PLY");
}

void
readFormat(Words& words, PlyHeader& header, const ByteSource& source)
{
  std::string_view word;
  words.next(word);
  if (word == "ascii")
    header.encoding = PlyHeader::Encoding::ascii;
  else if (word == "binary_little_endian")
    header.encoding = PlyHeader::Encoding::little_endian;
  else if (word == "binary_big_endian")
    header.encoding = PlyHeader::Encoding::big_endian;
  else
    source.failAtLine("format " + inQuotes(word) + " is not known");
}

void
requireFew(std::size_t count, const ByteSource& source)
{
  if (count >= max_fields)
    source.failAtLine("is one of more than " + std::to_string(max_fields));
}

void
readElement(Words& words, PlyHeader& header, const ByteSource& source)
{
  requireFew(header.elements.size(), source);
  std::string_view name;
  std::string_view rows;
  PlyElement element;
  if (!words.next(name) || !words.next(rows) || !parseCount(rows, element.rows))
    source.failAtLine("element " + inQuotes(name) + " has the count " + inQuotes(rows));
  element.name = name;
  header.elements.push_back(std::move(element));
}

void
readProperty(Words& words, PlyHeader& header, const ByteSource& source)
{
  if (header.elements.empty())
    source.failAtLine("property before any element");
  requireFew(header.elements.back().properties.size(), source);
  PlyProperty property;
  std::string_view type;
  words.next(type);
  if (type == "list") {
    words.next(type);
    property.length_datatype = datatypeOf(type, source);
    if (property.length_datatype == PCLPointField::FLOAT32 ||
        property.length_datatype == PCLPointField::FLOAT64)
      source.failAtLine("length of a list is " + inQuotes(type));
    words.next(type);
  }
  property.datatype = datatypeOf(type, source);
  std::string_view name;
  if (!words.next(name))
    source.failAtLine("property without a name");
  property.name = name;
  header.elements.back().properties.push_back(std::move(property));
}

void
requireOneVertexElement(const PlyHeader& header, const ByteSource& source)
{
  const auto is_vertex = [](const auto& element) { return element.name == "vertex"; };
  const auto count =
      std::count_if(header.elements.begin(), header.elements.end(), is_vertex);
  if (count != 1)
    source.fail("header has " + std::to_string(count) + " vertex elements");
}

} // namespace

std::uint64_t
PlyElement::leastBytes() const
{
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes +=
        sizeOfType(property.isList() ? property.length_datatype : property.datatype);
  return bytes;
}

bool
PlyElement::hasList() const
{
  return std::any_of(properties.begin(), properties.end(), [](const auto& property) {
    return property.isList();
  });
}

PlyHeader
readPlyHeader(ByteSource& source)
{
  std::string_view line;
  if (!source.readLine(line) || line != "ply")
    source.fail("is not a PLY file: it does not begin with 'ply'");
  PlyHeader header;
  bool has_format = false;
  while (source.readLine(line)) {
    Words words(line);
    std::string_view key;
    if (!words.next(key) || key == "comment" || key == "obj_info")
      continue;
    if (key == "format") {
      readFormat(words, header, source);
      has_format = true;
    }
    else if (key == "element")
      readElement(words, header, source);
    else if (key == "property")
      readProperty(words, header, source);
    else if (key == "end_header") {
      if (!has_format)
        source.fail("header has no format");
      requireOneVertexElement(header, source);
      return header;
    }
    else
      source.failAtLine(inQuotes(key) + " is no entry of a PLY header");
  }
  source.fail("ends before the end_header line of PLY");
}

} // namespace pcl::acmap
