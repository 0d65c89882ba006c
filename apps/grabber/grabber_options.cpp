#include "grabber_options.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace pcl::acmap {

namespace {

constexpr double longest_wait = 86400; // seconds, one day
// maximum for fusion, with a shot without a pattern
constexpr std::uint32_t max_patterns = 255;

CLI::Option*
addNumberOrAuto(CLI::App& app,
                const std::string& name,
                NumberOrAuto& target,
                double minimum,
                double maximum,
                const std::string& description)
{
  const auto fault = [minimum, maximum](const std::string& text) {
    double number = 0;
    const bool fits = text == "auto" || (CLI::detail::lexical_cast(text, number) &&
                                         number >= minimum && number <= maximum);
    return fits ? std::string()
                : text + " is neither auto nor a number from " + shortNumber(minimum) +
                      " to " + shortNumber(maximum);
  };
  return app
      .add_option_function<std::string>(
          name,
          [&target](const std::string& text) {
            target.is_auto = text == "auto";
            if (!target.is_auto)
              target.number = std::stod(text);
          },
          description)
      ->default_str("")
      ->check(CLI::Validator(fault, ""));
}

void
addPlaces(CLI::App& app, GrabberOptions& options, const CameraTexts& texts)
{
  app.add_flag("--list", options.list, texts.list);
  app.add_option("--device", options.devices, texts.device)
      ->type_name(texts.device_type)
      ->expected(1, texts.max_devices)
      ->default_str("");
  app.add_option("--rig",
                 options.rig,
                 "Rig of the camera; with its cameras as they are built, frames are "
                 "recorded raw and rectified for the clouds")
      ->type_name("RIG.yaml");
  app.add_option("--pcd", options.clouds, "Folder for observations as point clouds")
      ->type_name("DIR");
  app.add_option("-o,--output", options.session, "Folder for the frames, a raw session")
      ->type_name("SESSION");
  app.add_option(
         "--map",
         options.map.output,
         "Folder for a compact map, which is computed while observations arrive; "
         "the camera moves level, as on a robot")
      ->type_name("DIR");
  app.add_option(
         "--extend",
         options.map.earlier,
         "With --map: an earlier map, which the observations extend if both have "
         "seen the same place")
      ->type_name("MAP_DIR");
  app.add_flag("--live",
               options.live,
               "Show images, last cloud, and with --map the plan so far, in a window; "
               "needs an X server");
}

void
addAmounts(CLI::App& app, GrabberOptions& options)
{
  app.add_option("--observations",
                 options.observations,
                 "How many observations [default: 1, of a recording all]")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  app.add_option(
         "--every",
         options.every,
         "From the begin of an observation to that of the next, seconds "
         "[default: Enter begins it where input is a terminal, else it comes at "
         "once]")
      ->type_name("SECONDS")
      ->default_str("")
      ->check(numberWithin(0, longest_wait).description(""));
  app.add_option("--frames", options.frames, "With --patterns 0: stop after N frames")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  app.add_option("--seconds", options.seconds, "With --patterns 0: stop after so long")
      ->type_name("SECONDS")
      ->default_str("")
      ->check(positiveNumber(30 * longest_wait).description(""));
}

void
addProjector(Tool& tool, GrabberOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("--patterns",
                 options.pattern.patterns,
                 "Patterns of an observation; 0 for no projector: a stream of frames")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{0}, max_patterns).description(""));
  addPatternLook(tool, options.pattern);
  app.add_option("--monitor",
                 options.pattern.monitor,
                 "The projector's monitor, counted from 0")
      ->type_name("K")
      ->check(CLI::Range(0, 1000).description(""));
  app.add_option("--display",
                 options.display,
                 "The projector's X server [default: DISPLAY of the environment]")
      ->type_name("NAME")
      ->default_str("");
  addNumberOrAuto(
      app,
      "--settle",
      options.settle,
      0.0,
      10.0,
      "From a pattern's acknowledgement to its shot, seconds; auto measures "
      "what is needed [default: 0.1]")
      ->type_name("SECONDS|auto");
  app.add_flag(
      "--select",
      options.selects,
      "Choose patterns that distinguish most among many, so that fewer suffice; "
      "takes some seconds at the start");
  app.add_flag("--early",
               options.early,
               "End an observation when a further pattern would not help");
}

void
addCamera(CLI::App& app, GrabberOptions& options, const CameraTexts& texts)
{
  app.add_option("--rate", options.rate, texts.rate)
      ->type_name("HZ")
      ->default_str(texts.default_rate)
      ->check(positiveNumber(1000).description(""));
  addNumberOrAuto(app,
                  "--shutter",
                  options.shutter,
                  1e-6,
                  60.0,
                  "Exposure, seconds [default: as the camera is set]")
      ->type_name("SECONDS|auto");
  addNumberOrAuto(
      app, "--gain", options.gain, -texts.max_gain, texts.max_gain, texts.gain)
      ->type_name(texts.gain_type + "|auto");
}

// names of options, for refuse
constexpr const char* for_projector = "--lines --grey --min-angle --seed --monitor "
                                      "--display --settle --select --early --every";
constexpr const char* for_stream = "--frames --seconds";
constexpr const char* for_camera = "--rig --patterns --rate --shutter --gain";

/** \brief Refuses options, named with blanks between them, if they are given. */
void
refuse(const CLI::App& app, const std::string& names, const std::string& reason)
{
  for (const std::string& name : CLI::detail::split(names, ' '))
    if (app.count(name) > 0)
      throw UsageError(name + " " + reason);
}

void
requireSenseOfCamera(const CLI::App& app, const GrabberOptions& options)
{
  if (options.rig.empty())
    throw UsageError("--rig is needed, the rig of the camera" +
                     (options.devices.empty() ? ""
                                              : "; " + options.devices.front() +
                                                    " is no folder with a recording"));
  if (!options.isStream()) {
    refuse(app, for_stream, "is for a stream of frames, --patterns 0");
    return;
  }
  for (const char* const names : {for_projector, "--observations"})
    refuse(app, names, "is for patterns, --patterns 0 has none");
  for (const auto& [name, output] :
       {std::pair("--pcd", &options.clouds), std::pair("--map", &options.map.output)})
    if (!output->empty())
      throw UsageError(std::string(name) + " needs patterns, --patterns 0 has none");
}

/** \brief Refuses outputs that would mix with each other or with the recording. */
void
requirePlaces(const GrabberOptions& options)
{
  namespace fs = std::filesystem;
  const auto same = [](const std::string& a, const std::string& b) {
    std::error_code error;
    return !a.empty() && !b.empty() &&
           fs::weakly_canonical(fs::absolute(a) / "", error) ==
               fs::weakly_canonical(fs::absolute(b) / "", error);
  };
  for (const std::string& output : {options.clouds, options.map.output})
    if (same(output, options.session))
      throw UsageError(output + ": is to hold the session, too");
  if (options.isRecording())
    for (const std::string& output :
         {options.clouds, options.session, options.map.output})
      if (same(output, options.recording()))
        throw UsageError(output + ": is the recording's folder, too");
}

} // namespace

void
addOptions(Tool& tool,
           GrabberOptions& options,
           const CameraTexts& texts,
           const std::function<void(CLI::App&)>& add_own)
{
  CLI::App& app = tool.options();
  addPlaces(app, options, texts);
  addAmounts(app, options);
  addProjector(tool, options);
  addCamera(app, options, texts);
  add_own(app);
  addStereoChoices(app, options.map.stereo);
  tool.addThreads();
}

void
requireSense(Tool& tool, const GrabberOptions& options, const CameraTexts& texts)
{
  const CLI::App& app = tool.options();
  for (const char* const name : {"--rig", "--pcd", "--output", "--map"})
    if (app.count(name) > 0 && app.get_option(name)->as<std::string>().empty())
      throw UsageError(std::string(name) + " names nothing");
  for (const std::string& device : options.devices)
    if (device.empty())
      throw UsageError("--device names nothing");
  if (options.list) {
    refuse(app, "--pcd --output --map --extend --live", "makes no sense with --list");
    return;
  }
  if (options.clouds.empty() && options.session.empty() && options.map.output.empty() &&
      !options.live)
    throw UsageError(
        "nothing to do: --pcd DIR, -o SESSION, --map DIR or --live is needed");
  if (!options.map.earlier.empty() && options.map.output.empty())
    throw UsageError("--extend is for a --map");
  if (!options.clouds.empty() && !options.map.output.empty())
    throw UsageError("--pcd: a --map keeps the observations that it is made of, in its "
                     "stages/replay");
  if (options.isRecording()) {
    const std::string reason =
        "is for a camera, " + options.recording() + " is a recording";
    for (const std::string& names : {std::string("--rig --every"),
                                     for_camera + (" " + texts.own_options),
                                     std::string(for_stream),
                                     std::string(for_projector)})
      refuse(app, names, reason);
  }
  else
    requireSenseOfCamera(app, options);
  requireStereoSense(options.map.stereo);
  requirePlaces(options);
  tool.requireReportWritable({options.rigPath()});
}

} // namespace pcl::acmap
