#include "emulated_iidc_camera.h"

#include "iidc_addresses.h"

#include <algorithm>
#include <utility>

namespace pcl::acmap::test {

using namespace iidc;
using Clock = std::chrono::steady_clock;

namespace {

Clock::duration
ticks(std::chrono::duration<double> time)
{
  return std::chrono::duration_cast<Clock::duration>(time);
}

/** \brief Seconds, cycles of 125 us and their fractions, in the format of the bus. */
std::uint32_t
cycleTime(Clock::time_point time)
{
  const auto ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch())
          .count();
  const auto seconds = static_cast<std::uint32_t>(ns / 1000000000 % 128);
  const auto cycles = static_cast<std::uint32_t>(ns / 125000 % 8000);
  const auto parts = static_cast<std::uint32_t>(ns % 125000 * 3072 / 125000);
  return seconds << 25 | cycles << 12 | parts;
}

} // namespace

/** \brief All registers with their values after power-on. */
struct EmulatedIidcCamera::Registers {
  explicit Registers(const CameraOptions& options)
  : video(map, options.setting_reads)
  , features(map)
  , vendor(map, options.tiles, options.locked)
  {
    map.keep(initialize, 0, on);
    map.fix(basic_functions, 0x80001000); // advanced features, one shot
    map.fix(optional_functions, 0);
    map.keep(iso_channel, 2U << 24, 0xF3000000);
    map.keep(power, on, on);
    map.keep(iso_enable, 0, on);
    map.keep(one_shot, 0, on);
    map.keep(software_trigger, 0, on);
    map.fix(data_depth, 8U << 24);
  }

  RegisterMap map;
  VideoRegisters video;
  FeatureRegisters features;
  VendorRegisters vendor;
};

EmulatedIidcCamera::EmulatedIidcCamera(FrameSource source, const CameraOptions& options)
: source_(std::move(source))
, options_(options)
, rom_(configRomOf(options.identity))
, registers_(std::make_unique<Registers>(options_))
, thread_([this] { run(); })
{}

EmulatedIidcCamera::~EmulatedIidcCamera()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::optional<std::uint32_t>
EmulatedIidcCamera::read(std::uint64_t address)
{
  if (address % 4 != 0)
    return std::nullopt;
  if (address >= config_rom && address < commands) {
    const auto rom = faults_.rom(rom_);
    const std::uint64_t index = (address - config_rom) / 4;
    if (index < rom.size())
      return rom[index];
    return std::nullopt;
  }
  const std::uint64_t offset = address - commands;
  if (address < commands || offset > 0xFFFFF)
    return std::nullopt;
  const auto command = static_cast<std::uint32_t>(offset);
  if (const auto noise = faults_.ofRegister(command))
    return noise;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!registers_->map.has(command))
    return options_.refuse_unknown ? std::nullopt : std::optional(0xFFFFFFFF);
  const std::uint32_t value = registers_->map.at(command);
  registers_->video.wasRead(command);
  return value;
}

bool
EmulatedIidcCamera::write(std::uint64_t address, std::uint32_t value)
{
  if (address < commands || address - commands > 0xFFFFF || address % 4 != 0)
    return false;
  const auto offset = static_cast<std::uint32_t>(address - commands);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!registers_->vendor.lets(offset))
    return true;
  if (!registers_->map.write(offset, value))
    return !options_.refuse_unknown;
  written(offset, value);
  return true;
}

void
EmulatedIidcCamera::written(std::uint32_t offset, std::uint32_t value)
{
  registers_->video.written(offset);
  registers_->features.written(offset);
  registers_->vendor.written(offset);
  switch (offset) {
  case initialize:
    if (value & on) {
      registers_ = std::make_unique<Registers>(options_);
      stop();
    }
    break;
  case iso_enable:
    if (!(value & on))
      stop();
    else if (!streaming_)
      start();
    break;
  case one_shot:
    if ((value & on) && !streaming_)
      requestShot();
    break;
  case software_trigger:
    registers_->map.set(software_trigger, 0);
    if ((value & on) && streaming_ && registers_->features.triggered())
      requestShot();
    break;
  default:
    changed_.notify_all();
  }
}

void
EmulatedIidcCamera::start()
{
  stop();
  streaming_ = true;
  next_end_ = Clock::now() + ticks(period());
}

void
EmulatedIidcCamera::stop()
{
  streaming_ = false;
  shot_wanted_ = false;
  waiting_.clear();
  ++epoch_;
  changed_.notify_all();
}

void
EmulatedIidcCamera::requestShot()
{
  if (!std::exchange(shot_wanted_, true))
    next_end_ = Clock::now() + ticks(registers_->features.shutter());
  changed_.notify_all();
}

std::optional<CameraFrame>
EmulatedIidcCamera::takeFrame()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.empty())
    return std::nullopt;
  CameraFrame frame = std::move(waiting_.front());
  waiting_.pop_front();
  return frame;
}

std::uint64_t
EmulatedIidcCamera::stream()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return epoch_;
}

void
EmulatedIidcCamera::whenFrameWaits(std::function<void()> listener)
{
  const std::lock_guard<std::mutex> lock(listener_mutex_);
  listener_ = std::move(listener);
}

void
EmulatedIidcCamera::cyclePower()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  registers_ = std::make_unique<Registers>(options_);
  stop();
  frames_ = 0;
}

std::chrono::duration<double>
EmulatedIidcCamera::period() const
{
  const auto setting = registers_->video.setting();
  const std::chrono::duration<double> asked(1 / registers_->features.frameRate());
  return setting ? std::max(setting->period, asked) : asked;
}

void
EmulatedIidcCamera::run()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ends_)
    if (waitForExposure(lock))
      expose(lock);
}

/** \brief Returns true if an exposure ended without being disturbed. */
bool
EmulatedIidcCamera::waitForExposure(std::unique_lock<std::mutex>& lock)
{
  const auto due = [this] {
    const bool runs = streaming_ && !registers_->features.triggered();
    return (shot_wanted_ || runs) && registers_->video.setting();
  };
  changed_.wait(lock, [&] { return ends_ || due(); });
  const std::uint64_t epoch = epoch_;
  const bool disturbed = changed_.wait_until(
      lock, next_end_, [&] { return ends_ || epoch != epoch_ || !due(); });
  return !disturbed;
}

void
EmulatedIidcCamera::expose(std::unique_lock<std::mutex>& lock)
{
  Exposure exposure;
  exposure.setting = *registers_->video.setting();
  exposure.number = frames_++;
  exposure.end = Clock::now();
  const auto frame_period = period();
  exposure.begin =
      exposure.end - ticks(std::min(registers_->features.shutter(), frame_period));
  // A delayed exposure is not made up for by a burst.
  next_end_ = std::max(next_end_ + ticks(frame_period), exposure.end);
  const std::uint64_t epoch = epoch_;

  lock.unlock();
  CameraFrame frame{exposure.number, epoch, source_(exposure), FrameFault::None};
  frame.fault = faults_.ofFrame(exposure.number);
  frame.bytes.resize(exposure.setting.transfer_bytes);
  lock.lock();

  if (epoch != epoch_)
    return;
  if (std::exchange(shot_wanted_, false))
    registers_->map.set(one_shot, 0);
  const bool wrong = frame.fault == FrameFault::WrongCounter;
  registers_->vendor.embed(frame.bytes,
                           cycleTime(exposure.end),
                           static_cast<std::uint32_t>(exposure.number) ^
                               (wrong ? 0xBAD0BAD0 : 0));
  if (frame.fault == FrameFault::Short)
    frame.bytes.resize(frame.bytes.size() / 3 * 2);
  if (faults_.silent() || waiting_.size() >= options_.buffered_frames)
    return;
  waiting_.push_back(std::move(frame));
  lock.unlock();
  {
    const std::lock_guard<std::mutex> listening(listener_mutex_);
    if (listener_)
      listener_();
  }
  lock.lock();
}

} // namespace pcl::acmap::test
