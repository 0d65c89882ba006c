#include "bag/bag_index.h"
#include "bag/byte_cursor.h"
#include "files/byte_source.h"

#include <cstring>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::string_view ros1_magic("#ROSBAG V2.0\n");

enum class Ros1Opcode : std::uint8_t {
  Message = 2,
  BagHeader = 3,
  Chunk = 5,
  Connection = 7
};

/** \brief The header of a record: fields `name=value`. */
class Ros1Fields {
public:
  Ros1Fields(std::string_view bytes, const std::string& name)
  : name_(name)
  {
    ByteCursor cursor(bytes, name);
    while (cursor.remaining() > 0) {
      const std::string_view field = cursor.sized();
      const std::size_t equals = field.find('=');
      if (equals == field.npos)
        cursor.fail("has a field without '='");
      fields_[field.substr(0, equals)] = field.substr(equals + 1);
    }
  }

  /** \brief The value of a field; empty if there is none. */
  std::string_view
  text(std::string_view field) const
  {
    const auto found = fields_.find(field);
    return found == fields_.end() ? std::string_view() : found->second;
  }

  template <typename Number>
  Number
  number(std::string_view field) const
  {
    const std::string_view value = text(field);
    if (value.size() != sizeof(Number))
      throw InputFileException(name_ + ": has no field " + std::string(field));
    Number number;
    std::memcpy(&number, value.data(), sizeof number);
    return number;
  }

  Ros1Opcode
  opcode() const
  {
    return static_cast<Ros1Opcode>(number<std::uint8_t>("op"));
  }

private:
  const std::string& name_;
  std::map<std::string_view, std::string_view> fields_;
};

/** \brief Collects what a bag has from its records. */
class Ros1Reading {
public:
  explicit Ros1Reading(ByteSource& source)
  : source_(source)
  {}

  BagIndex
  read()
  {
    requireVersion();
    source_.skip(ros1_magic.size());
    while (source_.remaining() > 0)
      readRecord();
    return std::move(index_);
  }

private:
  void
  requireVersion()
  {
    const std::string_view begin = source_.ahead(ros1_magic.size());
    if (begin.substr(0, ros1_magic.size()) == ros1_magic)
      return;
    constexpr std::string_view any_version = "#ROSBAG V";
    if (begin.substr(0, any_version.size()) == any_version)
      source_.fail("is a bag of an earlier version than 2.0: run rosbag filter " +
                   source_.name() + " NEW.bag True");
    source_.fail("is no bag of ROS 1: it does not begin as one");
  }

  std::string
  nameAt(std::uint64_t place) const
  {
    return source_.name() + ": its record at byte " + std::to_string(place);
  }

  [[noreturn]] void
  failUnclosed(const std::string& where) const
  {
    source_.fail(where + ", as a recording that was not closed: run rosbag reindex " +
                 source_.name());
  }

  std::string
  readSized(std::uint64_t begin)
  {
    std::uint32_t bytes = 0;
    const auto require = [&](std::uint64_t count) {
      if (count > source_.remaining())
        failUnclosed("is truncated within its record at byte " + std::to_string(begin));
    };
    require(sizeof bytes);
    source_.read(&bytes, sizeof bytes);
    require(bytes);
    std::string content(bytes, '\0');
    source_.read(content.data(), content.size());
    return content;
  }

  void
  readRecord()
  {
    const std::uint64_t begin = source_.size() - source_.remaining();
    const std::string name = nameAt(begin), head = readSized(begin);
    const std::uint64_t data_begin =
        source_.size() - source_.remaining() + sizeof(std::uint32_t);
    const std::string data = readSized(begin);
    const Ros1Fields fields(head, name);
    switch (fields.opcode()) {
    case Ros1Opcode::BagHeader:
      if (!fields.text("encryptor").empty())
        source_.fail("is encrypted: run rosbag decrypt " + source_.name());
      if (fields.number<std::uint64_t>("index_pos") == 0)
        failUnclosed("has no index");
      return;
    case Ros1Opcode::Chunk:
      return readChunk(fields, data, data_begin, name);
    default:
      return take(fields, data, name, -1, data_begin);
    }
  }

  void
  readChunk(const Ros1Fields& fields,
            const std::string& data,
            std::uint64_t data_begin,
            const std::string& name)
  {
    BagChunk chunk;
    chunk.offset = data_begin;
    chunk.packed_bytes = data.size();
    chunk.bytes = fields.number<std::uint32_t>("size");
    if (const std::string_view packing = fields.text("compression"); packing != "none")
      chunk.packing = packing;
    const std::string bytes = unpackBagChunk(chunk, data, source_);
    const auto number = static_cast<std::int64_t>(index_.chunks.size());
    index_.chunks.push_back(std::move(chunk));
    ByteCursor records(bytes, name);
    while (records.remaining() > 0) {
      const Ros1Fields record(records.sized(), name);
      const std::size_t place = records.place() + sizeof(std::uint32_t);
      take(record, records.sized(), name, number, place);
    }
  }

  /** \param[in] chunk -1: none
   * \param[in] place of the data in the chunk, or in the file */
  void
  take(const Ros1Fields& fields,
       std::string_view data,
       const std::string& name,
       std::int64_t chunk,
       std::uint64_t place)
  {
    if (fields.opcode() == Ros1Opcode::Connection)
      return takeConnection(fields, data, name);
    if (fields.opcode() != Ros1Opcode::Message)
      return; // indices
    const auto id = fields.number<std::uint32_t>("conn");
    const auto channel = channels_.find(id);
    if (channel == channels_.end())
      throw InputFileException(name + ": has a message of connection " +
                               std::to_string(id) + ", which is not defined before");
    ByteCursor time(fields.text("time"), name);
    BagMessage message;
    message.channel = channel->second;
    message.time = time.number<std::uint32_t>();
    message.time += 1e-9 * time.number<std::uint32_t>();
    message.chunk = chunk;
    message.offset = place;
    message.bytes = data.size();
    index_.messages.push_back(message);
    ++index_.channels[message.channel].messages;
  }

  void
  takeConnection(const Ros1Fields& fields,
                 std::string_view data,
                 const std::string& name)
  {
    const auto id = fields.number<std::uint32_t>("conn");
    if (channels_.count(id) > 0)
      return; // the same again, in the index
    const Ros1Fields described(data, name);
    channels_[id] = index_.channels.size();
    index_.channels.push_back({std::string(fields.text("topic")),
                               std::string(described.text("type")),
                               "ros1"});
  }

  ByteSource& source_;
  std::map<std::uint32_t, std::size_t> channels_;
  BagIndex index_;
};

} // namespace

BagIndex
readRos1Index(ByteSource& source)
{
  return Ros1Reading(source).read();
}

} // namespace pcl::acmap
