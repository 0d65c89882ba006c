#include "usb_stream.h"

#include "usb_device.h"

#include <algorithm>
#include <mutex>

namespace pcl::acmap {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t min_transfers = 2; // one receives, one is being read
constexpr std::size_t max_transfers = 64;
constexpr std::size_t max_bytes = std::size_t{1} << 28; // beyond any sensor's frame
constexpr int max_faults = 3;
constexpr auto longest_recall = 1s;
// A hub needs a moment to notice that a device was removed; until then transfers fail.
constexpr auto restart_pause = 100ms;

using UsbTransfer = std::unique_ptr<libusb_transfer, UsbRelease<libusb_free_transfer>>;

std::uint64_t
microsecondsNow()
{
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

} // namespace

/** \brief Data that libusb's callback accesses. The callback may run in any thread that
 * handles events, also in one that writes a register. */
struct UsbStream::Ended {
  std::mutex mutex;
  std::vector<Slot*> slots; // in order of completion; no reallocation in callbacks
};

/** \brief A transfer, its buffer and its state. */
struct UsbStream::Slot {
  explicit Slot(std::shared_ptr<Ended> to)
  : transfer(libusb_alloc_transfer(0))
  , ended(std::move(to))
  {
    if (!transfer)
      throw std::bad_alloc();
  }

  static void
  complete(libusb_transfer* transfer) noexcept
  {
    Slot& slot = *static_cast<Slot*>(transfer->user_data);
    const std::lock_guard lock(slot.ended->mutex);
    slot.stamp = microsecondsNow();
    slot.is_in_flight = false;
    slot.ended->slots.push_back(&slot);
  }

  UsbTransfer transfer;
  std::shared_ptr<Ended> ended;
  std::vector<std::uint8_t> bytes;
  std::uint64_t stamp = 0;
  bool is_in_flight = false; // protected by the mutex of ended
};

UsbStream::UsbStream(libusb_context& context,
                     libusb_device_handle& handle,
                     const UsbStreamEndpoint& endpoint,
                     std::string place,
                     std::size_t frame_bytes)
: context_(context)
, handle_(handle)
, endpoint_(endpoint)
, place_(std::move(place))
, frame_bytes_(frame_bytes)
, ended_(std::make_shared<Ended>())
{
  if (frame_bytes == 0 || frame_bytes > max_bytes)
    throw CameraException(CameraFault::Failed,
                          place_ + ": frames of " + std::to_string(frame_bytes) +
                              " bytes cannot be");
  // A multiple of the packet size: a device that sends more than a frame causes no
  // overrun.
  const std::size_t packets =
      (frame_bytes + endpoint.packet_bytes - 1) / endpoint.packet_bytes;
  buffer_bytes_ = packets * endpoint.packet_bytes;
}

UsbStream::~UsbStream()
{
  recall();
  const std::lock_guard lock(ended_->mutex);
  for (std::unique_ptr<Slot>& slot : slots_)
    if (slot->is_in_flight)
      slot.release(); // the system did not return it and may still write to it
}

void
UsbStream::start(std::size_t frames)
{
  const std::size_t count = std::clamp(frames, min_transfers, max_transfers);
  slots_.reserve(count);
  ended_->slots.reserve(count);
  while (slots_.size() < count) {
    const std::size_t before = slots_.size();
    slots_.push_back(std::make_unique<Slot>(ended_));
    if (!submit(*slots_.back()))
      lose();
    if (slots_.size() == before)
      return; // out of memory
  }
}

bool
UsbStream::take(IidcFrame& frame)
{
  if (is_halted_ && Clock::now() < restart_at_)
    return false;
  if (is_halted_)
    restart();
  const bool is_in_flight = isInFlight();
  Slot* slot = nextEnded();
  if (!slot && is_gone_ && !is_in_flight)
    lose();
  if (!slot)
    return false;
  switch (slot->transfer->status) {
  case LIBUSB_TRANSFER_COMPLETED:
  case LIBUSB_TRANSFER_OVERFLOW:
    return takeFrame(*slot, frame);
  case LIBUSB_TRANSFER_NO_DEVICE:
    lose();
  default:
    halt(slot->transfer->status == LIBUSB_TRANSFER_STALL);
    return false;
  }
}

void
UsbStream::handleEvents(std::chrono::microseconds time)
{
  timeval interval{};
  interval.tv_usec = static_cast<suseconds_t>(time.count());
  const int result =
      libusb_handle_events_timeout_completed(&context_, &interval, nullptr);
  if (result != LIBUSB_ERROR_INTERRUPTED)
    checkUsb(result, place_, "waiting for frames");
}

/** \brief Removes and returns the transfer that was completed first; null if there is
 * none. */
UsbStream::Slot*
UsbStream::nextEnded()
{
  const std::lock_guard lock(ended_->mutex);
  if (ended_->slots.empty())
    return nullptr;
  Slot* slot = ended_->slots.front();
  ended_->slots.erase(ended_->slots.begin());
  return slot;
}

bool
UsbStream::isInFlight() const
{
  const std::lock_guard lock(ended_->mutex);
  return std::any_of(slots_.begin(), slots_.end(), [](const auto& slot) {
    return slot->is_in_flight;
  });
}

/** \brief Submits a transfer, or deletes it when the system is short of memory and
 * enough others are left.
 * \return false when the camera was removed */
bool
UsbStream::submit(Slot& slot)
{
  slot.bytes.resize(buffer_bytes_);
  libusb_fill_bulk_transfer(slot.transfer.get(),
                            &handle_,
                            endpoint_.address,
                            slot.bytes.data(),
                            static_cast<int>(buffer_bytes_),
                            Slot::complete,
                            &slot,
                            0);
  const auto set_in_flight = [&](bool is_in_flight) {
    const std::lock_guard lock(ended_->mutex);
    slot.is_in_flight = is_in_flight;
  };
  set_in_flight(true); // before its callback can run
  const int result = libusb_submit_transfer(slot.transfer.get());
  if (result == 0)
    return true;
  set_in_flight(false);
  if (result == LIBUSB_ERROR_NO_DEVICE)
    return false;
  if (result != LIBUSB_ERROR_NO_MEM || slots_.size() <= min_transfers)
    failUsb(result, place_, "asking for frames");
  slots_.erase(std::find_if(slots_.begin(), slots_.end(), [&](const auto& other) {
    return other.get() == &slot;
  }));
  return true;
}

/** \brief Returns the data of a transfer and submits the transfer again. */
bool
UsbStream::takeFrame(Slot& slot, IidcFrame& frame)
{
  const bool is_complete = slot.transfer->status == LIBUSB_TRANSFER_COMPLETED;
  const auto length = static_cast<std::size_t>(slot.transfer->actual_length);
  // A frame that fills its last packet may be followed by an empty packet that ends it.
  const bool is_end_of_last = is_complete && length == 0 && was_full_;
  was_full_ = is_complete && length == buffer_bytes_;
  if (!is_end_of_last) {
    faults_ = 0;
    frame.bytes.swap(slot.bytes);
    frame.bytes.resize(length);
    frame.is_whole = is_complete && length == frame_bytes_;
    frame.stamp = slot.stamp;
  }
  is_gone_ = !submit(slot) || is_gone_; // earlier frames are still returned
  return !is_end_of_last;
}

void
UsbStream::lose()
{
  is_gone_ = true;
  failUsb(LIBUSB_ERROR_NO_DEVICE, place_, "receiving frames");
}

/** \brief Cancels all transfers, since an endpoint may only be cleared while it is
 * idle. */
void
UsbStream::halt(bool is_stall)
{
  recall();
  if (isInFlight()) // the system still writes to their buffers
    throw CameraException(CameraFault::Failed,
                          place_ + ": transfers that were taken back do not come");
  {
    const std::lock_guard lock(ended_->mutex);
    ended_->slots.clear();
  }
  was_full_ = false;
  is_halted_ = true;
  restart_at_ = Clock::now();
  if (!is_stall)
    restart_at_ += restart_pause;
  if (++faults_ == max_faults) {
    faults_ = 0;
    throw CameraException(CameraFault::Failed,
                          place_ + (is_stall ? ": the stream stalls again and again"
                                             : ": the stream fails again and again"));
  }
}

void
UsbStream::restart()
{
  if (libusb_clear_halt(&handle_, endpoint_.address) == LIBUSB_ERROR_NO_DEVICE)
    lose();
  is_halted_ = false;
  std::vector<Slot*> slots;
  for (const std::unique_ptr<Slot>& slot : slots_)
    slots.push_back(slot.get());
  for (Slot* slot : slots)
    if (!submit(*slot))
      lose();
}

/** \brief Cancels all transfers and waits, for a limited time, until they have
 * ended. */
void
UsbStream::recall() noexcept
{
  for (const std::unique_ptr<Slot>& slot : slots_)
    libusb_cancel_transfer(slot->transfer.get()); // does nothing if it is not in flight
  const Clock::time_point end = Clock::now() + longest_recall;
  while (isInFlight() && Clock::now() < end) {
    timeval interval{0, 20000};
    libusb_handle_events_timeout_completed(&context_, &interval, nullptr);
  }
}

} // namespace pcl::acmap
