#include "bag/bag_files.h"
#include "bag/bag_index.h"
#include "bag/byte_cursor.h"
#include "bag/chunk_unpacking.h"
#include "bag/sqlite_bag.h"
#include "files/byte_source.h"

#include <pcl/core/bag_file.h>

#include <zstd.h>

#include <algorithm>
#include <list>
#include <map>
#include <mutex>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

/** \brief A file of a bag: its chunks, or its database. */
struct BagPart {
  std::string path;
  std::vector<BagChunk> chunks;
  std::unique_ptr<SqliteBag> database;
};

bool
beginsWith(ByteSource& source, std::string_view begin)
{
  return source.ahead(begin.size()).substr(0, begin.size()) == begin;
}

BagIndex
openPart(BagPart& part)
{
  ByteSource source(part.path);
  if (beginsWith(source, "SQLite format 3")) {
    part.database = std::make_unique<SqliteBag>(part.path);
    return part.database->readIndex();
  }
  BagIndex index;
  if (beginsWith(source, "#ROSBAG V"))
    index = readRos1Index(source);
  else if (beginsWith(source, "\x89MCAP"))
    index = readMcapIndex(source);
  else
    source.fail("is no bag: neither MCAP, nor SQLite 3, nor a bag of ROS 1");
  part.chunks = std::move(index.chunks);
  return index;
}

/** \brief Unpacks a message that rosbag2 has packed alone; CDR never begins like that. */
std::string
unpackedMessage(std::string bytes, const std::string& path)
{
  constexpr std::string_view magic = "\x28\xb5\x2f\xfd";
  if (std::string_view(bytes).substr(0, magic.size()) != magic)
    return bytes;
  const auto fail = [&](const std::string& fault) {
    throw InputFileException(path + ": has a message that " + fault);
  };
  constexpr std::uint64_t max_bytes = std::uint64_t{1} << 32;
  const std::uint64_t size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size > max_bytes)
    fail("is packed with zstd in a damaged way");
  return unpackChunk("zstd", bytes, size, fail);
}

} // namespace

} // namespace acmap

struct BagFile::Content {
  std::string path;
  std::vector<std::string> remarks;
  std::vector<acmap::BagPart> parts;
  std::vector<BagChannel> channels;
  std::vector<BagMessage> messages;

  using ChunkName = std::pair<std::uint32_t, std::int64_t>; ///< part, number
  std::mutex mutex;
  /** \brief The chunks that were used last, the last one first. */
  std::list<std::pair<ChunkName, std::shared_ptr<const std::string>>> unpacked;

  void
  append(acmap::BagIndex index)
  {
    const auto part = static_cast<std::uint32_t>(parts.size() - 1);
    std::vector<std::size_t> numbers;
    for (BagChannel& channel : index.channels)
      numbers.push_back(numberOf(std::move(channel)));
    for (BagMessage& message : index.messages) {
      message.channel = numbers[message.channel];
      message.part = part;
      messages.push_back(message);
    }
  }

  /** \brief Index of a channel among those of all parts: several publishers of a topic have
   * a channel each. */
  std::size_t
  numberOf(BagChannel channel)
  {
    const auto same = [&](const BagChannel& known) {
      return known.topic == channel.topic && known.type == channel.type &&
             known.encoding == channel.encoding;
    };
    const auto found = std::find_if(channels.begin(), channels.end(), same);
    if (found == channels.end()) {
      channels.push_back(std::move(channel));
      return channels.size() - 1;
    }
    found->messages += channel.messages;
    return static_cast<std::size_t>(found - channels.begin());
  }

  std::shared_ptr<const std::string>
  chunk(const ChunkName& name)
  {
    constexpr std::size_t max_kept =
        3; // colours and depths may be in neighbouring ones
    const std::lock_guard lock(mutex);
    const auto found =
        std::find_if(unpacked.begin(), unpacked.end(), [&](const auto& kept) {
          return kept.first == name;
        });
    if (found != unpacked.end()) {
      unpacked.splice(unpacked.begin(), unpacked, found);
      return unpacked.front().second;
    }
    const acmap::BagPart& part = parts[name.first];
    acmap::ByteSource source(part.path);
    auto bytes = std::make_shared<const std::string>(acmap::readBagChunk(
        part.chunks.at(static_cast<std::size_t>(name.second)), source));
    unpacked.emplace_front(name, bytes);
    if (unpacked.size() > max_kept)
      unpacked.pop_back();
    return bytes;
  }

  std::string
  load(const BagMessage& message)
  {
    const acmap::BagPart& part = parts.at(message.part);
    if (part.database)
      return part.database->load(message);
    if (message.chunk >= 0) {
      const auto bytes = chunk({message.part, message.chunk});
      acmap::ByteCursor cursor(*bytes, part.path);
      cursor.take(message.offset);
      return std::string(cursor.take(message.bytes));
    }
    acmap::ByteSource source(part.path);
    source.moveTo(message.offset);
    if (message.bytes > source.remaining())
      source.fail("became shorter while it was read");
    std::string bytes(message.bytes, '\0');
    source.read(bytes.data(), bytes.size());
    return bytes;
  }
};

BagFile::BagFile(const std::string& path)
: content_(std::make_shared<Content>())
{
  acmap::BagFiles files = acmap::findBagFiles(path);
  content_->path = path;
  content_->remarks = std::move(files.remarks);
  for (std::string& file : files.paths) {
    content_->parts.push_back({std::move(file), {}, nullptr});
    content_->append(acmap::openPart(content_->parts.back()));
  }
}

const std::string&
BagFile::path() const
{
  return content_->path;
}

std::vector<std::string>
BagFile::files() const
{
  std::vector<std::string> files;
  for (const acmap::BagPart& part : content_->parts)
    files.push_back(part.path);
  return files;
}

const std::vector<std::string>&
BagFile::remarks() const
{
  return content_->remarks;
}

const std::vector<BagChannel>&
BagFile::channels() const
{
  return content_->channels;
}

const std::vector<BagMessage>&
BagFile::messages() const
{
  return content_->messages;
}

std::string
BagFile::load(const BagMessage& message) const
{
  return acmap::unpackedMessage(content_->load(message), path());
}

} // namespace pcl
