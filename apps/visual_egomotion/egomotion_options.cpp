#include "egomotion_options.h"

#include "output_target.h"
#include "reading_options.h"
#include "setter_option.h"

#include <pcl/pipeline/observation_files.h>

#include <CLI/CLI.hpp>

#include <filesystem>

namespace pcl::acmap {

bool
EgomotionOptions::hasFolder() const
{
  std::error_code error;
  return inputs.size() == 1 && (std::filesystem::is_directory(inputs.front(), error) ||
                                endingOf(inputs.front()) != ".pcd");
}

ObservationSequence
observationsOf(const EgomotionOptions& options, double scale)
{
  return ObservationSequence(
      options.hasFolder() ? observationPaths(options.inputs.front()) : options.inputs,
      scale);
}

void
addMotionChoices(CLI::App& app, EgomotionOptions& options)
{
  using Egomotion = VisualOdometry::Egomotion;
  Egomotion& stage = options.stage;
  CLI::Option* const free = app.add_flag_callback(
      "--6dof",
      [&options] {
        options.stage.setMotionModel(MotionModel::Rigid);
        options.measures_path = false;
      },
      "The camera moves freely, as in a hand [default: found from the first motions]");
  app.add_flag_callback(
         "--no-6dof",
         [&options] { options.measures_path = false; },
         "It moves level, as on a robot: in its xz plane and about its y axis")
      ->excludes(free);
  addSetter(app,
            "--max-translation",
            stage,
            &Egomotion::setMaximumTranslation,
            &Egomotion::getMaximumTranslation,
            "How far it moves from an observation to the next, at most, metres",
            "M");
  constexpr double degree = 3.14159265358979323846 / 180;
  addSetter(app,
            "--max-rotation",
            stage,
            &Egomotion::setMaximumRotation,
            &Egomotion::getMaximumRotation,
            "How far it turns, at most, degrees",
            "DEG",
            degree);
  addSetter(app,
            "--keypoints",
            stage,
            &Egomotion::setMaximumKeypoints,
            &Egomotion::getMaximumKeypoints,
            "Keypoints of an observation at each of three scales, at most",
            "N");
  addSwitch(app,
            "--no-refinement",
            stage,
            &Egomotion::setRefinement,
            false,
            "Features alone: leave surfaces out");
}

void
addOptions(Tool& tool, EgomotionOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("observations",
                 options.inputs,
                 "Folder of observation PCDs, or such PCDs in their order: organized, "
                 "camera frame, with colour; poses that they have are not used")
      ->type_name("OBS_DIR|OBS.pcd..")
      ->default_str("")
      ->required();
  app.add_option(
         "-o,--output", options.output, "Folder for poses, posed PCDs, pictures")
      ->type_name("OUT_DIR")
      ->required();
  addMotionChoices(app, options);
  CLI::Option* const paper =
      addSwitch(app,
                "--paper",
                options.stage,
                &VisualOdometry::Egomotion::setPaperMode,
                true,
                "As the paper has it and nothing else: one scale, Eq. 1 as printed, "
                "Eq. 2 in one fit");
  for (const char* departure :
       {"--max-translation", "--max-rotation", "--keypoints", "--no-refinement"})
    paper->excludes(app.get_option(departure));
  app.add_flag("--pictures",
               options.pictures,
               "Draw the matches of each pair too, before and after rejection");
  app.add_option("--truth",
                 options.truth,
                 "True poses in TUM's form to compare with, a row an observation")
      ->type_name("TRAJECTORY.txt");
  addScale(app, tool.reader());
  tool.addThreads();
}

} // namespace pcl::acmap
