#pragma once

#include "register_map.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Point Grey's registers: behind a lock, as IIDC has it for advanced features. */
class VendorRegisters {
public:
  /** \param[in] tiles four letters as `GBRG`; `YYYY`: no colour filter */
  VendorRegisters(RegisterMap& registers, const std::string& tiles, bool locked);

  /** \brief Whether a write reaches the register. */
  bool
  lets(std::uint32_t offset) const;

  void
  written(std::uint32_t offset);

  /** \brief Overwrites the first bytes of an image as FRAME_INFO says: a big-endian
   * quadlet for each of its bits, the lowest first; what is not known here is 0.
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
