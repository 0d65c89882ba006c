#pragma once

#include "memory.h"

#include <pcl/conversions.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/texture/floor_plan.h>
#include <pcl/visualization/live_viewer.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
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
    showStatus(statusOf(state));
  }

private:
  /** \brief "12 observations, 31 m², move slower". */
  std::string
  statusOf(const MappingState& state) const
  {
    constexpr double max_lag = 3; // seconds
    double area = 0;
    for (const PlanRoom& room : floor_plan_.rooms)
      area += room.seen_area;
    std::string text = std::to_string(state.processed) + " observation" +
                       (state.processed == 1 ? "" : "s");
    if (area > 0)
      text += ", " + std::to_string(std::lround(area)) + " m\u00b2";
    if (!state.poses.empty() && !state.poses.back())
      return text + ", lost: go back to what was seen before";
    return text + (state.is_late || state.lag > max_lag ? ", move slower" : "");
  }

  /** \brief Rooms, walls, the way of the camera, and what it looks at now. */
  std::vector<PlanLine>
  linesOf(const MappingState& state) const
  {
    using Color = std::array<std::uint8_t, 3>;
    constexpr std::array<Color, 4> room_colors = {
        {{214, 228, 245}, {224, 240, 220}, {248, 232, 208}, {240, 220, 236}}};
    constexpr Color wall = {29, 39, 51}, accent = {20, 99, 194};
    std::vector<PlanLine> lines;
    for (std::size_t i = 0; i < floor_plan_.rooms.size(); ++i)
      lines.push_back(
          {floor_plan_.rooms[i].outline, room_colors[i % room_colors.size()], true});
    for (const PlanWall& seen : floor_plan_.walls)
      lines.push_back({{seen.from, seen.to}, wall});
    PlanLine way{{}, accent};
    for (const auto& pose : state.poses)
      if (pose)
        way.points.push_back(floor_plan_.placeOf(pose->translation()));
    lines.push_back(std::move(way));
    if (!state.poses.empty() && state.poses.back())
      lines.push_back(sightOf(*state.poses.back()));
    return lines;
  }

  /** \brief The frustum of a camera from above. */
  PlanLine
  sightOf(const Eigen::Isometry3d& pose) const
  {
    constexpr double length = 1.2, half_width = 0.6; // metres
    const Eigen::Vector2d eye = floor_plan_.placeOf(pose.translation());
    const Eigen::Vector2d ahead = length * floor_plan_.placeOf(pose.linear().col(2));
    const Eigen::Vector2d right =
        half_width * floor_plan_.placeOf(pose.linear().col(0));
    return {{eye, eye + ahead + right, eye + ahead - right}, {255, 176, 72}, true};
  }

  FloorPlan floor_plan_;
  std::shared_ptr<const PointCloudFile> newest_;  ///< that is shown
  std::shared_ptr<const CompactMap> provisional_; ///< of the plan
};

} // namespace pcl::acmap
