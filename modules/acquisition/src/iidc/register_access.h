#pragma once

#include "registers.h"

#include <pcl/acquisition/iidc_bus.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pcl::acmap {

/** \brief Access to the registers of one camera, relative to a base address. */
class RegisterAccess {
public:
  RegisterAccess(std::shared_ptr<IidcBus> bus, std::uint64_t base)
  : bus_(std::move(bus))
  , base_(base)
  {}

  std::uint32_t
  read(std::uint64_t offset) const
  {
    return bus_->readQuadlet(base_ + offset);
  }

  /** \brief Reads an optional register; returns nothing if the camera does not have
   * it. */
  std::optional<std::uint32_t>
  tryRead(std::uint64_t offset) const;

  void
  write(std::uint64_t offset, std::uint32_t value) const
  {
    bus_->writeQuadlet(base_ + offset, value);
  }

  /** \brief Returns the block of registers whose position, counted in quadlets, is
   * stored in this register; nothing if the register contains none. */
  std::optional<RegisterAccess>
  behind(std::uint64_t offset) const;

  std::string
  place() const
  {
    return bus_->place();
  }

private:
  std::shared_ptr<IidcBus> bus_;
  std::uint64_t base_;
};

} // namespace pcl::acmap
