#include "usb_iidc_bus.h"

#include "usb_device.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// Maximum time of a single wait: another thread may handle the expected event.
constexpr auto longest_sleep = 20ms;
constexpr std::chrono::milliseconds longest_timeout = 24h; // prevents an overflow

void
claim(libusb_device_handle& handle,
      const UsbStreamEndpoint& endpoint,
      const std::string& place)
{
  libusb_set_auto_detach_kernel_driver(&handle, 1); // not every system supports this
  int configuration = 0;
  checkUsb(libusb_get_configuration(&handle, &configuration), place, "opening");
  // Setting the active configuration again would reset the camera.
  if (configuration != endpoint.configuration)
    checkUsb(libusb_set_configuration(&handle, endpoint.configuration),
             place,
             "setting its configuration");
  checkUsb(libusb_claim_interface(&handle, endpoint.interface), place, "reserving");
}

} // namespace

UsbClaim::UsbClaim(libusb_device_handle& handle,
                   const UsbStreamEndpoint& endpoint,
                   const std::string& place)
: handle_(handle)
, interface_(endpoint.interface)
{
  claim(handle, endpoint, place);
  if (endpoint.alternate == 0)
    return;
  const int result =
      libusb_set_interface_alt_setting(&handle, endpoint.interface, endpoint.alternate);
  if (result < 0) {
    libusb_release_interface(&handle, interface_);
    failUsb(result, place, "setting its interface");
  }
}

UsbClaim::~UsbClaim()
{
  libusb_release_interface(&handle_, interface_);
}

UsbIidcBus::UsbIidcBus(UsbContext context, UsbHandle handle, std::string place)
: context_(std::move(context))
, handle_(std::move(handle))
, place_(std::move(place))
, endpoint_(findUsbStreamEndpoint(*libusb_get_device(handle_.get()), place_))
, claim_(*handle_, endpoint_, place_)
, registers_(*handle_, place_)
{}

UsbIidcBus::~UsbIidcBus() = default;

std::string
UsbIidcBus::place() const
{
  return place_;
}

std::uint32_t
UsbIidcBus::readQuadlet(std::uint64_t address)
{
  return registers_.read(address);
}

void
UsbIidcBus::writeQuadlet(std::uint64_t address, std::uint32_t value)
{
  registers_.write(address, value);
}

void
UsbIidcBus::startStream(std::size_t frame_bytes, std::size_t frames)
{
  if (stream_)
    throw CameraException(CameraFault::Failed, place_ + ": it streams already");
  auto stream =
      std::make_unique<UsbStream>(*context_, *handle_, endpoint_, place_, frame_bytes);
  stream->start(frames);
  stream_ = std::move(stream);
  is_cancelled_ = false;
}

IidcWait
UsbIidcBus::nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout)
{
  if (!stream_)
    throw CameraException(CameraFault::Failed, place_ + ": it does not stream");
  const Clock::time_point end = Clock::now() + std::min(timeout, longest_timeout);
  for (bool is_over = false;;) {
    if (is_cancelled_.exchange(false))
      return IidcWait::Cancelled;
    if (stream_->take(frame))
      return IidcWait::Frame;
    if (is_over)
      return IidcWait::TimedOut;
    const auto left =
        std::chrono::duration_cast<std::chrono::microseconds>(end - Clock::now());
    is_over = left <= 0us;
    stream_->handleEvents(
        std::clamp<std::chrono::microseconds>(left, 0us, longest_sleep));
  }
}

void
UsbIidcBus::stopStream() noexcept
{
  stream_.reset();
}

void
UsbIidcBus::cancel() noexcept
{
  is_cancelled_ = true;
  libusb_interrupt_event_handler(context_.get());
}

} // namespace pcl::acmap
