#pragma once

#include "clouds/field_layout.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Header of a PCD file, checked for consistency but not yet against the size of
 * the file. */
struct PcdHeader {
  enum class Encoding { ascii, binary, binary_compressed };

  std::vector<SourceField> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t points = 0; // width * height
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Encoding encoding = Encoding::ascii;
  std::vector<std::string> remarks;
};

/** \brief Reads the lines up to and including DATA.
 *
 * Accepts what PCL accepts: missing COUNT, VIEWPOINT, HEIGHT, or WIDTH and HEIGHT,
 * missing SIZE and TYPE (float32), COLUMNS instead of FIELDS, comments anywhere. */
PcdHeader
readPcdHeader(ByteSource& source);

} // namespace pcl::acmap
