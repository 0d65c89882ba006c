#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace pcl::acmap::test {

/** A LAS file as its specification has it, with points at a place. */
class LasFile {
public:
  static constexpr double scale = 0.001; // metres

  LasFile(int minor,
          int format,
          const Eigen::Vector3d& place = Eigen::Vector3d::Zero(),
          std::uint32_t points = 5)
  : points(points)
  , place_(place)
  {
    constexpr std::array<std::size_t, 11> sizes = {
        20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    record_ = sizes[static_cast<std::size_t>(format)] + 2; // with bytes of the user
    const std::size_t header = minor == 5   ? 393
                               : minor == 4 ? 375
                               : minor == 3 ? 235
                                            : 227;
    bytes.assign(header + 10, '\0'); // and a gap
    std::memcpy(bytes.data(), "LASF", 4);
    set<std::uint8_t>(24, 1);
    set<std::uint8_t>(25, static_cast<std::uint8_t>(minor));
    set<std::uint16_t>(94, static_cast<std::uint16_t>(header));
    set<std::uint32_t>(96, static_cast<std::uint32_t>(bytes.size()));
    set<std::uint8_t>(104, static_cast<std::uint8_t>(format));
    set<std::uint16_t>(105, static_cast<std::uint16_t>(record_));
    set<std::uint32_t>(107, minor >= 4 ? 0 : points);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      set(131 + 8 * axis, scale);
      set(155 + 8 * axis, place_[static_cast<Eigen::Index>(axis)]);
    }
    if (minor >= 4)
      set<std::uint64_t>(247, points);
    first_ = bytes.size();
    bytes.resize(first_ + points * record_);
    for (std::size_t i = 0; i < points; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        set(at(i) + 4 * axis, static_cast<std::int32_t>(1000 * i + axis));
  }

  template <typename Value>
  void
  set(std::size_t offset, Value value)
  {
    std::memcpy(&bytes[offset], &value, sizeof value);
  }

  /** Offset of a point. */
  std::size_t
  at(std::size_t point) const
  {
    return first_ + point * record_;
  }

  /** Where a point is. */
  Eigen::Vector3d
  position(std::size_t point) const
  {
    return place_ +
           scale * (Eigen::Vector3d::Constant(1000.0 * static_cast<double>(point)) +
                    Eigen::Vector3d(0, 1, 2));
  }

  std::size_t points;
  std::string bytes;

private:
  Eigen::Vector3d place_;
  std::size_t record_ = 0, first_ = 0;
};

} // namespace pcl::acmap::test
