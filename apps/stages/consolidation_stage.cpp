#include "consolidation_stage.h"

#include "length_check.h"
#include "stage_reports.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {
namespace {

constexpr const char* option_name = "--consolidate";

/** \brief Whether the user named the size of the voxel: an automatic one is not to be
 * blamed on the user. */
bool
isGiven(Tool& tool)
{
  const CLI::Option* const option = tool.options().get_option_no_throw(option_name);
  return option && option->count() > 0 && option->results().front() != "auto";
}

} // namespace

ConsolidatedCloud
consolidateInput(Tool& tool,
                 const PointCloudFile& file,
                 const SensorView& sensors,
                 ConsolidationSettings settings,
                 ConsolidationReport& report)
{
  if (isGiven(tool))
    requireFineLength(tool, option_name, settings.voxel_size, file.points());
  settings.threads = tool.threads();
  ConsolidatedCloud result;
  tool.withProgress([&](const ProgressCallback& progress) {
    result = consolidatedCloud(file, sensors, settings, progress, report);
  });
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tool.details()["consolidation"] = jsonOf(report);
  tool.tell("consolidated",
            std::to_string(report.points) + " points to " +
                std::to_string(report.representatives) + ", voxels of " +
                shortNumber(report.voxel_size) + " m, noise " +
                shortNumber(1000 * report.sigma) + " to about " +
                shortNumber(1000 * report.residual) + " mm");
  return result;
}

} // namespace pcl::acmap
