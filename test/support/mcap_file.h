#pragma once

#include <Eigen/Geometry>

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

/** \brief A message of ROS, serialized as little-endian CDR. */
class CdrBytes {
public:
  template <typename Number>
  CdrBytes&
  add(Number value)
  {
    while ((bytes.size() - 4) % sizeof value > 0)
      bytes.push_back('\0');
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }

  CdrBytes&
  addText(const std::string& text)
  {
    add(static_cast<std::uint32_t>(text.size() + 1));
    bytes += text + '\0';
    return *this;
  }

  CdrBytes&
  addBytes(const std::string& data)
  {
    add(static_cast<std::uint32_t>(data.size()));
    bytes += data;
    return *this;
  }

  CdrBytes&
  addHeader(double stamp, const std::string& frame)
  {
    const auto seconds = static_cast<std::int32_t>(stamp);
    add(seconds);
    add(static_cast<std::uint32_t>(1e9 * (stamp - seconds) + 0.5));
    return addText(frame);
  }

  CdrBytes&
  addPose(const Eigen::Isometry3d& pose)
  {
    const Eigen::Quaterniond q(pose.linear());
    const Eigen::Vector3d t = pose.translation();
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      add(value);
    return *this;
  }

  std::string bytes = std::string("\0\1\0\0", 4);
};

template <typename Bytes = CdrBytes>
std::string
imageMessage(double stamp,
             const std::string& frame,
             std::uint32_t width,
             std::uint32_t height,
             const std::string& encoding,
             const std::string& data)
{
  Bytes cdr;
  cdr.addHeader(stamp, frame).add(height).add(width).addText(encoding);
  cdr.add(std::uint8_t{0}).add(static_cast<std::uint32_t>(data.size() / height));
  return cdr.addBytes(data).bytes;
}

template <typename Bytes = CdrBytes>
std::string
cameraMessage(double stamp,
              const std::string& frame,
              std::uint32_t width,
              std::uint32_t height,
              const Eigen::Matrix3d& matrix,
              double distortion = 0)
{
  Bytes cdr;
  cdr.addHeader(stamp, frame).add(height).add(width).addText("plumb_bob");
  cdr.add(std::uint32_t{5});
  for (int i = 0; i < 5; ++i)
    cdr.add(distortion);
  for (int i = 0; i < 9; ++i)
    cdr.add(matrix(i / 3, i % 3));
  for (int i = 0; i < 9 + 12; ++i)
    cdr.add(0.0);
  for (int i = 0; i < 6; ++i)
    cdr.add(std::uint32_t{0});
  cdr.add(std::uint8_t{0});
  return cdr.bytes;
}

template <typename Bytes = CdrBytes>
std::string
transformMessage(double stamp,
                 const std::string& parent,
                 const std::string& child,
                 const Eigen::Isometry3d& T_parent_child)
{
  Bytes cdr;
  cdr.add(std::uint32_t{1}).addHeader(stamp, parent).addText(child);
  return cdr.addPose(T_parent_child).bytes;
}

/** \brief A cloud of x y z (float32) and rgb (packed), each a row of 16 bytes. */
template <typename Bytes = CdrBytes>
std::string
cloudMessage(double stamp,
             const std::string& frame,
             std::uint32_t width,
             std::uint32_t height,
             const std::string& rows)
{
  Bytes cdr;
  cdr.addHeader(stamp, frame).add(height).add(width).add(std::uint32_t{4});
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "rgb"}) {
    cdr.addText(name).add(offset).add(std::uint8_t{7}).add(std::uint32_t{1});
    offset += 4;
  }
  cdr.add(std::uint8_t{0}).add(std::uint32_t{16}).add(16 * width);
  return cdr.addBytes(rows).add(std::uint8_t{0}).bytes;
}

template <typename Bytes = CdrBytes>
std::string
odometryMessage(double stamp,
                const std::string& parent,
                const std::string& child,
                const Eigen::Isometry3d& T_parent_child)
{
  Bytes cdr;
  cdr.addHeader(stamp, parent).addText(child).addPose(T_parent_child);
  return cdr.bytes;
}

/** \brief A scan of a laser that reaches from 0.1 to 30 m. */
template <typename Bytes = CdrBytes>
std::string
scanMessage(double stamp,
            const std::string& frame,
            float first_angle,
            float angle_step,
            const std::vector<float>& ranges)
{
  const float last = first_angle + angle_step * static_cast<float>(ranges.size() - 1);
  Bytes cdr;
  cdr.addHeader(stamp, frame);
  for (const float value : {first_angle, last, angle_step, 0.0F, 0.1F, 0.1F, 30.0F})
    cdr.add(value);
  cdr.add(static_cast<std::uint32_t>(ranges.size()));
  for (const float range : ranges)
    cdr.add(range);
  return cdr.add(std::uint32_t{0}).bytes; // no intensities
}

/** \brief Writes bags as the specification of MCAP has them, with a summary. */
class McapWriter {
public:
  /** \param[in] packing of chunks: none, lz4, zstd, or empty for messages outside of chunks
   */
  explicit McapWriter(std::string packing = "zstd")
  : packing_(std::move(packing))
  {
    bytes_ = magic();
    bytes_ += record(1, sized("ros2") + sized("test"));
  }

  /** \brief Adds a message; topics get their channels when they come first.
   * \param[in] type such as sensor_msgs/msg/Image */
  void
  add(const std::string& topic,
      const std::string& type,
      double time,
      const std::string& message)
  {
    std::uint16_t channel = 0;
    while (channel < topics_.size() && topics_[channel] != topic)
      ++channel;
    if (channel == topics_.size()) {
      topics_.push_back(topic);
      const auto schema = static_cast<std::uint16_t>(channel + 1);
      const std::string described =
          record(3, raw(schema) + sized(type) + sized("ros2msg") + sized("# " + type)) +
          record(4,
                 raw(channel) + raw(schema) + sized(topic) + sized("cdr") +
                     raw(std::uint32_t{0}));
      put(described);
      summary_ += described;
    }
    const auto nanoseconds = static_cast<std::uint64_t>(1e9 * time);
    put(record(
        5, raw(channel) + raw(count_) + raw(nanoseconds) + raw(nanoseconds) + message));
    ++count_;
  }

  /** \brief Adds a record as it is. */
  void
  put(const std::string& whole)
  {
    (packing_.empty() ? bytes_ : chunk_) += whole;
  }

  void
  endChunk()
  {
    if (chunk_.empty())
      return;
    bytes_ += record(6,
                     raw(std::uint64_t{0}) + raw(std::uint64_t{0}) +
                         raw(std::uint64_t{chunk_.size()}) + raw(checksum(chunk_)) +
                         sized(packing_ == "none" ? "" : packing_) +
                         longSized(packed(chunk_)));
    chunk_.clear();
  }

  std::string
  finish()
  {
    endChunk();
    bytes_ += record(15, raw(checksum(bytes_)));
    const std::uint64_t start = bytes_.size();
    bytes_ += summary_;
    std::string footer = std::string(1, '\2') + raw(std::uint64_t{20}) +
                         raw(summary_.empty() ? std::uint64_t{0} : start) +
                         raw(std::uint64_t{0});
    footer += raw(checksum(bytes_.substr(start) + footer));
    return bytes_ + footer + magic();
  }

  static std::string
  magic()
  {
    return {"\x89MCAP0\r\n", 8};
  }

  static std::string
  record(std::uint8_t opcode, const std::string& content)
  {
    return raw(opcode) + longSized(content);
  }

  template <typename Number>
  static std::string
  raw(Number value)
  {
    return {reinterpret_cast<const char*>(&value), sizeof value};
  }

  static std::string
  sized(const std::string& text)
  {
    return raw(static_cast<std::uint32_t>(text.size())) + text;
  }

  static std::string
  longSized(const std::string& text)
  {
    return raw(std::uint64_t{text.size()}) + text;
  }

  static std::uint32_t
  checksum(const std::string& bytes)
  {
    return static_cast<std::uint32_t>(
        ::crc32(0,
                reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uInt>(bytes.size())));
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
    if (packing_ == "zstd") {
      to.resize(ZSTD_compressBound(bytes.size()));
      to.resize(ZSTD_compress(to.data(), to.size(), bytes.data(), bytes.size(), 1));
      return to;
    }
    return bytes;
  }

  std::string packing_, bytes_, chunk_, summary_;
  std::vector<std::string> topics_;
  std::uint32_t count_ = 0;
};

} // namespace pcl::acmap::test
