#include "stereo_matches.h"

#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/transformation_estimation_planar.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Icp = IterativeClosestPoint<PointXYZ, PointXYZ>;
using Planar = registration::TransformationEstimationPlanar<PointXYZ, PointXYZ>;
using WorstOut = registration::CorrespondenceRejectorWorstOut;

/** Points of a room, some of which moved independently between the views. */
class PlanarIcp : public testing::Test {
protected:
  PlanarIcp()
  {
    Random random(8);
    for (int i = 0; i < 300; ++i) {
      const double x = random.uniform(-2, 2), y = random.uniform(-1, 1);
      const Eigen::Vector3d place(x, y, random.uniform(1, 5));
      Eigen::Vector3d now = truth_.inverse() * place;
      if (i % 3 == 0) // a third
        now += Eigen::Vector3d(0.15, 0.02, -0.1);
      add(place, *before_);
      add(now, *now_);
    }
  }

  static void
  add(const Eigen::Vector3d& place, PointCloud<PointXYZ>& cloud)
  {
    cloud.emplace_back(static_cast<float>(place.x()),
                       static_cast<float>(place.y()),
                       static_cast<float>(place.z()));
  }

  /** Position error of a point in the centre of the room. */
  double
  errorOf(Icp& icp) const
  {
    icp.setInputSource(now_);
    icp.setInputTarget(before_);
    icp.setMaximumIterations(50);
    PointCloud<PointXYZ> aligned;
    icp.align(aligned);
    const Eigen::Matrix4d found = icp.getFinalTransformation().cast<double>();
    const Eigen::Vector3d place(0, 0, 3);
    return (found.topLeftCorner<3, 3>() * place + found.topRightCorner<3, 1>() -
            truth_ * place)
        .norm();
  }

  const Eigen::Isometry3d truth_ = planarMotion(0.05, 0.04, 0.015);
  PointCloud<PointXYZ>::Ptr before_{new PointCloud<PointXYZ>},
      now_{new PointCloud<PointXYZ>};
};

TEST_F(PlanarIcp, findsTheTruthWhereWhatMovedMisleadsOthers)
{
  Icp plain, planar, ours;
  EXPECT_GT(errorOf(plain), 0.05);
  planar.setTransformationEstimation(Planar::Ptr(new Planar));
  EXPECT_GT(errorOf(planar), 0.05);

  const WorstOut::Ptr rejector(new WorstOut);
  rejector->setMaximumDistortion(1.01); // there is no noise
  ours.addCorrespondenceRejector(rejector);
  ours.setTransformationEstimation(Planar::Ptr(new Planar));
  EXPECT_LT(errorOf(ours), 1e-5);
  EXPECT_EQ(rejector->getReport().kept, 200u);
}

} // namespace
} // namespace pcl::acmap::test
