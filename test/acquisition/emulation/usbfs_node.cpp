#include "usbfs_node.h"

#include "usb_control.h"

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace pcl::acmap::test {
namespace {

constexpr unsigned char bulk_in = 0x81;

/** \brief The memory of the client to which the pointer at this offset of the data
 * points. */
ObjectPtr<UMockdevIoctlData>
resolve(UMockdevIoctlData* data, std::size_t offset, std::size_t length)
{
  return ObjectPtr<UMockdevIoctlData>(
      umockdev_ioctl_data_resolve(data, offset, length, nullptr));
}

template <typename Value>
std::optional<Value>
argumentOf(UMockdevIoctlData* argument)
{
  const auto data = resolve(argument, 0, sizeof(Value));
  if (!data)
    return std::nullopt;
  Value value;
  std::memcpy(&value, data->data, sizeof value);
  return value;
}

template <typename Value>
int
giveBack(UMockdevIoctlData* argument, const Value& value)
{
  const auto data = resolve(argument, 0, sizeof value);
  if (!data)
    return EFAULT;
  std::memcpy(data->data, &value, sizeof value);
  return 0;
}

unsigned long
addressIn(const UMockdevIoctlData* argument)
{
  unsigned long address;
  std::memcpy(&address, argument->data, sizeof address);
  return address;
}

} // namespace

UsbfsNode::UsbfsNode(EmulatedIidcCamera& camera,
                     const UsbIdentity& identity,
                     const std::string& path,
                     std::function<void()> cable_goes)
: camera_(camera)
, identity_(identity)
, cable_goes_(std::move(cable_goes))
, stream_(camera)
{
  unlink(path.c_str());
  if (mkfifo(path.c_str(), 0666) == 0)
    pipe_ = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (pipe_ < 0 || fcntl(pipe_, F_SETPIPE_SZ, 4096) < 0)
    throw std::system_error(errno, std::generic_category(), path);
  showReady();
}

UsbfsNode::~UsbfsNode()
{
  close(pipe_);
}

void
UsbfsNode::answer(UMockdevIoctlClient* client)
{
  long result = 0;
  int error = 0;
  bool cut = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    error = answerOf(client, umockdev_ioctl_client_get_arg(client), result);
    showReady();
    cut = std::exchange(cable_cut_, false);
  }
  umockdev_ioctl_client_complete(client, error ? -1 : result, error);
  if (cut)
    cable_goes_();
}

void
UsbfsNode::forget(UMockdevIoctlClient* client)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  pending_.remove_if([&](const Urb& urb) { return urb.client == client; });
  clients_.erase(client);
  if (owner_ == client)
    owner_ = nullptr;
  showReady();
}

void
UsbfsNode::serve()
{
  bool cut = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    serveLocked();
    showReady();
    cut = std::exchange(cable_cut_, false);
  }
  if (cut)
    cable_goes_();
}

void
UsbfsNode::disconnect()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  connected_ = false;
  while (!pending_.empty()) {
    Urb urb = std::move(pending_.front());
    pending_.pop_front();
    urb.status = -ESHUTDOWN;
    finish(std::move(urb));
  }
  showReady();
}

/** \brief Error number of a request, 0 on success. */
int
UsbfsNode::answerOf(UMockdevIoctlClient* client,
                    UMockdevIoctlData* argument,
                    long& result)
{
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  if (request == USBDEVFS_REAPURBNDELAY)
    return reap(clients_[client], argument);
  if (!connected_)
    return ENODEV;
  switch (request) {
  case USBDEVFS_GET_CAPABILITIES: {
    const std::uint32_t pieces = USBDEVFS_CAP_BULK_CONTINUATION;
    const std::uint32_t whole =
        pieces | USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_BULK_SCATTER_GATHER;
    const std::uint32_t always =
        USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
    return giveBack(argument, always | (identity_.splits_bulk ? pieces : whole));
  }
  case USBDEVFS_GET_SPEED:
    result = identity_.super_speed ? 5 : 3;
    return 0;
  case USBDEVFS_GETDRIVER:
    return ENODATA;
  case USBDEVFS_CLAIMINTERFACE:
    return claim(client, argumentOf<unsigned>(argument).value_or(~0U));
  case USBDEVFS_DISCONNECT_CLAIM: {
    const auto wish = argumentOf<usbdevfs_disconnect_claim>(argument);
    return wish ? claim(client, wish->interface) : EFAULT;
  }
  case USBDEVFS_RELEASEINTERFACE:
    return release(client, argumentOf<unsigned>(argument).value_or(~0U));
  case USBDEVFS_SETCONFIGURATION:
    if (owner_)
      return EBUSY;
    return argumentOf<int>(argument) == 1 ? 0 : EINVAL;
  case USBDEVFS_SETINTERFACE:
  case USBDEVFS_RESET:
    return 0;
  case USBDEVFS_CLEAR_HALT:
  case USBDEVFS_RESETEP:
    stream_.clearHalt();
    serveLocked();
    return 0;
  case USBDEVFS_SUBMITURB:
    return submit(client, argument);
  case USBDEVFS_DISCARDURB:
    return discard(client, addressIn(argument));
  default:
    return ENOTTY;
  }
}

int
UsbfsNode::claim(UMockdevIoctlClient* client, unsigned interface)
{
  if (interface != 0)
    return ENOENT;
  if (owner_ && owner_ != client)
    return EBUSY;
  owner_ = client;
  return 0;
}

int
UsbfsNode::release(UMockdevIoctlClient* client, unsigned interface)
{
  if (interface != 0 || owner_ != client)
    return EINVAL;
  owner_ = nullptr;
  return 0;
}

int
UsbfsNode::submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  auto data = resolve(argument, 0, sizeof(usbdevfs_urb));
  if (!data)
    return EFAULT;
  const unsigned long address = data->client_addr;
  usbdevfs_urb wish;
  std::memcpy(&wish, data->data, sizeof wish);
  Urb urb{std::move(data),
          client,
          address,
          wish.type,
          wish.endpoint,
          wish.flags,
          static_cast<std::size_t>(std::max(wish.buffer_length, 0)),
          0,
          {}};
  if (wish.type == USBDEVFS_URB_TYPE_CONTROL) {
    control(std::move(urb));
    return 0;
  }
  if (wish.type != USBDEVFS_URB_TYPE_BULK || wish.endpoint != bulk_in ||
      !identity_.bulk_endpoint)
    return ENOENT;
  // Claims the interface for clients that have not done it, as usbfs does.
  if (const int error = claim(client, 0))
    return error;
  Client& own = clients_[client];
  if (!(wish.flags & USBDEVFS_URB_BULK_CONTINUATION))
    own.chain_broken = false;
  else if (own.chain_broken)
    return EREMOTEIO;
  std::size_t memory = urb.length;
  for (const Urb& other : pending_)
    memory += other.length;
  if (memory > identity_.memory)
    return ENOMEM;
  pending_.push_back(std::move(urb));
  serveLocked();
  return 0;
}

int
UsbfsNode::discard(UMockdevIoctlClient* client, unsigned long address)
{
  const auto found =
      std::find_if(pending_.begin(), pending_.end(), [&](const Urb& urb) {
        return urb.client == client && urb.address == address;
      });
  if (found == pending_.end())
    return EINVAL;
  Urb urb = std::move(*found);
  pending_.erase(found);
  urb.status = -ENOENT;
  finish(std::move(urb));
  return 0;
}

int
UsbfsNode::reap(Client& client, UMockdevIoctlData* argument)
{
  if (client.finished.empty())
    return connected_ ? EAGAIN : ENODEV;
  const Urb urb = std::move(client.finished.front());
  client.finished.pop_front();
  if (!urb.bytes.empty()) {
    const bool control = urb.type == USBDEVFS_URB_TYPE_CONTROL;
    const auto buffer =
        resolve(urb.data.get(), offsetof(usbdevfs_urb, buffer), urb.length);
    if (!buffer)
      return EFAULT;
    std::copy(urb.bytes.begin(), urb.bytes.end(), buffer->data + (control ? 8 : 0));
  }
  auto* filled = reinterpret_cast<usbdevfs_urb*>(urb.data->data);
  filled->status = urb.status;
  filled->actual_length = static_cast<int>(urb.bytes.size());
  const auto slot = resolve(argument, 0, sizeof(void*));
  if (!slot)
    return EFAULT;
  umockdev_ioctl_data_set_ptr(slot.get(), 0, urb.data.get());
  return 0;
}

void
UsbfsNode::control(Urb urb)
{
  const ControlFault fault = camera_.faults().takeControl();
  if (fault == ControlFault::TimeOut)
    return pending_.push_back(std::move(urb));
  const auto buffer =
      resolve(urb.data.get(), offsetof(usbdevfs_urb, buffer), urb.length);
  std::optional<std::vector<std::uint8_t>> bytes;
  if (buffer && fault == ControlFault::None)
    bytes = answerControl(camera_, identity_, buffer->data, urb.length);
  if (bytes)
    urb.bytes = std::move(*bytes);
  else
    urb.status = fault == ControlFault::Error ? -EPROTO : -EPIPE;
  finish(std::move(urb));
}

void
UsbfsNode::serveLocked()
{
  if (!connected_)
    return;
  const auto streams = [](const Urb& urb) { return urb.endpoint == bulk_in; };
  while (!cable_cut_) {
    const auto found = std::find_if(pending_.begin(), pending_.end(), streams);
    if (found == pending_.end())
      return;
    auto part = stream_.next(found->length);
    if (!part)
      return;
    Urb urb = std::move(*found);
    pending_.erase(found);
    cable_cut_ = part->cable_cut;
    urb.bytes = std::move(part->bytes);
    urb.status = part->status;
    const bool is_short = urb.bytes.size() < urb.length;
    if (urb.status == 0 && is_short && (urb.flags & USBDEVFS_URB_SHORT_NOT_OK))
      urb.status = -EREMOTEIO;
    finish(std::move(urb));
  }
}

void
UsbfsNode::finish(Urb urb)
{
  UMockdevIoctlClient* client = urb.client;
  const bool breaks =
      urb.type == USBDEVFS_URB_TYPE_BULK && urb.status < 0 && urb.status != -ENOENT;
  clients_[client].finished.push_back(std::move(urb));
  if (breaks)
    breakChain(client);
}

/** \brief Cancels the parts that continue a transfer which ended early. */
void
UsbfsNode::breakChain(UMockdevIoctlClient* client)
{
  bool ended = false;
  for (auto urb = pending_.begin(); urb != pending_.end() && !ended;) {
    const bool own = urb->client == client && urb->type == USBDEVFS_URB_TYPE_BULK;
    ended = own && !(urb->flags & USBDEVFS_URB_BULK_CONTINUATION);
    if (!own || ended) {
      ++urb;
      continue;
    }
    urb->status = -ENOENT;
    clients_[client].finished.push_back(std::move(*urb));
    urb = pending_.erase(urb);
  }
  clients_[client].chain_broken = !ended;
}

/** \brief Empties the pipe if a finished transfer is available, else fills it. */
void
UsbfsNode::showReady()
{
  const bool ready =
      std::any_of(clients_.begin(), clients_.end(), [](const auto& client) {
        return !client.second.finished.empty();
      });
  if (ready == ready_)
    return;
  char byte = 0;
  const auto moved = ready ? ::read(pipe_, &byte, 1) : ::write(pipe_, &byte, 1);
  if (moved == 1)
    ready_ = ready;
}

} // namespace pcl::acmap::test
