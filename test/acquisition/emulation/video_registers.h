#pragma once

#include "register_map.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pcl::acmap::test {

/** \brief Current image setting of the camera. */
struct VideoSetting {
  std::uint32_t format = 0;
  std::uint32_t mode = 4;
  std::uint32_t coding = 4; ///< iidc::Coding
  std::uint32_t width = 640;
  std::uint32_t height = 480;
  std::uint32_t left = 0;
  std::uint32_t top = 0;
  std::size_t image_bytes = 0;
  std::size_t transfer_bytes = 0; ///< size of all packets: at least image_bytes
  std::chrono::duration<double> period{};
};

/** \brief Registers of formats, modes and rates; Format_7 with its handshake.
 *
 * Format_0 has modes 4 (RGB8) and 5 (Mono8). Format_7 has mode 0 (RGB8: three cameras,
 * one byte each; or Mono8, Raw8) and mode 3 (Mono16, Raw16: two cameras). All are
 * 640x480. */
class VideoRegisters {
public:
  /** \param[in] setting_reads number of reads of VALUE_SETTING until the camera is
   * ready */
  VideoRegisters(RegisterMap& registers, std::uint32_t setting_reads);

  /** \brief Called after a write of the host. */
  void
  written(std::uint32_t offset);

  /** \brief Called after a read of the host. */
  void
  wasRead(std::uint32_t offset);

  /** \brief The current setting; nothing while the registers are inconsistent. */
  std::optional<VideoSetting>
  setting() const;

private:
  void
  addFixedFormat();
  void
  addScalableMode(std::uint32_t mode, std::uint32_t codings, std::uint32_t coding);
  void
  settle(std::uint32_t base);
  void
  checkPacket(std::uint32_t base);
  std::optional<VideoSetting>
  fixedSetting(std::uint32_t mode, std::uint32_t rate) const;
  std::optional<VideoSetting>
  scalableSetting(std::uint32_t mode) const;

  RegisterMap& registers_;
  std::uint32_t setting_reads_;
  std::uint32_t busy_reads_ = 0; ///< remaining
};

} // namespace pcl::acmap::test
