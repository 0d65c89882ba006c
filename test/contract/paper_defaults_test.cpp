#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/transformation_estimation_planar.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/features/normal_vector_voting.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_entropy.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/simulation/simulated_light.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/texture/plane_texturing.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

// The defaults in doc/paper_map.md; that page must be changed together with these.

TEST(PaperDefaults, areThePapersNumbers)
{
  const RandomLinePattern pattern;
  EXPECT_EQ(pattern.getNumberOfLines(), 200);
  EXPECT_EQ(pattern.getWidth(), 1024);
  EXPECT_EQ(pattern.getHeight(), 768);
  EXPECT_TRUE(pattern.getColored());
  const SimulatedProjector projector;
  EXPECT_EQ(projector.width, pattern.getWidth());
  EXPECT_EQ(projector.height, pattern.getHeight());
  const TrinocularRig rig;
  EXPECT_EQ(rig.width, 640);
  EXPECT_EQ(rig.height, 480);

  const registration::TransformationEstimationPlanar<PointXYZ, PointXYZ> fit;
  EXPECT_EQ(fit.getMotionModel(), MotionModel::Planar);
  EXPECT_EQ(fit.getSolver(), MotionSolver::ConjugateGradient);
  EXPECT_EQ(DeWallTriangulation<PointXYZ>().getAcceptanceRule(), DeWallRule::Guarded);
  EXPECT_EQ(PlaneTexturing<PointXYZRGB>().getMaximumDistance(), 0.3);

  PlaneHypothesisClustering<PointNormal> clustering;
  clustering.setNoiseDriven(false);
  EXPECT_EQ(clustering.getClusterTolerance(), 0.8);
  EXPECT_DOUBLE_EQ(clustering.getSmoothnessThreshold(), M_PI / 8);
  EXPECT_EQ(clustering.getDistanceThreshold(), 0.25);
  EXPECT_EQ(clustering.getMinClusterSize(), 50U);
}

TEST(PaperDefaults, areOursWhereThePaperTellsNone)
{
  const MapEntropy<PointXYZ> entropy;
  EXPECT_EQ(entropy.getBinSize(), 0.1);
  EXPECT_EQ(entropy.getSmoothing(), 0.1);
  EXPECT_EQ(entropy.getProjectionWeight(), 0.5);
  EXPECT_EQ((EntropyRectification<PointXYZ>().getBinSize()), 0.1);

  const LogPolarSettings patches;
  EXPECT_EQ(patches.rings, 12);
  EXPECT_EQ(patches.sectors, 24);
  EXPECT_EQ(patches.inner, 1);
  EXPECT_EQ(patches.outer, 20);
  EXPECT_EQ(patches.min_score, 0.8F);
  EXPECT_EQ(patches.max_ambiguity, 0.7F);
  const registration::CorrespondenceRejectorWorstOut rejector;
  EXPECT_EQ(rejector.getMaximumDistortion(), 1.06);
  EXPECT_EQ(rejector.getMinimumDistance(), 0.05);
  EXPECT_EQ(rejector.getMinimumMatches(), 6U);
  EXPECT_EQ(DeWallTriangulation<PointXYZ>().getMaximumEdgeLength(), 0);
}

TEST(PaperDefaults, areAnotherMethodWhereItIsBetter)
{
  EXPECT_EQ(DisparityFusion().getMethod(), DisparityFusion::Method::SpaceTime);
  EXPECT_EQ(EntropyRectification<PointXYZ>().getMode(), RectificationMode::Guarded);
  EXPECT_TRUE(VisualEgomotion<PointXYZRGB>().getRefinement());
  EXPECT_TRUE(PlaneHypothesisClustering<PointNormal>().getNoiseDriven());
  EXPECT_FALSE(PlaneTexturing<PointXYZRGB>().getPaperMode());
  NormalVectorVoting<PointXYZ> voting;
  EXPECT_FALSE(voting.getPaperMode());
  EXPECT_EQ(voting.getCreaseWeight(), 12);
  EXPECT_EQ(voting.getCornerWeight(), 0.3);
  voting.setPaperMode(true);
  EXPECT_EQ(voting.getCreaseWeight(), 2);
  EXPECT_EQ(voting.getCornerWeight(), 2);
}

} // namespace
} // namespace pcl::acmap::test
