#include <pcl/acquisition/usb_camera.h>

#include "usb/usb_device.h"

#include <atomic>
#include <deque>
#include <set>
#include <thread>
#include <utility>

namespace pcl {

using namespace acmap;

struct UsbCameraWatch::State {
  explicit State(Callback to)
  : callback(std::move(to))
  , context(makeUsbContext())
  {}

  /** \brief Callback of libusb. It must not access a device, whereas the user's
   * callback may; therefore it queues the events. Until the thread starts, it is called
   * for the connected cameras; afterwards it is called by the thread only. */
  static int
  note(libusb_context*,
       libusb_device* device,
       libusb_hotplug_event event,
       void* state) noexcept
  {
    static_cast<State*>(state)->events.emplace_back(
        describe(*device), event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED);
    return 0;
  }

  void
  run() noexcept
  {
    while (!is_closing) {
      tellAll();
      timeval second{1, 0};
      libusb_handle_events_timeout_completed(context.get(), &second, nullptr);
    }
  }

  void
  tellAll() noexcept
  {
    for (; !events.empty() && !is_closing; events.pop_front()) {
      const auto& [camera, is_there] = events.front();
      // libusb may report a camera twice that was connected while the watch started
      const bool is_news = is_there ? places.insert(camera.place).second
                                    : places.erase(camera.place) > 0;
      if (is_news)
        tell(camera, is_there);
    }
  }

  void
  tell(const UsbCamera& camera, bool is_there) noexcept
  {
    try {
      callback(camera, is_there);
    }
    catch (...) { // there is no receiver for the exception
    }
  }

  const Callback callback;
  const UsbContext context;
  std::deque<std::pair<UsbCamera, bool>> events;
  std::set<std::string> places; // cameras that were reported as connected
  std::atomic<bool> is_closing{false};
  std::thread thread;
};

UsbCameraWatch::UsbCameraWatch(Callback callback)
: state_(std::make_unique<State>(std::move(callback)))
{
  if (!libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG))
    throw CameraException(CameraFault::Failed,
                          "this system does not tell when cameras come and go");
  const int events =
      LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
  checkUsb(libusb_hotplug_register_callback(state_->context.get(),
                                            events,
                                            LIBUSB_HOTPLUG_ENUMERATE,
                                            point_grey,
                                            LIBUSB_HOTPLUG_MATCH_ANY,
                                            LIBUSB_HOTPLUG_MATCH_ANY,
                                            State::note,
                                            state_.get(),
                                            nullptr),
           "usb",
           "watching for cameras");
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

UsbCameraWatch::~UsbCameraWatch()
{
  state_->is_closing = true;
  libusb_interrupt_event_handler(state_->context.get());
  state_->thread.join();
}

} // namespace pcl
