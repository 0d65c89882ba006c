#include "usb_testbed.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace pcl::acmap::test {
namespace {

/** \brief A file that even root cannot open for writing. */
constexpr const char* forbidden = "/proc/sys/kernel/ostype";

std::string
hexOf(const std::vector<std::uint8_t>& bytes)
{
  std::string text;
  char digits[3];
  for (const std::uint8_t byte : bytes) {
    std::snprintf(digits, sizeof digits, "%02X", byte);
    text += digits;
  }
  return text;
}

std::string
nodeName(int address)
{
  char name[32];
  std::snprintf(name, sizeof name, "bus/usb/001/%03d", address);
  return name;
}

/** \brief Description of the device in the format of umockdev. */
std::string
descriptionOf(const std::string& system_path, int address, const UsbIdentity& identity)
{
  char ids[64];
  std::snprintf(ids,
                sizeof ids,
                "A: idVendor=%04x\nA: idProduct=%04x\n",
                unsigned{identity.vendor},
                unsigned{identity.product});
  const std::string number = std::to_string(address);
  char devnum[8];
  std::snprintf(devnum, sizeof devnum, "%03d", address);
  return "P: " + system_path + "\nE: DEVNAME=/dev/" + nodeName(address) +
         "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\n" +
         "E: MAJOR=189\nE: MINOR=" + std::to_string(address - 1) +
         "\nE: BUSNUM=001\nE: DEVNUM=" + devnum + "\n" + ids +
         "A: busnum=1\nA: devnum=" + number + "\nA: bConfigurationValue=1\nA: speed=" +
         (identity.super_speed ? "5000" : "480") +
         "\nA: manufacturer=" + identity.manufacturer +
         "\nA: product=" + identity.name + "\nA: serial=" + identity.serial +
         "\nH: descriptors=" + hexOf(descriptorsOf(identity)) + "\n";
}

using NodeHolder = std::shared_ptr<UsbfsNode>;

gboolean
onRequest(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node)
{
  (*static_cast<NodeHolder*>(node))->answer(client);
  return TRUE;
}

void
dropHolder(gpointer node, GClosure*)
{
  delete static_cast<NodeHolder*>(node);
}

void
connect(UMockdevIoctlBase* handler,
        const char* signal,
        GCallback callback,
        const NodeHolder& node)
{
  g_signal_connect_data(
      handler, signal, callback, new NodeHolder(node), dropHolder, GConnectFlags{});
}

void
onClosed(gpointer node, GObject* client)
{
  const std::unique_ptr<NodeHolder> holder(static_cast<NodeHolder*>(node));
  (*holder)->forget(reinterpret_cast<UMockdevIoctlClient*>(client));
}

// The handler also has a signal for the end of a client, but umockdev does not emit it;
// so the destruction of the client object is observed.
void
onOpened(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node)
{
  g_object_weak_ref(
      G_OBJECT(client), onClosed, new NodeHolder(*static_cast<NodeHolder*>(node)));
}

} // namespace

EmulatedUsbCamera::EmulatedUsbCamera(UsbTestbed& testbed,
                                     EmulatedIidcCamera& camera,
                                     const UsbIdentity& identity)
: testbed_(testbed)
, camera_(camera)
, identity_(identity)
, system_path_("/devices/pci0000:00/0000:00:14.0/usb1/1-" +
               std::to_string(testbed.nextPort()))
{
  plug();
  camera_.whenFrameWaits([this] {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto node = node_;
    lock.unlock();
    if (node)
      node->serve();
  });
}

EmulatedUsbCamera::~EmulatedUsbCamera()
{
  camera_.whenFrameWaits(nullptr);
  unplug();
}

void
EmulatedUsbCamera::plug()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (node_)
    return;
  address_ = testbed_.nextAddress();
  std::filesystem::create_directories(std::filesystem::path(nodePath()).parent_path());
  node_ =
      std::make_shared<UsbfsNode>(camera_, identity_, pipePath(), [this] { unplug(); });
  std::filesystem::create_symlink(pipePath(), nodePath());
  testbed_.add(system_path_, address_, identity_, node_);
}

void
EmulatedUsbCamera::unplug()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto node = std::exchange(node_, nullptr);
  if (!node)
    return;
  node->disconnect();
  camera_.cyclePower();
  std::error_code ignored;
  std::filesystem::remove(nodePath(), ignored);
  testbed_.remove(system_path_);
}

bool
EmulatedUsbCamera::plugged() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return node_ != nullptr;
}

void
EmulatedUsbCamera::setPermission(bool granted)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!node_)
    throw std::logic_error("no device, no permission");
  std::filesystem::remove(nodePath());
  std::filesystem::create_symlink(granted ? pipePath() : forbidden, nodePath());
}

int
EmulatedUsbCamera::address() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return address_;
}

std::string
EmulatedUsbCamera::nodePath() const
{
  return testbed_.rootFolder() + "/dev/" + nodeName(address_);
}

std::string
EmulatedUsbCamera::pipePath() const
{
  return nodePath() + ".pipe";
}

UsbTestbed::UsbTestbed()
: testbed_(umockdev_testbed_new())
{
  if (!umockdev_in_mock_environment())
    throw std::logic_error("LD_PRELOAD lacks libumockdev-preload.so.0");
}

UsbTestbed::~UsbTestbed() = default;

int
UsbTestbed::nextPort()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return ++ports_;
}

int
UsbTestbed::nextAddress()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return ++addresses_;
}

std::string
UsbTestbed::rootFolder() const
{
  const std::unique_ptr<gchar, decltype(&g_free)> path(
      umockdev_testbed_get_root_dir(testbed_.get()), g_free);
  return path.get();
}

void
UsbTestbed::add(const std::string& system_path,
                int address,
                const UsbIdentity& identity,
                const std::shared_ptr<UsbfsNode>& node)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const ObjectPtr<UMockdevIoctlBase> handler(umockdev_ioctl_base_new());
  connect(handler.get(), "handle-ioctl", G_CALLBACK(onRequest), node);
  connect(handler.get(), "client-connected", G_CALLBACK(onOpened), node);
  const std::string name = "/dev/" + nodeName(address);
  GError* error = nullptr;
  // Must come first: adding the device emits an event, and listeners may open the node
  // at once.
  if (!umockdev_testbed_attach_ioctl(
          testbed_.get(), name.c_str(), handler.get(), &error) ||
      !umockdev_testbed_add_from_string(
          testbed_.get(),
          descriptionOf(system_path, address, identity).c_str(),
          &error))
    throw std::runtime_error(error ? error->message : name);
}

void
UsbTestbed::remove(const std::string& system_path)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string path = "/sys" + system_path;
  umockdev_testbed_uevent(testbed_.get(), path.c_str(), "remove");
  umockdev_testbed_remove_device(testbed_.get(), path.c_str());
}

} // namespace pcl::acmap::test
