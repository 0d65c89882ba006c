#pragma once

#include "camera_modes.h"
#include "config_rom.h"
#include "feature_registers.h"

#include <pcl/acquisition/iidc_bus.h>
#include <pcl/acquisition/iidc_types.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Settings that the user made; they are kept when the bus is closed. */
struct WantedSettings {
  std::optional<IidcMode> mode;
  float rate = 0; ///< Hz
  std::map<IidcFeature, FeatureSetting> features;
  IidcTrigger trigger = IidcTrigger::Off;
};

/** \brief A camera, its known properties and its settings. The mutex must be held when
 * a member function is called or a field is accessed. The bus has a separate mutex,
 * which is only held for a moment, so that waiting for a frame does not block access to
 * the registers. */
class CameraState {
public:
  explicit CameraState(IidcBusOpener opener);

  /** \brief Opens the bus, identifies the camera, initializes it and applies the
   * settings. */
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

  /** \brief Applies the mode and the rate of the settings, if any. */
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

/** \brief Reads the configuration ROM of the camera on a bus. */
ConfigRom
readConfigRom(IidcBus& bus);

/** \brief IIDC version as text. */
std::string
versionText(const ConfigRom& rom);

/** \brief Colour filter as reported by the camera: `GBRG` or similar, `YYYY` if there
 * is none. */
std::string
colorFilterOf(const CameraState& state);

} // namespace pcl::acmap
