#include "chain_options.h"

#include "output_target.h"
#include "pose_options.h"
#include "reading_options.h"

#include <pcl/pipeline/input_kind.h>
#include <pcl/texture/map_page.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>

namespace pcl::acmap {

namespace {

const std::vector<std::string> all_formats = {"html", "ifc", "svg", "dxf", "geojson"};

/** \brief Why a format cannot be written; empty if it can. */
std::string
faultOfMapFormat(const std::string& format)
{
  return format == "html" && !hasMapPage()
             ? "html: this acmap was built without the modules of map.html "
               "(ACMAP_PAGE_MODULES)"
             : "";
}

/** \brief Adds options to a group of the help. */
void
inGroup(Tool& tool, const char* group, const std::function<void()>& add)
{
  const std::size_t before = tool.options().get_options().size();
  add();
  const std::vector<CLI::Option*> all = tool.options().get_options();
  for (std::size_t i = before; i < all.size(); ++i)
    all[i]->group(group);
}

void
addSequenceOptions(Tool& tool, ChainOptions& options)
{
  CLI::App& app = tool.options();
  inGroup(tool, stereo_group, [&] {
    addStereoChoices(app, options.stereo);
    addUnlit(app, options.stereo);
    app.add_flag(
        "--as-recorded",
        options.as_recorded,
        "Replay the session at the pace of its recording and map it meanwhile, as "
        "with a camera; tells how long the map takes after the last shot. Keeps "
        "no stages for later runs");
    app.add_flag("--live",
                 options.live,
                 "With --as-recorded: show the newest view and the plan so far in a "
                 "window; needs an X server");
    app.add_option("--poses",
                   options.stereo.poses,
                   "Known poses of the session's observations, TUM's form, one row "
                   "each, in place of egomotion")
        ->type_name("TRAJECTORY.txt");
  });
  inGroup(tool, recording_group, [&] {
    app.add_option("--every", options.bag.every, "Take only each Nth image or cloud")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  });
  inGroup(tool, bag_group, [&] { addSensorPose(app, options.bag); });
  inGroup(tool, rgbd_group, [&] {
    addNoPoses(app, options.rgbd);
    addRgbdCameras(app, options.rgbd);
    addStampGap(app, options.rgbd);
  });
  inGroup(tool, poses_group, [&] { addPoseReading(app, options.poses); });
  inGroup(tool, egomotion_group, [&] { addMotionChoices(app, options.egomotion); });
  app.get_option("--6dof")
      ->description(
          "The camera moves freely, as in a hand: poses are estimated in six "
          "degrees of freedom, and then adjusted so that planes which several "
          "observations see become thin [default: found from the poses, or from the "
          "first "
          "motions]")
      ->group(motion_group);
  app.get_option("--no-6dof")->group(motion_group);
  inGroup(tool, motion_group, [&] {
    app.add_option(
           "--extend",
           options.earlier,
           "Earlier map of observations: the new ones extend it, if both have seen "
           "the same place")
        ->type_name("MAP_DIR");
  });
  inGroup(tool, rectification_group, [&] {
    app.add_flag_callback(
        "--no-rectification",
        [&options] { options.rectifies = false; },
        "Take the poses as they come");
    addRectificationChoices(tool, options.rectification);
  });
}

void
addMapOptions(Tool& tool, ChainOptions& options)
{
  CLI::App& app = tool.options();
  inGroup(tool, map_group, [&] {
    addPlaneChoices(tool, options.planes);
    addTextureOptions(tool, options.texture);
    app.add_flag_callback(
        "--no-details",
        [&options] { options.max_detail_bytes = 0; },
        "Leave out what lies on no surface: otherwise map.glb and map.html have its "
        "mesh, simplified to at most 1 MB");
    app.add_option("--max-points",
                   options.max_points,
                   "Points that the map is made of, at most: of more only each second, "
                   "fourth ... is taken; 50 bytes each on the disk while it is made")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1000}, std::size_t{1} << 31).description(""));
    app.add_option("--formats",
                   options.formats,
                   "Which of map.html, map.ifc and floor_plan.svg, .dxf, .geojson are "
                   "written, by their endings with commas between them")
        ->type_name("LIST")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(all_formats).description(""))
        ->check(CLI::Validator(faultOfMapFormat, ""))
        ->default_str("html,ifc,svg,dxf,geojson");
    app.add_flag_callback(
        "--no-pictures",
        [&options] { options.has_pictures = false; },
        "Draw no pictures, which need an X server, as xvfb-run gives; those that an "
        "earlier run drew of the same map stay");
  });
}

/** \param[in] allowed name of an option of the group that is not refused */
void
refuseGroup(Tool& tool,
            const std::string& group,
            const std::string& why,
            const std::string& allowed = "")
{
  for (const CLI::Option* option : tool.options().get_options())
    if (option->get_group() == group && option->count() > 0 &&
        option->get_name() != allowed)
      throw UsageError(option->get_name() + ": " + why);
}

} // namespace

std::vector<std::string>
formatsByDefault()
{
  std::vector<std::string> formats;
  for (const std::string& format : all_formats)
    if (faultOfMapFormat(format).empty())
      formats.push_back(format);
  return formats;
}

void
addOptions(Tool& tool, ChainOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "input",
         options.input,
         "Raw session, folder of observations (.pcd, .ply or others, with "
         "trajectory.txt or poses.txt if there are poses), E57 or PTX file of "
         "several scans, bag of ROS (.mcap, .db3, .bag, or the folder of a "
         "recording), RGB-D folder, or one cloud (.pcd, .ply, .obj, .xyz, .txt, "
         ".csv, .pts, .ptx, .las, .e57)")
      ->type_name("INPUT")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the compact map")
      ->type_name("OUT_DIR")
      ->required();
  app.add_option("--truth",
                 options.truth,
                 "Simulated session: tell how far the map is from its truth")
      ->type_name("SESSION_DIR");
  app.add_flag("--verbose", options.verbose, "Tell all that the stages report");
  app.add_flag("--paper",
               options.planes.paper,
               "All stages as the paper has them, with nothing added: median of the "
               "disparities, one fit of the motion, voting on the entropy, and planes "
               "and colours of raw points, which takes long");
  tool.addThreads();
  addReading(app, tool.reader());
  addSequenceOptions(tool, options);
  addMapOptions(tool, options);
}

void
takePaperWay(Tool& tool, ChainOptions& options)
{
  if (!options.planes.paper)
    return;
  const auto refuse = [&](const std::string& name, bool departs = true) {
    if (departs && tool.options().get_option(name)->count() > 0)
      throw UsageError(name + " departs from the paper, leave it out with --paper");
  };
  refuse("--method", options.stereo.method != "median");
  for (const char* name :
       {"--6dof", "--max-translation", "--max-rotation", "--keypoints"})
    refuse(name);
  refuse("--mode", options.rectification.stage.getMode() != RectificationMode::Paper);
  refuse("--odometry-noise");
  refuse("--max-distance");
  refuse("--fill");
  options.stereo.method = "median";
  options.egomotion.stage.setPaperMode(true);
  options.rectification.stage.setMode(RectificationMode::Paper);
  options.texture.stage.setPaperMode(true);
  options.max_detail_bytes = 0;
}

void
requireSense(Tool& tool, const ChainOptions& options, StartingPoint start)
{
  const std::string what =
      options.input + " is " +
      (start == StartingPoint::Cloud ? "one cloud" : nameOf(start));
  if (start != StartingPoint::Session)
    refuseGroup(tool, stereo_group, "is for raw sessions, and " + what);
  const InputKind kind = inputKindOf(options.input);
  if (kind != InputKind::Bag && kind != InputKind::RgbdFolder)
    refuseGroup(tool, recording_group, "is for bags and RGB-D folders, and " + what);
  if (kind != InputKind::Bag)
    refuseGroup(tool, bag_group, "is for bags, and " + what);
  if (kind != InputKind::RgbdFolder)
    refuseGroup(tool, rgbd_group, "is for RGB-D folders, and " + what);
  std::error_code error;
  if (kind == InputKind::Bag || start != StartingPoint::PosedObservations ||
      !std::filesystem::is_directory(options.input, error))
    refuseGroup(tool, poses_group, "is for folders with poses, and " + what);
  if (start == StartingPoint::PosedObservations || start == StartingPoint::Cloud)
    refuseGroup(
        tool, egomotion_group, "is for observations without poses, and " + what);
  if (start == StartingPoint::Cloud)
    for (const char* group : {motion_group, rectification_group})
      refuseGroup(tool, group, "is for observations, and " + what);
  else
    for (const char* option : {"--sensor-at", "--columns"})
      if (tool.options().get_option(option)->count() > 0)
        throw UsageError(option + std::string(" is for one cloud, and ") + what);
  if (start == StartingPoint::Cloud && !options.truth.empty())
    throw UsageError("--truth is for observations, and " + what);
  if (start == StartingPoint::Session && tool.reader().getScale() != 1)
    throw UsageError("--scale is for point clouds, and " + what);
  if (start == StartingPoint::Session && tool.reader().getShift())
    throw UsageError("--shift is for point clouds, and " + what);
  if (!options.stereo.poses.empty())
    refuseGroup(tool, egomotion_group, "is not used where --poses are known");
  if (options.as_recorded && !options.stereo.poses.empty())
    throw UsageError("--poses: a session that is replayed gets its poses on the way");
  if (options.as_recorded && !options.truth.empty())
    throw UsageError(
        "--truth: is told of the stages of a map, which --as-recorded has not");
  if (options.live && !options.as_recorded)
    throw UsageError("--live: shows a session while it is replayed, --as-recorded");
  requireStereoSense(options.stereo);
  checkChoices(options.planes);
}

nlohmann::ordered_json
valuesIn(Tool& tool, const std::string& group)
{
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const CLI::Option* option : tool.options().get_options())
    if (option->get_group() == group && option->count() > 0)
      values[option->get_name()] = option->results();
  return values;
}

} // namespace pcl::acmap
