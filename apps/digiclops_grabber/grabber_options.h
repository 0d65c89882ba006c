#pragma once

#include "active_stereo/stereo_options.h"
#include "compact_mapping/chain_options.h"
#include "line_pattern/pattern_options.h"

#include <pcl/acquisition/channel_order.h>

#include <filesystem>

namespace pcl::acmap {

/** \brief A number, the word `auto`, or the current value. */
struct NumberOrAuto {
  std::optional<double> number;
  bool is_auto = false;
};

/** \brief Options of the user. */
struct GrabberOptions {
  bool list = false;
  std::string device; ///< name for \ref openUsbBus, or folder of a recording
  std::string rig;    ///< of a camera
  std::string clouds; ///< folder for observations; empty: not written
  std::string session;
  ChainOptions
      map; ///< with the options of the stereo; without a map its output is empty
  bool live = false;

  std::optional<std::size_t> observations;
  std::optional<double> every; ///< seconds between observations
  std::size_t frames = 0;      ///< of a stream; 0: no end
  double seconds = 0;          ///< of a stream; 0: no end

  /** \brief The number of patterns may be 0; output and size are not used. */
  PatternOptions pattern;
  std::string display; ///< display of the projector
  NumberOrAuto settle; ///< seconds
  bool early = false;
  bool selects = false; ///< patterns that distinguish most

  std::string mode;     ///< `FORMAT:MODE`; empty: chosen by the rig
  double rate = 14;     ///< Hz
  NumberOrAuto shutter; ///< seconds
  NumberOrAuto gain;    ///< dB
  std::string trigger = "off";
  std::string channel_order = "auto";

  /** \brief Is the device the folder of a recording? */
  bool
  isRecording() const
  {
    std::error_code error;
    return !device.empty() && std::filesystem::is_directory(device, error);
  }

  /** \brief Are frames streamed without a projector? */
  bool
  isStream() const
  {
    return !isRecording() && pattern.patterns == 0;
  }

  /** \brief Path of the file of the rig. */
  std::string
  rigPath() const
  {
    return isRecording() ? device + "/rig.yaml" : rig;
  }
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, GrabberOptions& options);

/** \brief Refuses options that exclude each other, and places for the results that
 * cannot be used.
 * \throws UsageError, OutputFileException naming them */
void
requireSense(Tool& tool, const GrabberOptions& options);

/** \brief Reads `r,h,v` in any order, as letters or words.
 * \return nothing for `auto`
 * \throws UsageError for anything else */
std::optional<ChannelOrder>
channelOrderOf(const std::string& text);

/** \brief Prints one line per camera on the USB.
 * \throws NothingFound when there is none
 * \throws CameraException when USB is not available */
void
listCameras(StageLog& log);

/** \brief Takes observations, or frames, from a camera or a recording: the work of
 * pcl_digiclops_grabber.
 * \throws according to the exit codes of its documentation page */
void
grab(const GrabberOptions& options, const RunControls& controls, StageLog& log);

} // namespace pcl::acmap
