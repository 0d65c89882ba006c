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
  /** \brief Such as sensor_msgs/msg/Image, of ROS 1 sensor_msgs/Image; empty if there is
   * no schema. */
  std::string type;
  std::string encoding;     ///< of its messages: cdr (ROS 2), ros1, or another one
  std::size_t messages = 0; ///< number of them
};

/** \brief Where a message of a bag is. \ingroup core */
struct BagMessage {
  std::size_t channel = 0; ///< index in \ref BagFile::channels
  double time = 0;         ///< seconds, when it was recorded

  /** \brief Index of its chunk, or -1 for a message that is in none. */
  std::int64_t chunk = -1;
  std::uint32_t part = 0; ///< index in \ref BagFile::files
  /** \brief Of its bytes in the unpacked chunk, or in the file; of SQLite its row. */
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/** \brief A bag of recorded messages, as ROS 1 and ROS 2 record them: MCAP, SQLite 3
 * (.db3), bags of ROS 1 (.bag, version 2.0), or a folder of several of these files in their
 * order. ROS is not needed.
 *
 * Chunks may be packed with lz4, zstd or bz2, messages of SQLite with zstd. Each file is read
 * once when it is opened, and compared with its checksums; messages are read again by
 * \ref load. Copies share what was read. Thread-safe. \ingroup core */
class ACMAP_EXPORT BagFile {
public:
  /** \brief Opens a bag.
   * \param[in] path of a file, or of the folder of a recording: its files are those that
   * metadata.yaml names, otherwise those that are numbered from 0
   * \throws InputFileException naming file, place and fault: no bag, truncated, a record
   * that is longer than its chunk or the file, a wrong checksum, a packing that is not
   * known, a channel or a schema that is not defined, a recording of ROS 1 without an index,
   * a file that is packed as a whole, with the command that repairs or unpacks it */
  explicit BagFile(const std::string& path);

  /** \brief Does a path look like a bag? A file, which may be missing, does by its ending, a folder by such files
   * or the metadata.yaml of rosbag2. */
  static bool
  isBag(const std::string& path);

  const std::string&
  path() const;

  /** \brief Its files in the order in which they were recorded. */
  std::vector<std::string>
  files() const;

  /** \brief Warnings, one per line: a file that is a part of a recording. */
  const std::vector<std::string>&
  remarks() const;

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
