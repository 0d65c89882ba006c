#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief A topic of a bag. \ingroup core */
struct BagChannel {
  std::string topic;
  std::string type;     ///< such as sensor_msgs/msg/Image; empty if there is no schema
  std::string encoding; ///< of its messages, such as cdr
  std::size_t messages = 0; ///< number of them
};

/** \brief Where a message of a bag is. \ingroup core */
struct BagMessage {
  std::size_t channel = 0; ///< index in \ref BagFile::channels
  double time = 0;         ///< seconds, when it was recorded

  /** \brief Index of its chunk, or -1 for a message that is in none. */
  std::int64_t chunk = -1;
  std::uint64_t offset = 0; ///< of its bytes in the unpacked chunk, or in the file
  std::uint64_t bytes = 0;
};

/** \brief A bag of recorded messages, in the format MCAP, as ROS 2 records them; ROS is not
 * needed.
 *
 * Chunks may be packed with lz4 or zstd. The whole file is read once when it is opened, and
 * compared with its checksums; messages are read again by \ref load. Copies share what was
 * read. Thread-safe. \ingroup core */
class ACMAP_EXPORT BagFile {
public:
  /** \brief Opens a bag.
   * \throws InputFileException naming file, place and fault: no MCAP file, truncated, a
   * record that is longer than its chunk or the file, a wrong checksum, a packing that is not
   * known, a channel or a schema that is not defined */
  explicit BagFile(const std::string& path);

  const std::string&
  path() const;

  const std::vector<BagChannel>&
  channels() const;

  /** \brief All messages in the order of the file. */
  const std::vector<BagMessage>&
  messages() const;

  /** \brief Reads the bytes of a message.
   * \throws InputFileException if the file was changed since */
  std::string
  load(const BagMessage& message) const;

private:
  struct Content;
  std::shared_ptr<Content> content_;
};

} // namespace pcl
