#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <vector>

namespace pcl::acmap::test {

/** \brief Faults of a frame. */
enum class FrameFault {
  None,
  Short,        ///< its last third is missing
  WrongCounter, ///< a wrong number is embedded
  EmptyEnd,     ///< an empty packet follows it
  Error,        ///< noise on the cable in the middle of it
  Stall,        ///< the endpoint halts in the middle of it
  Unplug        ///< the cable is unplugged in the middle of it
};

/** \brief Faults of a control transfer. */
enum class ControlFault { None, Stall, Error, TimeOut };

/** \brief Faults of the configuration ROM. */
enum class RomFault {
  None,
  Cut,       ///< ends after three quadlets
  Zero,      ///< zeros only
  WrongBus,  ///< not "1394"
  FarUnit,   ///< the unit directory is outside
  FarLeaves, ///< the texts are outside
  HugeLeaf,  ///< a text claims to be longer than the ROM
  Endless    ///< endless chain of directories
};

/** \brief Faults that can be switched on; may be called from any thread. */
class CameraFaults {
public:
  void
  failFrame(FrameFault fault, std::uint64_t number);

  /** \brief Sets a fault for this and all following frames. */
  void
  failFramesFrom(FrameFault fault, std::uint64_t number);

  /** \brief Sends no frames, but still answers. */
  void
  setSilent(bool silent);

  /** \brief The next \a count reads and writes of registers fail. */
  void
  failControl(ControlFault fault, std::size_t count);

  /** \brief Reads of the command register at this offset return this value. */
  void
  overrideRegister(std::uint32_t offset, std::uint32_t value);

  /** \brief Reads of all command registers return noise. */
  void
  overrideAllRegisters(std::uint64_t seed);

  void
  breakRom(RomFault fault);

  /** \brief Switches all faults off. */
  void
  heal();

  // Called by the camera.
  FrameFault
  ofFrame(std::uint64_t number) const;
  bool
  silent() const;
  ControlFault
  takeControl();
  std::optional<std::uint32_t>
  ofRegister(std::uint32_t offset);
  std::vector<std::uint32_t>
  rom(std::vector<std::uint32_t> whole) const;

private:
  mutable std::mutex mutex_;
  std::map<std::uint64_t, FrameFault> frames_;
  std::map<std::uint64_t, FrameFault> frames_from_;
  bool silent_ = false;
  ControlFault control_ = ControlFault::None;
  std::size_t controls_left_ = 0;
  std::map<std::uint32_t, std::uint32_t> registers_;
  std::optional<std::mt19937_64> noise_;
  RomFault rom_ = RomFault::None;
};

} // namespace pcl::acmap::test
