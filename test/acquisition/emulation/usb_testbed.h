#pragma once

#include "emulated_iidc_camera.h"
#include "usb_descriptors.h"
#include "usbfs_node.h"

#include <umockdev.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pcl::acmap::test {

class UsbTestbed;

/** \brief A camera with a USB cable, which is plugged in at first. */
class EmulatedUsbCamera {
public:
  EmulatedUsbCamera(UsbTestbed& testbed,
                    EmulatedIidcCamera& camera,
                    const UsbIdentity& identity = {});
  ~EmulatedUsbCamera();

  EmulatedUsbCamera(const EmulatedUsbCamera&) = delete;
  EmulatedUsbCamera&
  operator=(const EmulatedUsbCamera&) = delete;

  /** \brief Plugs the cable in; the device gets a new address, as from the kernel. */
  void
  plug();

  /** \brief Unplugs the cable: transfers fail, the device disappears, the camera loses
   * power. */
  void
  unplug();

  bool
  plugged() const;

  /** \brief Sets if users may open the device, which a udev rule normally grants. */
  void
  setPermission(bool granted);

  /** \brief Number of the device on bus 1. */
  int
  address() const;

private:
  std::string
  nodePath() const;
  std::string
  pipePath() const;

  UsbTestbed& testbed_;
  EmulatedIidcCamera& camera_;
  const UsbIdentity identity_;
  const std::string system_path_;

  mutable std::mutex mutex_;        ///< protects all following members
  std::shared_ptr<UsbfsNode> node_; ///< null: unplugged
  int address_ = 0;
};

/** \brief Emulates the USB of a machine, without devices at first, for libusb in this
 * process and its children during the lifetime of this object.
 *
 * The process must run with `libumockdev-preload.so.0` in LD_PRELOAD
 * (acmap_add_usb_test does that). Devices must be closed before it is destroyed,
 * because otherwise the preloaded library aborts the process. */
class UsbTestbed {
public:
  UsbTestbed();
  ~UsbTestbed();

  UsbTestbed(const UsbTestbed&) = delete;
  UsbTestbed&
  operator=(const UsbTestbed&) = delete;

private:
  friend class EmulatedUsbCamera;

  int
  nextPort();
  int
  nextAddress();
  std::string
  rootFolder() const;
  void
  add(const std::string& system_path,
      int address,
      const UsbIdentity& identity,
      const std::shared_ptr<UsbfsNode>& node);
  void
  remove(const std::string& system_path);

  std::mutex mutex_; ///< protects all following members
  ObjectPtr<UMockdevTestbed> testbed_;
  int ports_ = 0;
  int addresses_ = 1; ///< the hub has address 1
};

} // namespace pcl::acmap::test
