#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Identification of a camera. */
struct CameraIdentity {
  std::uint64_t guid = 0x00B09D0100C0FFEE; ///< serial number
  std::string vendor = "Point Grey Research";
  std::string model = "Emulated Digiclops";
  bool point_grey_unit = false; ///< spec id 0x00B09D instead of 0x00A02D
};

/** \brief The quadlets from address 0x400 of the CSR space: bus information, root, unit
 * and unit dependent directory, texts of vendor and model. */
std::vector<std::uint32_t>
configRomOf(const CameraIdentity& identity);

} // namespace pcl::acmap::test
