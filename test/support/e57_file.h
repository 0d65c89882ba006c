#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** Bits of a stream of an E57 file, the lowest first. */
class BitStream {
public:
  void
  add(std::uint64_t value, unsigned bits)
  {
    for (unsigned i = 0; i < bits; ++i, ++count_) {
      if (count_ % 8 == 0)
        bytes.push_back('\0');
      bytes.back() = static_cast<char>(bytes.back() | (value >> i & 1) << (count_ % 8));
    }
  }

  std::string bytes;

private:
  std::size_t count_ = 0;
};

/** A scan as it is written. */
struct WrittenScan {
  std::string prototype, more;
  std::vector<std::string> streams;
  std::size_t count = 0;
};

/** The bytes of a number as in memory. */
template <typename Value>
std::string
e57Bytes(Value value)
{
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

inline std::uint32_t
slowChecksum(const std::string& bytes)
{
  std::uint32_t value = ~0U;
  for (const char c : bytes) {
    value ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      value = value & 1 ? value >> 1 ^ 0x82F63B78U : value >> 1;
  }
  return ~value;
}

inline std::uint64_t
physical(std::uint64_t logical)
{
  return logical / 1020 * 1024 + logical % 1020;
}

/** An E57 file as ASTM E2807 has it; each packet has a part of the streams. */
inline std::string
e57Of(const std::vector<WrittenScan>& scans, std::size_t packets = 1)
{
  std::string logical(48, '\0'), xml = "<?xml version=\"1.0\"?><e57Root><data3D>";
  for (const WrittenScan& scan : scans) {
    while (logical.size() % 1020 > 900) // an offset must not be within a checksum
      logical.push_back('\0');
    const std::uint64_t section = logical.size();
    std::string body;
    for (std::size_t packet = 0; packet < packets; ++packet) {
      std::string lengths, data;
      for (const std::string& stream : scan.streams) {
        const std::size_t from = stream.size() * packet / packets,
                          to = stream.size() * (packet + 1) / packets;
        lengths += e57Bytes(static_cast<std::uint16_t>(to - from));
        data += stream.substr(from, to - from);
      }
      const std::size_t length = 6 + lengths.size() + data.size();
      body +=
          std::string("\1\0", 2) + e57Bytes(static_cast<std::uint16_t>(length - 1)) +
          e57Bytes(static_cast<std::uint16_t>(scan.streams.size())) + lengths + data;
    }
    logical += std::string("\1\0\0\0\0\0\0\0", 8) +
               e57Bytes(std::uint64_t{32 + body.size()}) +
               e57Bytes(physical(section + 32)) + e57Bytes(std::uint64_t{0}) + body;
    xml += "<vectorChild><points fileOffset=\"" + std::to_string(physical(section)) +
           "\" recordCount=\"" + std::to_string(scan.count) + "\"><prototype>" +
           scan.prototype + "</prototype></points>" + scan.more + "</vectorChild>";
  }
  xml += "</data3D></e57Root>";
  const std::uint64_t at = logical.size();
  logical += xml;
  logical.resize((logical.size() + 1019) / 1020 * 1020);
  const std::string header =
      "ASTM-E57" + e57Bytes(1U) + e57Bytes(0U) +
      e57Bytes(std::uint64_t{logical.size() / 1020 * 1024}) + e57Bytes(physical(at)) +
      e57Bytes(std::uint64_t{xml.size()}) + e57Bytes(std::uint64_t{1024});
  logical.replace(0, 48, header);
  std::string file;
  for (std::size_t page = 0; page < logical.size(); page += 1020) {
    const std::string content = logical.substr(page, 1020);
    const std::uint32_t checksum = slowChecksum(content);
    file += content;
    for (int shift = 24; shift >= 0; shift -= 8)
      file.push_back(static_cast<char>(checksum >> shift & 255));
  }
  return file;
}

/** Points of two doubles and a constant. */
inline WrittenScan
scanOf(const std::vector<Eigen::Vector3d>& points, const std::string& more = {})
{
  WrittenScan scan;
  scan.count = points.size();
  scan.more = more;
  scan.streams.resize(3);
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    scan.prototype += std::string("<") + name + R"( type="Float"/>)";
  for (const Eigen::Vector3d& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      scan.streams[axis] += e57Bytes(point[static_cast<Eigen::Index>(axis)]);
  return scan;
}

} // namespace pcl::acmap::test
