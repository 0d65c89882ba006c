#include "pose_options.h"

#include "setter_option.h"

#include <pcl/core/fields_json.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

void
addPoseReading(CLI::App& app, PoseConventionCheck& check)
{
  addSetter<std::string>(
      app,
      "--pose-convention",
      [&check](const std::string& name) {
        std::string others;
        for (std::size_t i = 0; i < pose_convention_names.size(); ++i) {
          if (name == pose_convention_names[i])
            return check.setConvention(static_cast<PoseConvention>(i));
          others += (i > 0 ? ", " : "") + std::string(pose_convention_names[i]);
        }
        throw BadArgument(name + " is none of " + others);
      },
      "What recorded poses are: camera-to-world, world-to-camera, opengl "
      "(camera-to-world, "
      "whose camera looks along -z with y up), opengl-world-to-camera, or "
      "transposed-rotation [default: camera-to-world; views that contradict it end the "
      "run]",
      "NAME");
  addSetter<double>(
      app,
      "--pose-scale",
      [&check](double scale) { check.setScale(scale); },
      "Metres in a unit of recorded poses: 0.001 for millimetres [default: that of the "
      "points]",
      "M");
}

void
tellPoseReading(const PoseConventionCheck& check,
                const std::optional<PoseConventionReport>& report,
                StageLog& log)
{
  if (!report)
    return;
  log.details["pose_convention"] = fieldsOf(*report);
  const bool is_stated = check.getConvention() && check.getScale();
  log.tell("recorded poses",
           textOf(*report) +
               (is_stated ? "" : "; --pose-convention, --pose-scale state another"));
}

void
tellPath(const CameraPathReport& report, StageLog& log)
{
  log.details["path"] = fieldsOf(report);
  log.tell("path",
           textOf(report) + (report.is_in_space ? "; --no-6dof states a planar one"
                                                : "; --6dof states one in space"));
}

} // namespace pcl::acmap
