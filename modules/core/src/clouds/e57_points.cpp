#include "clouds/e57_points.h"

#include "clouds/field_layout.h"
#include "files/byte_source.h"

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
                     E57Pages& pages)
: fields_(fields)
, pages_(pages)
, count_(count)
, streams_(fields.size())
, values_(fields.size())
{
  constexpr std::uint64_t section_header = 32;
  constexpr std::uint8_t of_vector = 1;
  if (count == 0)
    return;
  require(section, section_header);
  const std::string header = pages.read(section, section_header);
  if (valueIn<std::uint8_t>(header, 0) != of_vector)
    pages.source().fail("has no points where a scan claims them");
  const auto length = valueIn<std::uint64_t>(header, 8);
  require(section, length);
  packet_ = pages.logical(valueIn<std::uint64_t>(header, 16));
  end_ = section + length;
}

void
E57Points::require(std::uint64_t offset, std::uint64_t length) const
{
  if (offset > pages_.size() || length > pages_.size() - offset)
    pages_.source().fail("ends within the points of a scan");
}

bool
E57Points::hasNext(std::size_t field) const
{
  return 8 * streams_[field].bytes.size() - streams_[field].position >=
         fields_[field].bits;
}

/** Reads the next packet, and drops what was used of those before. */
void
E57Points::readPacket()
{
  constexpr std::uint64_t packet_header = 6;
  constexpr std::uint8_t of_data = 1;
  require(packet_, packet_header);
  const std::string header = pages_.read(packet_, packet_header);
  const std::uint64_t length = valueIn<std::uint16_t>(header, 2) + std::uint64_t{1};
  require(packet_, length);
  if (valueIn<std::uint8_t>(header, 0) == of_data) {
    const std::string packet = pages_.read(packet_, length);
    const std::uint64_t streams = valueIn<std::uint16_t>(header, 4);
    std::uint64_t from = packet_header + 2 * streams;
    if (streams != fields_.size() || from > length)
      pages_.source().fail("has a packet of another number of fields");
    for (std::uint64_t i = 0; i < streams; ++i) {
      const std::uint64_t part = valueIn<std::uint16_t>(packet, packet_header + 2 * i);
      if (part > length - from)
        pages_.source().fail("has a packet that is longer than itself");
      Stream& stream = streams_[i];
      stream.bytes.erase(0, stream.position / 8);
      stream.position %= 8;
      stream.bytes.append(packet, from, part);
      from += part;
    }
  }
  packet_ += length;
}

std::uint64_t
E57Points::nextBits(std::size_t field)
{
  const unsigned bits = fields_[field].bits;
  const std::string& stream = streams_[field].bytes;
  std::uint64_t value = 0;
  for (unsigned done = 0; done < bits;) {
    const std::uint64_t at = streams_[field].position + done;
    const auto within = static_cast<unsigned>(at % 8);
    const unsigned part = std::min(8 - within, bits - done);
    const std::uint64_t byte = static_cast<unsigned char>(stream[at / 8]) >> within;
    value |= (byte & ((1U << part) - 1)) << done;
    done += part;
  }
  streams_[field].position += bits;
  return value;
}

const std::vector<double>&
E57Points::next()
{
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const E57Field& field = fields_[i];
    while (!hasNext(i)) {
      if (packet_ >= end_)
        pages_.source().fail("is truncated: a scan of " + std::to_string(count_) +
                             " points has " + std::to_string(done_) + " values of " +
                             field.name);
      readPacket();
    }
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
  ++done_;
  return values_;
}

} // namespace pcl::acmap
