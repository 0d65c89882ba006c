#include "consolidation_stage.h"

#include "stage_reports.h"

namespace pcl::acmap {

ConsolidatedCloud
consolidateInput(Tool& tool,
                 const PointCloudFile& file,
                 const SensorView& sensors,
                 ConsolidationSettings settings,
                 ConsolidationReport& report)
{
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
