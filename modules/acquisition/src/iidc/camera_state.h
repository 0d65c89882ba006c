#pragma once

#include "config_rom.h"
#include "feature_registers.h"
#include "mode_setting.h"

#include <pcl/acquisition/iidc_bus.h>
#include <pcl/acquisition/iidc_types.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What the user wants of a camera; it outlives a bus. */
struct WantedSettings {
  std::optional<IidcMode> mode;
  float rate = 0; ///< Hz
  std::map<IidcFeature, FeatureSetting> features;
  IidcTrigger trigger = IidcTrigger::Off;
};

/** \brief A camera, what is known of it and what it is to be. Whoever calls a member
 * function, or touches a field, holds the mutex; the bus has one of its own, for a moment
 * only, so that a wait for a frame keeps nobody from the registers. */
class CameraState {
public:
  explicit CameraState(IidcBusOpener opener);

  /** \brief Opens the bus, asks who is there, wakes the camera and sets what is wanted. */
  void
  open();

  bool
  isOpen() const;

  /** \throws CameraException Failed when it is closed */
  std::shared_ptr<IidcBus>
  requireBus() const;

  std::shared_ptr<IidcBus>
  exchangeBus(std::shared_ptr<IidcBus> other);

  /** \brief The command registers. */
  RegisterAccess
  registers() const;

  /** \brief Sets mode and rate that are wanted, if any are. */
  void
  applyMode();

  mutable std::mutex mutex;
  std::string place;
  ConfigRom rom;
  std::vector<IidcMode> modes;
  WantedSettings wanted;
  StreamSetting stream;
  bool has_one_shot = false;
  bool has_counter = false;

private:
  void
  identify(IidcBus& bus);

  void
  wake();

  float
  applyRate(const RegisterAccess& camera) const;

  const IidcBusOpener opener_;
  mutable std::mutex bus_mutex_;
  std::shared_ptr<IidcBus> bus_;
};

/** \brief Who the camera on a bus is. */
ConfigRom
readConfigRom(IidcBus& bus);

/** \brief Of IIDC, as people write it. */
std::string
versionText(const ConfigRom& rom);

/** \brief What the camera says of its colour filter: `GBRG` and the like, `YYYY` without.
 */
std::string
colorFilterOf(const CameraState& state);

} // namespace pcl::acmap
