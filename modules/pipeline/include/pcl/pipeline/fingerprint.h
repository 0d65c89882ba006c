#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace pcl::acmap {

/** \brief FNV-1a hash by which a later run detects that its input has changed. */
class Fingerprint {
public:
  void
  add(const void* data, std::size_t bytes)
  {
    const auto* const letters = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i)
      hash_ = (hash_ ^ letters[i]) * 0x100000001b3;
  }

  /** \brief Adds a text and its end, so that "a", "bc" is not "ab", "c". */
  void
  add(const std::string& text)
  {
    add(text.c_str(), text.size() + 1);
  }

  void
  add(const Eigen::Matrix4d& matrix)
  {
    add(matrix.data(), sizeof(double) * static_cast<std::size_t>(matrix.size()));
  }

  /** \brief 16 hexadecimal digits. */
  std::string
  text() const
  {
    char digits[17];
    std::snprintf(
        digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

} // namespace pcl::acmap
