#include "memory_bus.h"

#include "iidc_addresses.h"

#include <utility>

namespace pcl::acmap::test {
namespace {

/** \brief Maximum memory for the frames of one camera. */
constexpr std::size_t max_bytes = std::size_t{1} << 28;

} // namespace

class MemoryBus : public IidcBus {
public:
  explicit MemoryBus(MemoryCable& cable)
  : cable_(cable)
  {
    requirePlugged();
  }

  std::string
  place() const override
  {
    return "memory";
  }

  std::uint32_t
  readQuadlet(std::uint64_t address) override
  {
    count();
    if (cable_.garble && address >= iidc::commands)
      return cable_.garble(address);
    const auto value = cable_.camera_.read(address);
    if (!value)
      throw CameraException(CameraFault::Unsupported, "no such register");
    return *value;
  }

  void
  writeQuadlet(std::uint64_t address, std::uint32_t value) override
  {
    count();
    if (!cable_.camera_.write(address, value))
      throw CameraException(CameraFault::Unsupported, "no such register");
  }

  void
  startStream(std::size_t frame_bytes, std::size_t frames) override
  {
    requirePlugged();
    if (is_streaming_)
      throw CameraException(CameraFault::Failed, "it streams already");
    if (frame_bytes == 0 || frames > max_bytes / frame_bytes)
      throw CameraException(CameraFault::Failed, "frames that cannot be");
    const std::lock_guard lock(cable_.mutex_);
    cable_.frame_bytes = frame_bytes;
    is_streaming_ = true;
    is_cancelled_ = false;
  }

  IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout) override
  {
    requirePlugged();
    if (!is_streaming_)
      throw CameraException(CameraFault::Failed, "it does not stream");
    std::optional<CameraFrame> next;
    const auto has_ended = [&] {
      if (!is_cancelled_ && !next)
        next = cable_.camera_.takeFrame();
      return is_cancelled_ || next;
    };
    std::unique_lock lock(cable_.mutex_);
    if (!cable_.changed_.wait_for(lock, timeout, has_ended))
      return IidcWait::TimedOut;
    if (std::exchange(is_cancelled_, false))
      return IidcWait::Cancelled;
    frame.bytes = std::move(next->bytes);
    frame.is_whole = frame.bytes.size() == cable_.frame_bytes;
    frame.stamp = static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(
            std::chrono::system_clock::now().time_since_epoch())
            .count());
    return IidcWait::Frame;
  }

  void
  stopStream() noexcept override
  {
    is_streaming_ = false;
  }

  void
  cancel() noexcept override
  {
    const std::lock_guard lock(cable_.mutex_);
    is_cancelled_ = true;
    cable_.changed_.notify_all();
  }

private:
  void
  requirePlugged() const
  {
    if (!cable_.is_plugged)
      throw CameraException(CameraFault::Unplugged, "the cable is out");
  }

  void
  count()
  {
    requirePlugged();
    if (cable_.accesses++ == cable_.failing_access)
      throw CameraException(cable_.failure, "this access fails");
  }

  MemoryCable& cable_;
  bool is_streaming_ = false;
  bool is_cancelled_ = false; ///< protected by the mutex of the cable
};

MemoryCable::MemoryCable(EmulatedIidcCamera& camera)
: camera_(camera)
{
  camera_.whenFrameWaits([this] {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  });
}

MemoryCable::~MemoryCable()
{
  camera_.whenFrameWaits(nullptr);
}

IidcBusOpener
MemoryCable::opener()
{
  return [this] { return std::make_unique<MemoryBus>(*this); };
}

} // namespace pcl::acmap::test
