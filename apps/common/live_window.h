#pragma once

#include "memory.h"

#include <pcl/conversions.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/texture/floor_plan.h>
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
    if (state.provisional && state.provisional != provisional_)
      floor_plan_ = makeFloorPlan(*state.provisional);
    provisional_ = state.provisional;
    showPlan(linesOf(state));
  }

private:
  /** \brief The floor, the walls, and the way of the camera. */
  std::vector<PlanLine>
  linesOf(const MappingState& state) const
  {
    std::vector<PlanLine> lines;
    for (const auto& polygon : floor_plan_.floors)
      for (const std::vector<Eigen::Vector2d>& loop : polygon) {
        lines.push_back({loop, {70, 74, 84}});
        lines.back().points.insert(
            lines.back().points.end(), loop.begin(), loop.begin() + !loop.empty());
      }
    for (const PlanWall& wall : floor_plan_.walls)
      lines.push_back({{wall.from, wall.to}, {235, 235, 235}});
    PlanLine way{{}, {90, 160, 255}};
    for (const auto& pose : state.poses)
      if (pose)
        way.points.emplace_back(pose->translation().dot(floor_plan_.x_axis),
                                pose->translation().dot(floor_plan_.y_axis));
    lines.push_back(std::move(way));
    return lines;
  }

  FloorPlan floor_plan_;
  std::shared_ptr<const PointCloudFile> newest_;  ///< that is shown
  std::shared_ptr<const CompactMap> provisional_; ///< of the plan
};

} // namespace pcl::acmap
