#include "camera_faults.h"

#include <algorithm>
#include <iterator>

namespace pcl::acmap::test {

using Lock = std::lock_guard<std::mutex>;

void
CameraFaults::failFrame(FrameFault fault, std::uint64_t number)
{
  const Lock lock(mutex_);
  frames_[number] = fault;
}

void
CameraFaults::failFramesFrom(FrameFault fault, std::uint64_t number)
{
  const Lock lock(mutex_);
  frames_from_[number] = fault;
}

void
CameraFaults::setSilent(bool silent)
{
  const Lock lock(mutex_);
  silent_ = silent;
}

void
CameraFaults::failControl(ControlFault fault, std::size_t count)
{
  const Lock lock(mutex_);
  control_ = fault;
  controls_left_ = count;
}

void
CameraFaults::overrideRegister(std::uint32_t offset, std::uint32_t value)
{
  const Lock lock(mutex_);
  registers_[offset] = value;
}

void
CameraFaults::overrideAllRegisters(std::uint64_t seed)
{
  const Lock lock(mutex_);
  noise_.emplace(seed);
}

void
CameraFaults::breakRom(RomFault fault)
{
  const Lock lock(mutex_);
  rom_ = fault;
}

void
CameraFaults::heal()
{
  const Lock lock(mutex_);
  frames_.clear();
  frames_from_.clear();
  silent_ = false;
  controls_left_ = 0;
  registers_.clear();
  noise_.reset();
  rom_ = RomFault::None;
}

FrameFault
CameraFaults::ofFrame(std::uint64_t number) const
{
  const Lock lock(mutex_);
  if (const auto one = frames_.find(number); one != frames_.end())
    return one->second;
  const auto after = frames_from_.upper_bound(number);
  return after == frames_from_.begin() ? FrameFault::None : std::prev(after)->second;
}

bool
CameraFaults::silent() const
{
  const Lock lock(mutex_);
  return silent_;
}

ControlFault
CameraFaults::takeControl()
{
  const Lock lock(mutex_);
  if (controls_left_ == 0)
    return ControlFault::None;
  --controls_left_;
  return control_;
}

std::optional<std::uint32_t>
CameraFaults::ofRegister(std::uint32_t offset)
{
  const Lock lock(mutex_);
  if (const auto one = registers_.find(offset); one != registers_.end())
    return one->second;
  if (!noise_)
    return std::nullopt;
  return static_cast<std::uint32_t>((*noise_)());
}

std::vector<std::uint32_t>
CameraFaults::rom(std::vector<std::uint32_t> whole) const
{
  constexpr std::size_t unit_entry = 8;  // of the root directory
  constexpr std::size_t leaf_entry = 15; // of the unit dependent directory
  const Lock lock(mutex_);
  switch (rom_) {
  case RomFault::None:
    break;
  case RomFault::Cut:
    whole.resize(3);
    break;
  case RomFault::Zero:
    std::fill(whole.begin(), whole.end(), 0);
    break;
  case RomFault::WrongBus:
    whole.at(1) = 0x31323334;
    break;
  case RomFault::FarUnit:
    whole.at(unit_entry) |= 0x00FFFFFF;
    break;
  case RomFault::FarLeaves:
    whole.at(leaf_entry) |= 0x00FFFFFF;
    whole.at(leaf_entry + 1) |= 0x00FFFFFF;
    break;
  case RomFault::HugeLeaf:
    whole.at(leaf_entry + 2) |= 0xFFFF0000;
    break;
  case RomFault::Endless:
    whole.resize(4096, 0xD1000001);
    break;
  }
  return whole;
}

} // namespace pcl::acmap::test
