#include "figures.h"

#include "entropy_rectification/plan_picture.h"
#include "figure_sheet.h"
#include "figure_views.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/point_view.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap {

namespace {

constexpr Color truth_color = {255, 150, 140};
constexpr Color way_color = {120, 160, 220};

/** Plans of the map, rotated so that its longer side is horizontal. */
class Plans {
public:
  /** \param[in] cut points farther above or below the first camera are left out,
   * metres */
  Plans(const FilmedSession& session, const MappedSession& map, double cut)
  : session_(session)
  , map_(map)
  , points_(pointsOf(map.points))
  , cut_(cut)
  , view_(findField(map.points, "view")->offset)
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Isometry3d& pose : map.after.poses)
      box.extend(pose.translation());
    if (box.sizes().z() > box.sizes().x()) // z to the right, x downwards
      T_plan_map_ = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY());
    PlanContents contents;
    for (const Trajectory* trajectory : {&map.before, &map.after})
      for (std::size_t i = 0; i < points_.size(); ++i)
        if (isShown(i))
          contents.addPoint(T_plan_map_ * place(i, *trajectory));
    // metres by which the extent is widened for the true walls
    constexpr double beyond = 0.8;
    const PlanExtent seen = contents.extent();
    contents.addPlace({seen.least.x() + seen.pixel * seen.width + beyond,
                       0,
                       seen.least.y() + seen.pixel * seen.height / 2});
    extent_ = contents.extent();
  }

  /** \brief Draws only the walls. */
  RgbImage
  truth() const
  {
    constexpr double wall_width = 2; // px
    RgbImage image = PlanPicture(extent_).draw(inPlan(session_.trajectory), way_color);
    drawWalls(image, wall_width, black);
    return image;
  }

  /** \brief Draws the points at the poses of a trajectory, over the true walls. */
  RgbImage
  of(const Trajectory& trajectory, const std::string& name) const
  {
    PlanPicture picture(extent_);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (isShown(i))
        picture.add(T_plan_map_ * place(i, trajectory));
    constexpr double below_width = 4; // px
    RgbImage image = whiteImage(extent_.width, extent_.height);
    drawWalls(image, below_width, truth_color);
    const RgbImage points = picture.draw(inPlan(trajectory), way_color);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = std::min(image.values[i], points.values[i]);
    return named(image, name);
  }

  static RgbImage
  named(RgbImage image, const std::string& name)
  {
    constexpr int margin = 8; // px
    drawText(image, margin, margin, name, black);
    return image;
  }

private:
  static PointView
  pointsOf(const PCLPointCloud2& cloud)
  {
    return PointView(cloud.data.data() + findField(cloud, "x")->offset,
                     cloud.point_step,
                     rowsOf(cloud));
  }

  bool
  isShown(std::size_t i) const
  {
    return std::abs(points_[i].y()) <= cut_;
  }

  /** \brief Position of a point for the pose of its observation in a trajectory. */
  Eigen::Vector3d
  place(std::size_t i, const Trajectory& trajectory) const
  {
    std::int32_t view;
    std::memcpy(&view,
                map_.points.data.data() + i * map_.points.point_step + view_,
                sizeof view);
    const Eigen::Vector3d in_map = points_[i].cast<double>();
    const auto row = static_cast<std::size_t>(view);
    if (view < 0 || row >= trajectory.poses.size())
      return in_map;
    return trajectory.poses[row] * (map_.after.poses[row].inverse() * in_map);
  }

  std::vector<Eigen::Isometry3d>
  inPlan(const Trajectory& trajectory) const
  {
    std::vector<Eigen::Isometry3d> poses;
    for (const Eigen::Isometry3d& pose : trajectory.poses)
      poses.push_back(T_plan_map_ * pose);
    return poses;
  }

  void
  drawWalls(RgbImage& image, double width, const Color& color) const
  {
    for (const auto& [from, to] : session_.uprights)
      drawLine(image,
               extent_.pixelOf(T_plan_map_ * from),
               extent_.pixelOf(T_plan_map_ * to),
               width,
               color);
  }

  const FilmedSession& session_;
  const MappedSession& map_;
  PointView points_;
  double cut_;
  std::size_t view_;
  Eigen::Isometry3d T_plan_map_ = Eigen::Isometry3d::Identity();
  PlanExtent extent_;
};

/** The points that are at most this height above the first camera. */
PCLPointCloud2
below(const PCLPointCloud2& cloud, double height)
{
  PCLPointCloud2 low = cloud;
  low.data.clear();
  const std::size_t y = findField(cloud, "y")->offset;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    const auto* const row = cloud.data.data() + i * cloud.point_step;
    float down;
    std::memcpy(&down, row + y, sizeof down);
    if (down >= -height)
      low.data.insert(low.data.end(), row, row + cloud.point_step);
  }
  resizeRows(low, low.data.size() / cloud.point_step);
  return low;
}

RgbImage
perspective(const LayeredScene& scene, const FigureEye& eye, const OutputFolder& folder)
{
  auto view = viewFrom<LayeredView>(eye, 960, 720);
  view.layers = {SceneLayer::Points};
  return withFewLevels(
      drawn(folder, [&](const std::string& path) { saveSnapshot(path, scene, view); }));
}

} // namespace

void
drawMapFigure(const FilmedSession& session,
              const MappedSession& map,
              const FigurePlan& plan,
              const OutputFolder& folder)
{
  const Plans plans(session, map, plan.cut);
  LayeredScene scene;
  scene.points = below(map.points, plan.cut);
  lighten(scene.points);
  std::vector<std::vector<RgbImage>> rows = {
      {Plans::named(plans.truth(), "true plan")},
      {plans.of(map.before, "before rectification - true plan in red")},
      {plans.of(map.after, "after rectification - true plan in red")},
      {}};
  for (const FigureEye& eye : plan.perspectives)
    rows.back().push_back(perspective(scene, eye, folder));
  savePng(folder.path("fig4.png"), withFewLevels(sheetOf(rows, plan.width)));
}

} // namespace pcl::acmap
