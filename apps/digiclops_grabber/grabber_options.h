#pragma once

#include "active_stereo/stereo_options.h"
#include "line_pattern/pattern_options.h"
#include "tool.h"

#include <cstddef>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief A number, the word `auto`, or what was there before. */
struct NumberOrAuto {
  std::optional<double> number;
  bool is_auto = false;
};

/** \brief What the user asks for. */
struct GrabberOptions {
  bool list = false;
  std::string device; ///< as \ref openUsbBus takes it, or folder of a recording
  std::string rig;    ///< of a camera
  std::string clouds; ///< folder for observations; empty: none
  std::string session;
  bool live = false;

  std::optional<std::size_t> observations;
  std::optional<double> every; ///< seconds between observations
  std::size_t frames = 0;      ///< of a stream; 0: no end
  double seconds = 0;          ///< of a stream; 0: no end

  PatternOptions pattern; ///< patterns may be 0; output and size are not used
  std::string display;    ///< of the projector
  NumberOrAuto settle;    ///< seconds
  bool early = false;

  std::string mode;     ///< `FORMAT:MODE`; empty: by the rig
  double rate = 14;     ///< Hz
  NumberOrAuto shutter; ///< seconds
  NumberOrAuto gain;    ///< dB
  std::string trigger = "off";
  std::string channel_order = "auto";

  StereoOptions stereo;

  /** \brief Whether the device is the folder of a recording. */
  bool
  isRecording() const;

  /** \brief Whether frames are streamed without a projector. */
  bool
  isStream() const
  {
    return !isRecording() && pattern.patterns == 0;
  }

  /** \brief Where the rig stands. */
  std::string
  rigPath() const;
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, GrabberOptions& options);

/** \brief Refuses options that do not go together.
 * \throws UsageError naming them */
void
requireSense(Tool& tool, const GrabberOptions& options);

} // namespace pcl::acmap
