#pragma once

#include "active_stereo/stereo_options.h"
#include "compact_mapping/chain_options.h"
#include "grabbed_camera.h"
#include "line_pattern/pattern_options.h"

#include <filesystem>

namespace CLI {
class App;
}

namespace pcl::acmap {

/** \brief A number, the word `auto`, or the current value. */
struct NumberOrAuto {
  std::optional<double> number;
  bool is_auto = false;
};

/** \brief Options of the user that all tools share which grab frames. */
struct GrabberOptions {
  std::string tool; ///< its name
  bool list = false;

  /** \brief Names of cameras, or the folder of a recording. */
  std::vector<std::string> devices;

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

  std::optional<double> rate; ///< Hz, of a stream
  NumberOrAuto shutter;       ///< seconds
  NumberOrAuto gain;          ///< in the unit of the camera

  /** \brief Is the device the folder of a recording? */
  bool
  isRecording() const
  {
    std::error_code error;
    return devices.size() == 1 && std::filesystem::is_directory(devices.front(), error);
  }

  /** \brief Folder of the recording. */
  const std::string&
  recording() const
  {
    return devices.front();
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
    return isRecording() ? recording() + "/rig.yaml" : rig;
  }
};

/** \brief Descriptions of the common options where the cameras of the tools differ. */
struct CameraTexts {
  std::string list;
  std::string device;
  std::string device_type;
  int max_devices = 1;
  std::string rate;
  std::string default_rate; ///< Hz; empty: told by the description
  std::string gain;
  std::string gain_type; ///< without `|auto`
  double max_gain = 0;

  /** \brief Names of the options that only this kind of camera has, separated by
   * blanks. */
  std::string own_options;
};

/** \brief Adds the common options to the command line.
 * \param[in] add_own adds those of the kind of camera, after the common ones of
 * cameras */
void
addOptions(Tool& tool,
           GrabberOptions& options,
           const CameraTexts& texts,
           const std::function<void(CLI::App&)>& add_own);

/** \brief Refuses options that exclude each other, and places for the results that
 * cannot be used.
 * \throws UsageError, OutputFileException naming them */
void
requireSense(Tool& tool, const GrabberOptions& options, const CameraTexts& texts);

/** \brief Takes observations, or frames, from a camera or a recording: the work of the
 * tools that grab frames.
 * \throws according to the exit codes of their documentation pages */
void
grab(const GrabberOptions& options,
     const GrabbedCameraOpener& opener,
     const RunControls& controls,
     StageLog& log);

} // namespace pcl::acmap
