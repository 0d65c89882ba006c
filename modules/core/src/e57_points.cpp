#include "e57_points.h"

#include "byte_source.h"
#include "field_layout.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cstring>
#include <limits>

namespace pcl::acmap {

namespace {

template <typename Value>
Value
valueIn(const std::string& bytes, std::uint64_t offset)
{
  Value value;
  std::memcpy(&value, &bytes[offset], sizeof value);
  return value;
}

/** \brief Bits that tell a number of 0 to this one. */
unsigned
bitsFor(std::uint64_t range)
{
  unsigned bits = 0;
  for (; range > 0; range >>= 1)
    ++bits;
  return bits;
}

E57Field
integerField(const pugi::xml_node& node, const ByteSource& source)
{
  E57Field field;
  field.minimum =
      node.attribute("minimum").as_llong(std::numeric_limits<std::int64_t>::min());
  const std::int64_t maximum =
      node.attribute("maximum").as_llong(std::numeric_limits<std::int64_t>::max());
  if (maximum < field.minimum)
    source.fail("has a field whose maximum is below its minimum");
  field.bits = bitsFor(static_cast<std::uint64_t>(maximum) -
                       static_cast<std::uint64_t>(field.minimum));
  if (std::string(node.attribute("type").value()) == "ScaledInteger") {
    field.scale = node.attribute("scale").as_double(1);
    field.offset = node.attribute("offset").as_double(0);
  }
  field.least = field.scale * static_cast<double>(field.minimum) + field.offset;
  field.most = field.scale * static_cast<double>(maximum) + field.offset;
  return field;
}

E57Field
floatField(const pugi::xml_node& node)
{
  E57Field field;
  const bool is_single = std::string(node.attribute("precision").value()) == "single";
  field.kind = is_single ? E57Field::Kind::Single : E57Field::Kind::Double;
  field.bits = is_single ? 32 : 64;
  field.least = node.attribute("minimum").as_double(0);
  field.most = node.attribute("maximum").as_double(1);
  return field;
}

} // namespace

std::vector<E57Field>
e57FieldsIn(const pugi::xml_node& prototype, const ByteSource& source)
{
  std::vector<E57Field> fields;
  for (const pugi::xml_node& node : prototype.children()) {
    if (node.type() != pugi::node_element)
      continue;
    const std::string type = node.attribute("type").value();
    if (type == "Integer" || type == "ScaledInteger")
      fields.push_back(integerField(node, source));
    else if (type == "Float")
      fields.push_back(floatField(node));
    else
      source.fail("has a field " + std::string(node.name()) + " of type '" + type +
                  "', numbers are read");
    fields.back().name = node.name();
  }
  if (fields.size() > max_fields)
    source.fail("has more than " + std::to_string(max_fields) + " fields");
  return fields;
}

E57Points::E57Points(const std::vector<E57Field>& fields,
                     std::uint64_t section,
                     std::uint64_t count,
                     const E57Pages& pages,
                     const ByteSource& source)
: fields_(fields)
, streams_(fields.size())
, position_(fields.size())
, values_(fields.size())
{
  if (count > 0)
    collect(section, count, pages, source);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].bits > 0 && 8 * streams_[i].size() / fields[i].bits < count)
      source.fail("is truncated: a scan of " + std::to_string(count) + " points has " +
                  std::to_string(8 * streams_[i].size() / fields[i].bits) +
                  " values of " + fields[i].name);
}

/** Collects the bytes of each field from the packets of a section. */
void
E57Points::collect(std::uint64_t section,
                   std::uint64_t count,
                   const E57Pages& pages,
                   const ByteSource& source)
{
  constexpr std::uint64_t section_header = 32, packet_header = 6;
  constexpr std::uint8_t of_vector = 1, of_data = 1;
  const std::string& bytes = pages.bytes();
  const auto require = [&](std::uint64_t offset, std::uint64_t length) {
    if (offset > bytes.size() || length > bytes.size() - offset)
      source.fail("ends within the points of a scan");
  };
  require(section, section_header);
  if (valueIn<std::uint8_t>(bytes, section) != of_vector)
    source.fail("has no points where a scan claims them");
  const auto length = valueIn<std::uint64_t>(bytes, section + 8);
  require(section, length);
  std::uint64_t at =
      E57Pages::logical(valueIn<std::uint64_t>(bytes, section + 16), source);
  const auto is_complete = [&] {
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (fields_[i].bits > 0 && 8 * streams_[i].size() / fields_[i].bits < count)
        return false;
    return true;
  };
  while (at < section + length && !is_complete()) {
    require(at, packet_header);
    const auto type = valueIn<std::uint8_t>(bytes, at);
    const std::uint64_t packet =
        valueIn<std::uint16_t>(bytes, at + 2) + std::uint64_t{1};
    require(at, packet);
    if (type == of_data) {
      const std::uint64_t streams = valueIn<std::uint16_t>(bytes, at + 4);
      std::uint64_t from = at + packet_header + 2 * streams;
      if (streams != fields_.size() || from > at + packet)
        source.fail("has a packet of another number of fields");
      for (std::uint64_t i = 0; i < streams; ++i) {
        const std::uint64_t part =
            valueIn<std::uint16_t>(bytes, at + packet_header + 2 * i);
        if (part > at + packet - from)
          source.fail("has a packet that is longer than itself");
        streams_[i].append(bytes, from, part);
        from += part;
      }
    }
    at += packet;
  }
}

std::uint64_t
E57Points::nextBits(std::size_t field)
{
  const unsigned bits = fields_[field].bits;
  const std::string& stream = streams_[field];
  std::uint64_t value = 0;
  for (unsigned done = 0; done < bits;) {
    const std::uint64_t at = position_[field] + done;
    const auto within = static_cast<unsigned>(at % 8);
    const unsigned part = std::min(8 - within, bits - done);
    const std::uint64_t byte = static_cast<unsigned char>(stream[at / 8]) >> within;
    value |= (byte & ((1U << part) - 1)) << done;
    done += part;
  }
  position_[field] += bits;
  return value;
}

const std::vector<double>&
E57Points::next()
{
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const E57Field& field = fields_[i];
    const std::uint64_t bits = nextBits(i);
    if (field.kind == E57Field::Kind::Integer) {
      const auto raw =
          static_cast<std::int64_t>(static_cast<std::uint64_t>(field.minimum) + bits);
      values_[i] = field.scale * static_cast<double>(raw) + field.offset;
    }
    else if (field.kind == E57Field::Kind::Double)
      std::memcpy(&values_[i], &bits, sizeof bits);
    else {
      const auto low = static_cast<std::uint32_t>(bits);
      float value = 0;
      std::memcpy(&value, &low, sizeof value);
      values_[i] = value;
    }
  }
  return values_;
}

} // namespace pcl::acmap
