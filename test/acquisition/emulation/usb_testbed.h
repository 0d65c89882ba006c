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

/** \brief A camera on a cable, which is in the socket at first. */
class EmulatedUsbCamera {
public:
  EmulatedUsbCamera(UsbTestbed& testbed,
                    EmulatedIidcCamera& camera,
                    const UsbIdentity& identity = {});
  ~EmulatedUsbCamera();

  EmulatedUsbCamera(const EmulatedUsbCamera&) = delete;
  EmulatedUsbCamera&
  operator=(const EmulatedUsbCamera&) = delete;

  /** \brief The cable goes in: a new address, as the kernel gives it. */
  void
  plug();

  /** \brief The cable goes: transfers fail, the device vanishes, the camera loses power. */
  void
  unplug();

  bool
  plugged() const;

  /** \brief Whether users may open the device, as a udev rule would have it. */
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

  mutable std::mutex mutex_;        ///< of all that follows
  std::shared_ptr<UsbfsNode> node_; ///< none: unplugged
  int address_ = 0;
};

/** \brief A machine with nothing on its USB: what libusb sees, in this process and those it
 * starts, as long as it lives.
 *
 * The process runs with `libumockdev-preload.so.0` in LD_PRELOAD (acmap_add_usb_test does
 * that). Devices must be closed before it goes, for the preloaded library ends a process
 * that loses its device in another way. */
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

  std::mutex mutex_; ///< of all that follows
  ObjectPtr<UMockdevTestbed> testbed_;
  int ports_ = 0;
  int addresses_ = 1; ///< the hub has the first one
};

} // namespace pcl::acmap::test
