#pragma once

#include "emulated_iidc_camera.h"
#include "stream_endpoint.h"
#include "usb_descriptors.h"

#include <umockdev.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pcl::acmap::test {

struct ObjectDeleter {
  void
  operator()(void* object) const
  {
    g_object_unref(object);
  }
};

template <typename Type>
using ObjectPtr = std::unique_ptr<Type, ObjectDeleter>;

/** \brief The device node of a camera, from plug to unplug: handles requests as usbfs
 * of the kernel does.
 *
 * The node is a pipe with a capacity of one byte. While it is full, a client that
 * polls it for writing sleeps; while it is empty, a finished transfer is available. */
class UsbfsNode {
public:
  /** \param[in] path of the node, which is created
   * \param[in] cable_goes called when a frame is to be the last one */
  UsbfsNode(EmulatedIidcCamera& camera,
            const UsbIdentity& identity,
            const std::string& path,
            std::function<void()> cable_goes);
  ~UsbfsNode();

  UsbfsNode(const UsbfsNode&) = delete;
  UsbfsNode&
  operator=(const UsbfsNode&) = delete;

  /** \brief Answers a request; may only be called in umockdev's thread. */
  void
  answer(UMockdevIoctlClient* client);

  void
  forget(UMockdevIoctlClient* client);

  /** \brief Passes frames of the camera to waiting transfers. */
  void
  serve();

  /** \brief Unplugs the cable: pending and new requests fail. The camera is not
   * accessed afterwards. */
  void
  disconnect();

private:
  /** \brief A transfer, or a part of one. */
  struct Urb {
    ObjectPtr<UMockdevIoctlData> data;
    UMockdevIoctlClient* client;
    unsigned long address; ///< in the memory of the client
    unsigned char type;
    unsigned char endpoint;
    unsigned flags;
    std::size_t length;
    int status;
    std::vector<std::uint8_t> bytes; ///< received so far
  };

  struct Client {
    std::deque<Urb> finished;
    bool chain_broken = false; ///< continuations of the last transfer are too late
  };

  int
  answerOf(UMockdevIoctlClient* client, UMockdevIoctlData* argument, long& result);
  int
  submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  int
  reap(Client& client, UMockdevIoctlData* argument);
  int
  discard(UMockdevIoctlClient* client, unsigned long address);
  int
  claim(UMockdevIoctlClient* client, unsigned interface);
  int
  release(UMockdevIoctlClient* client, unsigned interface);
  void
  control(Urb urb);
  void
  finish(Urb urb);
  void
  breakChain(UMockdevIoctlClient* client);
  void
  serveLocked();
  void
  showReady();

  EmulatedIidcCamera& camera_;
  const UsbIdentity identity_;
  const std::function<void()> cable_goes_;
  int pipe_ = -1;

  std::mutex mutex_; ///< protects all following members
  std::map<UMockdevIoctlClient*, Client> clients_;
  std::list<Urb> pending_;               ///< in order of arrival
  UMockdevIoctlClient* owner_ = nullptr; ///< client that has claimed the interface
  StreamEndpoint stream_;
  bool connected_ = true;
  bool cable_cut_ = false;
  bool ready_ = true;
};

} // namespace pcl::acmap::test
