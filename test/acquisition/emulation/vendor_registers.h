#pragma once

#include "register_map.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Point Grey's registers, protected by a lock as IIDC defines for advanced
 * features. */
class VendorRegisters {
public:
  /** \param[in] tiles four letters such as `GBRG`; `YYYY`: no colour filter */
  VendorRegisters(RegisterMap& registers, const std::string& tiles, bool locked);

  /** \brief Can the host write to the register? */
  bool
  lets(std::uint32_t offset) const;

  void
  written(std::uint32_t offset);

  /** \brief Overwrites the first bytes of an image as requested by FRAME_INFO: one
   * big-endian quadlet for each of its bits, the lowest first; unsupported ones are 0.
   * \param[in] cycle time of the bus \param[in] number of the frame */
  void
  embed(std::vector<std::uint8_t>& image,
        std::uint32_t cycle,
        std::uint32_t number) const;

private:
  RegisterMap& registers_;
  bool locked_;
};

} // namespace pcl::acmap::test
