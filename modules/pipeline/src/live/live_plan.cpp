#include <pcl/pipeline/live_plan.h>

#include <cmath>
#include <utility>

namespace pcl {

namespace {

/** \brief The frustum of a camera from above. */
PlanStroke
sightOf(const FloorPlan& plan, const Eigen::Isometry3d& pose)
{
  constexpr double length = 1.2, half_width = 0.6; // metres
  const Eigen::Vector2d eye = plan.placeOf(pose.translation());
  const Eigen::Vector2d ahead = length * plan.placeOf(pose.linear().col(2));
  const Eigen::Vector2d right = half_width * plan.placeOf(pose.linear().col(0));
  return {{eye, eye + ahead + right, eye + ahead - right}, {255, 176, 72}, true};
}

} // namespace

void
LivePlan::update(const MappingState& state)
{
  if (state.provisional && state.provisional != provisional_)
    plan_ = makeFloorPlan(*state.provisional);
  provisional_ = state.provisional;
  strokes_ = strokesOf(state);
  status_ = statusOf(state);
}

std::string
LivePlan::statusOf(const MappingState& state) const
{
  constexpr double max_lag = 3; // seconds
  double area = 0;
  for (const PlanRoom& room : plan_.rooms)
    area += room.seen_area;
  std::string text = std::to_string(state.processed) + " observation" +
                     (state.processed == 1 ? "" : "s");
  if (area > 0)
    text += ", " + std::to_string(std::lround(area)) + " m\u00b2";
  if (!state.poses.empty() && !state.poses.back())
    return text + ", lost: go back to what was seen before";
  return text + (state.is_late || state.lag > max_lag ? ", move slower" : "");
}

std::vector<PlanStroke>
LivePlan::strokesOf(const MappingState& state) const
{
  using Color = std::array<std::uint8_t, 3>;
  constexpr std::array<Color, 4> room_colors = {
      {{214, 228, 245}, {224, 240, 220}, {248, 232, 208}, {240, 220, 236}}};
  constexpr Color wall = {29, 39, 51}, accent = {20, 99, 194};
  std::vector<PlanStroke> lines;
  for (std::size_t i = 0; i < plan_.rooms.size(); ++i)
    lines.push_back(
        {plan_.rooms[i].outline, room_colors[i % room_colors.size()], true});
  for (const PlanWall& seen : plan_.walls)
    lines.push_back({{seen.from, seen.to}, wall});
  PlanStroke way{{}, accent};
  for (const auto& pose : state.poses)
    if (pose)
      way.points.push_back(plan_.placeOf(pose->translation()));
  lines.push_back(std::move(way));
  if (!state.poses.empty() && state.poses.back())
    lines.push_back(sightOf(plan_, *state.poses.back()));
  return lines;
}

} // namespace pcl
