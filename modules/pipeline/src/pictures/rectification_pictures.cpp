#include "pictures/drawing.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/planar_pose.h>
#include <pcl/pipeline/plan_picture.h>
#include <pcl/pipeline/rectification_pictures.h>

namespace pcl {

namespace {

using PosesOfPlan = std::vector<Eigen::Isometry3d>;
using CloudsOfPlan = std::vector<PointCloud<PointNormal>::Ptr>;

/** Transforms the poses to a frame whose y axis points down, as plans have it. */
PosesOfPlan
upright(const Eigen::Vector3d& up, PosesOfPlan poses)
{
  for (Eigen::Isometry3d& pose : poses)
    pose = uprightRotation(up) * pose;
  return poses;
}

/** Extent of all poses and points, before and after. */
PlanExtent
extentOfBoth(const CloudsOfPlan& clouds,
             const PosesOfPlan& before,
             const PosesOfPlan& after)
{
  PlanContents contents;
  for (const PosesOfPlan* all : {&before, &after})
    for (std::size_t i = 0; i < all->size(); ++i) {
      const Eigen::Isometry3d& T_plan_camera = (*all)[i];
      contents.addPlace(T_plan_camera.translation());
      for (const PointNormal& point : *clouds[i])
        contents.addPoint(T_plan_camera * point.getVector3fMap().cast<double>());
    }
  return contents.extent();
}

RgbImage
drawPlan(const PlanExtent& extent,
         const CloudsOfPlan& clouds,
         const PosesOfPlan& poses,
         const acmap::Color& color)
{
  PlanPicture picture(extent);
  for (std::size_t i = 0; i < clouds.size(); ++i)
    for (const PointNormal& point : *clouds[i])
      picture.add(poses[i] * point.getVector3fMap().cast<double>());
  return picture.draw(poses, acmap::channelsOf(color));
}

} // namespace

RectificationPictures
drawRectification(const std::vector<PointCloud<PointNormal>::Ptr>& clouds,
                  const std::vector<Eigen::Isometry3d>& before,
                  const std::vector<Eigen::Isometry3d>& after,
                  const Eigen::Vector3d& up,
                  const std::vector<RectificationStep>& steps)
{
  if (before.size() != clouds.size() || after.size() != clouds.size())
    throw acmap::BadArgument("there are ",
                             clouds.size(),
                             " clouds, but ",
                             before.size(),
                             " poses before and ",
                             after.size(),
                             " after");
  const PosesOfPlan plan_before = upright(up, before), plan_after = upright(up, after);
  const PlanExtent extent = extentOfBoth(clouds, plan_before, plan_after);
  RectificationPictures pictures;
  pictures.plan_before = drawPlan(extent, clouds, plan_before, acmap::red);
  pictures.plan_after = drawPlan(extent, clouds, plan_after, acmap::blue);
  pictures.plan = acmap::beside(pictures.plan_before, pictures.plan_after);
  pictures.energy = energyPicture(steps);
  return pictures;
}

} // namespace pcl
