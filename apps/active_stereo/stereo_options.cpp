#include "stereo_options.h"

#include "setter_option.h"

#include <pcl/core/output_folder.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

void
addRig(CLI::App& app, CLI::Option* reference, StereoOptions& options)
{
  app.add_option("--rig",
                 options.rig,
                 "The rig that the images are of: a rig.yaml, or a calibration by "
                 "Kalibr, ROS, OpenCV, Middlebury, KITTI, ORB-SLAM and others; two "
                 "files where each camera has its own, the reference first")
      ->type_name("RIG")
      ->expected(1, 2)
      ->default_str("")
      ->needs(reference);
  app.add_option("--rig-cameras",
                 options.rig_cameras,
                 "Reference and neighbour of RIG, where it has more than two cameras")
      ->type_name("NAME,NAME")
      ->default_str("")
      ->needs(reference);
  app.add_option("--baseline",
                 options.baseline,
                 "Place of the neighbour along x (right), metres: negative for one on "
                 "the left; along y (down) for one above or below [default: RIG's]")
      ->type_name("M")
      ->default_str("")
      ->check(numberWithin(-100, 100).description(""))
      ->needs(reference);
  auto* const rectify = app.add_flag_callback(
      "--rectify",
      [&] { options.rectify = true; },
      "The images are as the cameras gave them, to be rectified by the cameras in RIG "
      "[default: what RIG is for]");
  rectify->needs(reference);
  app.add_flag_callback(
         "--rectified", [&] { options.rectify = false; }, "The images are rectified")
      ->needs(reference)
      ->excludes(rectify);
}

void
addLists(CLI::App& app, StereoOptions& options)
{
  const auto images =
      [&](const char* name, std::vector<std::string>& list, const char* purpose) {
        return app.add_option(name, list, purpose)
            ->type_name("IMG..")
            ->default_str("")
            ->check(imageName());
      };
  CLI::Option* const reference = images(
      "--reference",
      options.images.reference,
      "In place of a session: images of the reference view, one per pattern; PNG, "
      "JPEG, PGM or PPM. One image per camera is matched without a pattern "
      "(passive stereo), unless --active is given");
  images("--horizontal",
         options.images.horizontal,
         "Of its neighbour in the row: the same shots in the same order; a neighbour "
         "without images is not used")
      ->needs(reference);
  images(
      "--vertical", options.images.vertical, "Of its neighbour in the column, as above")
      ->needs(reference);
  addRig(app, reference, options);
  app.add_flag("--active",
               options.active,
               "One image per camera: it was taken under a pattern. Several images "
               "always are")
      ->needs(reference);
  app.add_option("--color",
                 options.settings.color,
                 "Image of the reference view with the projector off, for the colours "
                 "[default: the mean of the shots]")
      ->type_name("IMG")
      ->needs(reference)
      ->check(imageName());
}

void
requireSenseOfInput(const StereoOptions& options)
{
  const TrinocularImageLists& images = options.images;
  if (!options.session.empty() && !images.reference.empty())
    throw UsageError(options.session +
                     ": a session or --reference is needed, not both");
  if (options.session.empty() && images.reference.empty())
    throw UsageError("a session is needed, or images (--reference)");
  requireStereoSense(options);
  if (!options.hasLists())
    return;
  if (options.settings.unlit)
    throw UsageError("--unlit is for a session; one image per camera is matched as "
                     "passive stereo unless --active is given");
  if (options.active && !options.hasOneShot())
    throw UsageError("--active is for one image per camera; several images per camera "
                     "are always matched as shots under patterns");
  if (options.has_method && options.hasOneShot())
    throw UsageError("--method says how shots are fused; with one image per camera "
                     "there is nothing to fuse");
  if (!options.settings.color.empty() && options.isPassive())
    throw UsageError("--color is for shots under patterns; with one image per camera "
                     "the colours are those of --reference, unless --active says that "
                     "it was taken under a pattern");
  if (options.rig.empty() || options.rig.front().empty())
    throw UsageError("--reference needs --rig, the rig of the images");
  if (options.baseline == 0.0)
    throw UsageError("--baseline 0 would be no neighbour");
  if (images.horizontal.empty() && images.vertical.empty())
    throw UsageError("--horizontal or --vertical is needed, or both");
  if (!options.poses.empty())
    throw UsageError("--poses are those of a session's observations; images make one");
}

} // namespace

CalibratedRig
StereoOptions::rigOfLists() const
{
  RigImages stated;
  stated.are_raw = rectify;
  stated.baseline = baseline;
  if (!rig_cameras.empty()) {
    stated.cameras = CLI::detail::split(rig_cameras, ',');
    if (stated.cameras.size() != 2)
      throw UsageError("--rig-cameras: '" + rig_cameras.substr(0, 40) +
                       "' are not two names with a comma between them");
  }
  return loadRigOfImages(rig, images, std::move(stated));
}

SessionSettings
StereoOptions::sessionSettings(unsigned threads) const
{
  SessionSettings chosen = settings;
  chosen.method = disparityFusionMethod(method);
  chosen.passive = isPassive();
  chosen.rig = rigPath();
  if (hasLists())
    chosen.rectify = false;
  chosen.keeps_baseline = baseline.has_value();
  chosen.skip_broken = !hasLists();
  chosen.threads = threads;
  return chosen;
}

void
addStereoChoices(CLI::App& app, StereoOptions& options)
{
  addChoice<std::string>(
      app,
      "--method",
      options.method,
      {{"spacetime", "spacetime"},
       {"median", "median"},
       {"statistical", "statistical"}},
      "how shots are fused: spacetime (all at once), median (of the shots' own "
      "disparities, as the paper) or statistical (mean of those that agree)")
      ->each([&](const std::string&) { options.has_method = true; });
  addSetter(
      app,
      "--min-depth",
      options.settings.projection,
      &DisparityBackProjection::setMinimumDepth,
      &DisparityBackProjection::getMinimumDepth,
      "Depth from which on points are searched for, metres; nearer ones take longer",
      "M");
  addSetter(app,
            "--max-depth",
            options.settings.projection,
            &DisparityBackProjection::setMaximumDepth,
            &DisparityBackProjection::getMaximumDepth,
            "Depth up to which points are searched for, metres",
            "M");
  addSetter<double>(
      app,
      "--min-correlation",
      [&](double least) { options.settings.matching.setCorrelationThreshold(least); },
      "Least correlation (ZNCC) of a match, -1 to 1 [default: by the number of "
      "shots, -1 without a pattern]",
      "C");
  addSetter<double>(
      app,
      "--min-texture",
      [&](double least) { options.settings.matching.setPeakFilter(least); },
      "Least standard deviation of a pixel's grey levels over the shots, or, with "
      "one or two shots, over the pixels around it, 0 to 128: what the projector "
      "does not reach has less [default: by the number of shots, 0 without a "
      "pattern]",
      "L");
}

void
addUnlit(CLI::App& app, StereoOptions& options)
{
  app.add_flag("--unlit",
               options.settings.unlit,
               "Passive stereo: match the first shot without projected light of each "
               "observation, instead of those under patterns");
}

void
addOptions(Tool& tool, StereoOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("session", options.session, "Raw session to read")
      ->type_name("SESSION_DIR");
  app.add_option("-o,--output", options.output, "Folder for the observations")
      ->type_name("OUT_DIR")
      ->required();
  addLists(app, options);
  addStereoChoices(app, options);
  addUnlit(app, options);
  app.add_flag("--disparity",
               options.disparity,
               "Write disparities too, as PFM and as pictures; image lists always do");
  app.add_option("--poses",
                 options.poses,
                 "Known poses of a session's observations, TUM's form, one row each "
                 "[default: none, VIEWPOINT is the camera itself]")
      ->type_name("TRAJECTORY.txt")
      ->check(
          [](const std::string& path) {
            return std::string(path.empty() ? "a trajectory without a name" : "");
          },
          "");
  tool.addThreads();
}

void
requireStereoSense(const StereoOptions& options)
{
  if (options.settings.unlit && options.has_method)
    throw UsageError("--method says how shots under patterns are fused; with --unlit "
                     "there is nothing to fuse");
  const double nearest = options.settings.projection.getMinimumDepth();
  const double farthest = options.settings.projection.getMaximumDepth();
  if (nearest >= farthest)
    throw UsageError("--min-depth " + shortNumber(nearest) +
                     " is not below --max-depth " + shortNumber(farthest));
}

void
requireSense(const Tool& tool, const StereoOptions& options)
{
  requireSenseOfInput(options);
  // the report may be in this folder, which exists during the run
  const OutputFolder folder(options.output);
  if (!options.hasLists() && folder.holds(options.session + "/any"))
    throw UsageError(options.output + ": is the session's folder, too");
  std::vector<std::string> inputs = options.rig;
  inputs.insert(inputs.end(),
                {options.rigPath(), options.poses, options.settings.color});
  for (const auto& list :
       {options.images.reference, options.images.horizontal, options.images.vertical})
    inputs.insert(inputs.end(), list.begin(), list.end());
  tool.requireReportWritable(inputs);
}

} // namespace pcl::acmap
