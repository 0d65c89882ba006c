#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <vector>

namespace pcl::acmap::test {

/** \brief What goes wrong with a frame. */
enum class FrameFault {
  None,
  Short,        ///< its last third is missing
  WrongCounter, ///< another number is embedded
  EmptyEnd,     ///< a packet without bytes follows it
  Error,        ///< noise on the cable in the middle of it
  Stall,        ///< the endpoint halts in the middle of it
  Unplug        ///< the cable goes in the middle of it
};

/** \brief What goes wrong with a control transfer. */
enum class ControlFault { None, Stall, Error, TimeOut };

/** \brief What is wrong with the configuration ROM. */
enum class RomFault {
  None,
  Cut,       ///< ends after three quadlets
  Zero,      ///< nothing but zeros
  WrongBus,  ///< not "1394"
  FarUnit,   ///< the unit directory lies outside
  FarLeaves, ///< so do the texts
  HugeLeaf,  ///< a text says that it is longer than the ROM
  Endless    ///< never ends, all directories
};

/** \brief Switches for what may go wrong; from any thread. */
class CameraFaults {
public:
  void
  failFrame(FrameFault fault, std::uint64_t number);

  /** \brief This frame and all that follow. */
  void
  failFramesFrom(FrameFault fault, std::uint64_t number);

  /** \brief No frames, though the camera answers. */
  void
  setSilent(bool silent);

  /** \brief The next \a count reads and writes of registers fail. */
  void
  failControl(ControlFault fault, std::size_t count);

  /** \brief Reads of this offset from the command registers give this value. */
  void
  overrideRegister(std::uint32_t offset, std::uint32_t value);

  /** \brief Reads of all command registers give noise. */
  void
  overrideAllRegisters(std::uint64_t seed);

  void
  breakRom(RomFault fault);

  /** \brief From here on all goes well. */
  void
  heal();

  // What the camera asks.
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
