#pragma once

#include "mcap_file.h"

#include <bzlib.h>

#include <map>

namespace pcl::acmap::test {

/** \brief A message of ROS, serialized as ROS 1 does: without alignment. */
class Ros1Bytes {
public:
  template <typename Number>
  Ros1Bytes&
  add(Number value)
  {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }

  Ros1Bytes&
  addText(const std::string& text)
  {
    return addBytes(text);
  }

  Ros1Bytes&
  addBytes(const std::string& data)
  {
    add(static_cast<std::uint32_t>(data.size()));
    bytes += data;
    return *this;
  }

  Ros1Bytes&
  addHeader(double stamp, const std::string& frame)
  {
    const auto seconds = static_cast<std::uint32_t>(stamp);
    add(std::uint32_t{7}).add(seconds);
    add(static_cast<std::uint32_t>(1e9 * (stamp - seconds) + 0.5));
    return addText(frame);
  }

  Ros1Bytes&
  addPose(const Eigen::Isometry3d& pose)
  {
    bytes += CdrBytes().addPose(pose).bytes.substr(CdrBytes().bytes.size());
    return *this;
  }

  std::string bytes;
};

/** \brief Writes bags of ROS 1 as the page of its format 2.0 has them. */
class Ros1Writer {
public:
  /** \param[in] packing none, bz2 or lz4 */
  explicit Ros1Writer(std::string packing = "none")
  : packing_(std::move(packing))
  {}

  void
  add(const std::string& topic,
      const std::string& type,
      double time,
      const std::string& message)
  {
    const auto [known, is_new] =
        topics_.emplace(topic, static_cast<std::uint32_t>(topics_.size()));
    const std::string connection = field("conn", McapWriter::raw(known->second));
    if (is_new) {
      const std::string described =
          record(field("op", "\7") + connection + field("topic", topic),
                 field("topic", topic) + field("type", type) + field("md5sum", "*") +
                     field("message_definition", "# " + type));
      chunk_ += described;
      index_ += described;
    }
    const auto seconds = static_cast<std::uint32_t>(time);
    const auto nanoseconds = static_cast<std::uint32_t>(1e9 * (time - seconds) + 0.5);
    chunk_ += record(
        field("op", "\2") + connection +
            field("time", McapWriter::raw(seconds) + McapWriter::raw(nanoseconds)),
        message);
  }

  void
  endChunk()
  {
    if (chunk_.empty())
      return;
    const auto size = static_cast<std::uint32_t>(chunk_.size());
    chunks_ += record(field("op", "\5") + field("compression", packing_) +
                          field("size", McapWriter::raw(size)),
                      packed(chunk_));
    chunks_ +=
        record(field("op", "\4") + field("ver", McapWriter::raw(std::uint32_t{1})),
               std::string());
    chunk_.clear();
  }

  /** \param[in] is_closed has it an index? */
  std::string
  finish(bool is_closed = true)
  {
    endChunk();
    const std::string magic = "#ROSBAG V2.0\n";
    const auto place = std::uint64_t{magic.size() + 4096 + 8 + chunks_.size()};
    std::string head = field("op", "\3") +
                       field("index_pos", McapWriter::raw(is_closed ? place : 0)) +
                       field("conn_count", McapWriter::raw(std::uint32_t{0})) +
                       field("chunk_count", McapWriter::raw(std::uint32_t{0}));
    return magic + record(head, std::string(4096 - head.size(), ' ')) + chunks_ +
           (is_closed ? index_ : std::string());
  }

  static std::string
  field(const std::string& name, const std::string& value)
  {
    return McapWriter::sized(name + "=" + value);
  }

  static std::string
  record(const std::string& head, const std::string& data)
  {
    return McapWriter::sized(head) + McapWriter::sized(data);
  }

private:
  std::string
  packed(const std::string& bytes) const
  {
    std::string to;
    if (packing_ == "lz4") {
      to.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
      to.resize(LZ4F_compressFrame(
          to.data(), to.size(), bytes.data(), bytes.size(), nullptr));
      return to;
    }
    if (packing_ == "bz2") {
      to.resize(bytes.size() + bytes.size() / 50 + 700);
      auto size = static_cast<unsigned>(to.size());
      BZ2_bzBuffToBuffCompress(to.data(),
                               &size,
                               const_cast<char*>(bytes.data()),
                               static_cast<unsigned>(bytes.size()),
                               9,
                               0,
                               0);
      to.resize(size);
      return to;
    }
    return bytes;
  }

  std::string packing_, chunk_, chunks_, index_;
  std::map<std::string, std::uint32_t> topics_;
};

} // namespace pcl::acmap::test
