#include "rectification_options.h"

#include "pose_options.h"
#include "reading_options.h"
#include "setter_option.h"

#include <pcl/pipeline/input_kind.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

using Rectification = EntropyRectification<PointNormal>;

void
addInputs(Tool& tool, RectificationOptions& options)
{
  CLI::App& app = tool.options();
  const auto takeScans = [&options](const std::string& path) {
    options.log = path;
    options.stage.setBinSize(Rectification().getBinSize()); // before --bin
  };
  CLI::Option* const folder =
      app.add_option_function<std::string>(
             "posed",
             [&options, takeScans](const std::string& path) {
               if (inputKindOf(path) == InputKind::Bag)
                 takeScans(path);
               else
                 options.folder = path;
             },
             "Folder of observation PCDs with their poses, or a bag of ROS with laser "
             "scans and odometry")
          ->type_name("POSED_DIR|BAG");
  CLI::Option* const log =
      app.add_option_function<std::string>(
             "--carmen",
             takeScans,
             "Laser log of CARMEN instead, also as .gz; its FLASER or ROBOTLASER1 "
             "messages are taken, in metres")
          ->type_name("LOG")
          ->excludes(folder);
  app.add_option("-o,--output", options.output, "Folder for poses, map and pictures")
      ->type_name("OUT_DIR")
      ->required();
  addSetter<double>(
      app,
      "--laser-fov",
      [&options](double degrees) {
        if (!(degrees > 0 && degrees <= 360))
          throw BadArgument("it must be within (0, 360] degrees");
        options.laser_sweep = degrees * M_PI / 180;
      },
      "Degrees from the first to the last direction of FLASER messages [default: what "
      "PARAM laser_front_laser_fov of the log states, else 180]",
      "DEG")
      ->needs(log);
  addSensorPose(app, options.bag);
  app.add_option(
         "--every", options.bag.every, "Take only each Nth scan of the log or the bag")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  app.add_flag("--observations",
               options.write_observations,
               "Write the observations too, each with its new pose, so that OUT_DIR "
               "goes into the next tool")
      ->excludes(log);
  addPoseReading(app, options.poses);
  for (const char* name : {"--pose-convention", "--pose-scale"})
    app.get_option(name)->excludes(log);
  addScale(app, tool.reader());
  app.get_option("--scale")->excludes(log);
  addUp(app, tool.reader(), "; the map is turned until the nearest axis points there");
}

void
addOdometryNoise(CLI::App& app, RectificationOptions& options)
{
  const auto take = [&options](const std::vector<double>& values) {
    constexpr double degree = 3.14159265358979323846 / 180;
    options.stage.setOdometryNoise({values[0], 0, values[1] * degree, 0});
  };
  addSetter<std::vector<double>>(
      app,
      "--odometry-noise",
      take,
      "What the way from a pose to the next errs by, one standard deviation, metres "
      "and degrees, as pcl_visual_egomotion tells it [default: that of wheels, 5 mm "
      "+ 3 % and 0.34 degrees + 2 %]",
      "M DEG")
      ->expected(2);
}

} // namespace

void
addRectificationChoices(Tool& tool, RectificationOptions& options)
{
  CLI::App& app = tool.options();
  addSetterChoice(
      app,
      "--mode",
      options.stage,
      &Rectification::setMode,
      &Rectification::getMode,
      {{"guarded", RectificationMode::Guarded}, {"paper", RectificationMode::Paper}},
      "guarded: descent, taken only where independent evidence agrees; paper: the "
      "paper's voting, taken as it comes");
  addSetter(app,
            "--bin",
            options.stage,
            &Rectification::setBinSize,
            &Rectification::getBinSize,
            "Edge of the entropy's finest bins, metres",
            "M")
      ->default_str("0.05, of a log 0.1");
  addSetter<double>(
      app,
      "--mu",
      [&options](double mu) { options.stage.setProjectionWeight(mu); },
      "mu of Eq. 3, the weight of the entropies along the main directions of the "
      "building; it harms where walls are neither parallel nor orthogonal",
      "M")
      ->default_str("0; with --mode paper 0.1");
  addOdometryNoise(app, options);
  tool.addSeed(options.stage.getSeed(),
               [&options](std::uint64_t seed) { options.stage.setSeed(seed); });
}

void
requireSense(Tool& tool, const RectificationOptions& options)
{
  const auto refuse = [&](const char* option, const std::string& why) {
    if (tool.options().get_option(option)->count() > 0)
      throw UsageError(option + why);
  };
  const bool is_bag = inputKindOf(options.input()) == InputKind::Bag;
  if (options.log.empty())
    refuse("--every", std::string(" is for logs and bags"));
  if (!is_bag)
    refuse("--sensor-pose", std::string(" is for bags"));
  if (is_bag)
    for (const char* option : {"--6dof",
                               "--no-6dof",
                               "--observations",
                               "--scale",
                               "--pose-convention",
                               "--pose-scale"})
      refuse(option, std::string(" is for a folder of observations"));
  const std::optional<double>& smoothing = options.stage.getSmoothing();
  if (!smoothing)
    return;
  if (options.stage.getMode() != RectificationMode::Paper)
    throw UsageError("--smoothing needs --mode paper");
  constexpr double max_bins = 100;
  if (*smoothing > max_bins * options.stage.getBinSize())
    throw UsageError("--smoothing is more than 100 bins");
}

void
addOptions(Tool& tool, RectificationOptions& options)
{
  addInputs(tool, options);
  addRectificationChoices(tool, options);
  CLI::Option* const free = tool.options().add_flag_callback(
      "--6dof",
      [&options] {
        options.six_degrees = true;
        options.measures_path = false;
      },
      "Then adjust all poses in six degrees of freedom, so that planes which several "
      "observations see become thin [default: if the poses tilt, as those of a hand]");
  free->excludes("--carmen");
  tool.options()
      .add_flag_callback(
          "--no-6dof",
          [&options] { options.measures_path = false; },
          "Do not: the poses are those of a robot on a floor")
      ->excludes("--carmen")
      ->excludes(free);
  addSetter<double>(
      tool.options(),
      "--smoothing",
      [&options](double sigma) { options.stage.setSmoothing(sigma); },
      "With --mode paper, standard deviation sigma_XZ of the Gaussian that "
      "smooths the bins, metres; 0 for none",
      "M")
      ->default_str("the bin size");
  tool.addThreads();
}

} // namespace pcl::acmap
