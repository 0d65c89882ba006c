#pragma once

#include <pcl/conversions.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/live_plan.h>
#include <pcl/visualization/live_viewer.h>

#include <memory>
#include <vector>

namespace pcl::acmap {

/** \brief The window of --live, which also shows a map that is being made. The memory limit
 * does not count while it is open. */
class LiveWindow : UnlimitedMemory, public LiveViewer {
public:
  using LiveViewer::LiveViewer;
  using LiveViewer::show;

  /** \brief Sets the newest view of a map that is being made, and its plan. */
  void
  show(const MappingState& state)
  {
    if (state.newest && state.newest != newest_) {
      newest_ = state.newest;
      PointCloud<PointXYZRGBSigma> cloud;
      fromPCLPointCloud2(newest_->cloud, cloud);
      show(cloud);
    }
    plan_.update(state);
    std::vector<PlanLine> lines;
    for (const PlanStroke& stroke : plan_.strokes())
      lines.push_back({stroke.points, stroke.color, stroke.is_area});
    showPlan(lines);
    showStatus(plan_.status());
  }

private:
  std::shared_ptr<const PointCloudFile> newest_; ///< that is shown
  LivePlan plan_;
};

} // namespace pcl::acmap
