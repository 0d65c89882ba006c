#include "bag/bag_chunk.h"
#include "bag/bag_index.h"
#include "bag/byte_cursor.h"
#include "files/byte_source.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::string_view mcap_magic("\x89MCAP0\r\n", 8);

enum class McapOpcode : std::uint8_t {
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  Chunk = 6,
  DataEnd = 15
};

/** \brief Collects what a bag has from its records. */
class McapReading {
public:
  explicit McapReading(ByteSource& source)
  : source_(source)
  {}

  BagIndex
  read()
  {
    if (!isAtMagic())
      source_.fail("is no MCAP file: it does not begin as one");
    readBytes(mcap_magic.size());
    while (readRecord()) {
    }
    if (!isAtMagic())
      source_.fail("does not end as an MCAP file");
    return std::move(index_);
  }

private:
  bool
  isAtMagic()
  {
    return source_.ahead(mcap_magic.size()).substr(0, mcap_magic.size()) == mcap_magic;
  }

  std::string
  nameAt(std::uint64_t place) const
  {
    return source_.name() + ": its record at byte " + std::to_string(place);
  }

  std::string
  readBytes(std::uint64_t count)
  {
    std::string bytes(count, '\0');
    source_.read(bytes.data(), bytes.size());
    sum_ = bagChecksum(bytes, sum_);
    return bytes;
  }

  /** \return false after the last record */
  bool
  readRecord()
  {
    constexpr std::uint64_t head_bytes = 9;
    const std::uint64_t begin = source_.size() - source_.remaining();
    const std::uint32_t sum_before = sum_;
    const auto require = [&](std::uint64_t bytes) {
      if (bytes > source_.remaining())
        source_.fail("is truncated within its record at byte " + std::to_string(begin) +
                     ", as a recording that was not closed; mcap recover repairs it");
    };
    require(head_bytes);
    const std::string bytes = readBytes(head_bytes);
    ByteCursor head(bytes, nameAt(begin));
    const auto opcode = static_cast<McapOpcode>(head.number<std::uint8_t>());
    const auto length = head.number<std::uint64_t>();
    require(length);
    switch (opcode) {
    case McapOpcode::Chunk:
      readChunk(begin, readBytes(length));
      return true;
    case McapOpcode::Schema:
    case McapOpcode::Channel:
    case McapOpcode::Message:
      take(opcode, readBytes(length), nameAt(begin), -1, begin + head_bytes);
      return true;
    case McapOpcode::DataEnd: {
      const std::string content = readBytes(length);
      const auto sum = ByteCursor(content, nameAt(begin)).number<std::uint32_t>();
      if (sum != 0 && sum != sum_before)
        source_.fail("is damaged: the checksum of its data is wrong");
      return true;
    }
    default: // indices, attachments, and what later versions may add
      constexpr std::uint64_t step = 65536;
      for (std::uint64_t left = length; left > 0; left -= std::min(left, step))
        readBytes(std::min(left, step));
      return opcode != McapOpcode::Footer;
    }
  }

  void
  readChunk(std::uint64_t begin, const std::string& content)
  {
    constexpr std::uint64_t head_bytes = 9;
    ByteCursor cursor(content, nameAt(begin));
    cursor.take(16); // times of its first and last message
    BagChunk chunk;
    chunk.bytes = cursor.number<std::uint64_t>();
    chunk.checksum = cursor.number<std::uint32_t>();
    chunk.packing = cursor.sized();
    chunk.packed_bytes = cursor.number<std::uint64_t>();
    chunk.offset = begin + head_bytes + cursor.place();
    const std::string bytes =
        unpackBagChunk(chunk, cursor.take(chunk.packed_bytes), source_);
    const auto number = static_cast<std::int64_t>(index_.chunks.size());
    index_.chunks.push_back(std::move(chunk));
    readRecordsOf(bytes, nameAt(begin), number);
  }

  void
  readRecordsOf(std::string_view bytes, const std::string& name, std::int64_t chunk)
  {
    ByteCursor records(bytes, name);
    while (records.remaining() > 0) {
      const auto opcode = static_cast<McapOpcode>(records.number<std::uint8_t>());
      const auto length = records.number<std::uint64_t>();
      const std::size_t place = records.place();
      take(opcode, records.take(length), name, chunk, place);
    }
  }

  /** \param[in] chunk -1: none
   * \param[in] place of the content in the chunk, or in the file */
  void
  take(McapOpcode opcode,
       std::string_view content,
       const std::string& name,
       std::int64_t chunk,
       std::uint64_t place)
  {
    ByteCursor cursor(content, name);
    switch (opcode) {
    case McapOpcode::Schema: {
      const auto id = cursor.number<std::uint16_t>();
      schemas_.emplace(id, cursor.sized());
      return;
    }
    case McapOpcode::Channel:
      return takeChannel(cursor);
    case McapOpcode::Message: {
      const auto id = cursor.number<std::uint16_t>();
      const auto channel = channels_.find(id);
      if (channel == channels_.end())
        cursor.fail("has a message of channel " + std::to_string(id) +
                    ", which is not defined before");
      cursor.take(4); // its number
      BagMessage message;
      message.channel = channel->second;
      message.time = 1e-9 * static_cast<double>(cursor.number<std::uint64_t>());
      cursor.take(8); // the time of its publication
      message.chunk = chunk;
      message.offset = place + cursor.place();
      message.bytes = cursor.remaining();
      index_.messages.push_back(message);
      ++index_.channels[message.channel].messages;
      return;
    }
    default: // nothing else may be in a chunk
      return;
    }
  }

  void
  takeChannel(ByteCursor& cursor)
  {
    const auto id = cursor.number<std::uint16_t>();
    if (channels_.count(id) > 0)
      return; // the same again
    const auto schema = cursor.number<std::uint16_t>();
    BagChannel channel;
    channel.topic = cursor.sized();
    channel.encoding = cursor.sized();
    if (schema != 0) {
      const auto known = schemas_.find(schema);
      if (known == schemas_.end())
        cursor.fail("has a channel " + channel.topic.substr(0, 100) + " of schema " +
                    std::to_string(schema) + ", which is not defined before");
      channel.type = known->second;
    }
    channels_[id] = index_.channels.size();
    index_.channels.push_back(std::move(channel));
  }

  ByteSource& source_;
  std::uint32_t sum_ = 0; ///< checksum of all bytes so far
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, std::size_t> channels_;
  BagIndex index_;
};

} // namespace

BagIndex
readMcapIndex(ByteSource& source)
{
  return McapReading(source).read();
}

} // namespace pcl::acmap
