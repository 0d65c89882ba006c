#include "motion_problems.h"

#include <pcl/core/exceptions.h>
#include <pcl/egomotion/transformation_estimation_planar.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

template <typename Scalar>
class PlanarEstimation : public testing::Test {
protected:
  using Fit = registration::TransformationEstimationPlanar<PointXYZ, PointXYZ, Scalar>;
  using Matrix4 = typename Fit::Matrix4;

  PlanarEstimation()
  {
    const MotionProblem problem = randomProblem(4, MotionModel::Planar, 0.02);
    const auto cloudOf = [](const std::vector<Eigen::Vector3d>& places) {
      PointCloud<PointXYZ> cloud;
      for (const Eigen::Vector3d& place : places)
        cloud.emplace_back(static_cast<float>(place.x()),
                           static_cast<float>(place.y()),
                           static_cast<float>(place.z()));
      return cloud;
    };
    source_ = cloudOf(problem.source);
    target_ = cloudOf(problem.target);
    weights_ = problem.weights;
    for (int i = 0; i < static_cast<int>(source_.size()); ++i)
      all_.push_back(i);
  }

  /** Result of the kernel for the same floats. */
  Matrix4
  wanted(MotionModel model = MotionModel::Planar,
         MotionSolver solver = MotionSolver::ConjugateGradient,
         const std::vector<double>& weights = {}) const
  {
    std::vector<Eigen::Vector3d> source, target;
    for (std::size_t i = 0; i < source_.size(); ++i) {
      source.push_back(source_[i].getVector3fMap().template cast<double>());
      target.push_back(target_[i].getVector3fMap().template cast<double>());
    }
    return fitMotion(source, target, weights, model, solver)
        .T_target_source.matrix()
        .template cast<Scalar>();
  }

  PointCloud<PointXYZ> source_, target_;
  std::vector<double> weights_;
  Indices all_;
  Fit fit_;
};

using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(PlanarEstimation, Scalars);

TYPED_TEST(PlanarEstimation, theFourWaysAreOne)
{
  using Matrix4 = typename TestFixture::Matrix4;
  const Matrix4 wanted = this->wanted();
  EXPECT_GT((wanted - Matrix4::Identity()).norm(), 0.1);
  Matrix4 motion = Matrix4::Zero();
  this->fit_.estimateRigidTransformation(this->source_, this->target_, motion);
  EXPECT_EQ(motion, wanted);

  // inserts other points between them
  PointCloud<PointXYZ> more = this->source_;
  more.insert(more.begin(), 5, PointXYZ(9, 9, 9));
  Indices shifted;
  Correspondences matches;
  for (const int index : this->all_) {
    shifted.push_back(index + 5);
    matches.emplace_back(index + 5, index, 0.0F);
  }
  motion.setZero();
  this->fit_.estimateRigidTransformation(more, shifted, this->target_, motion);
  EXPECT_EQ(motion, wanted);
  motion.setZero();
  this->fit_.estimateRigidTransformation(
      more, shifted, this->target_, this->all_, motion);
  EXPECT_EQ(motion, wanted);
  motion.setZero();
  this->fit_.estimateRigidTransformation(more, this->target_, matches, motion);
  EXPECT_EQ(motion, wanted);
}

TYPED_TEST(PlanarEstimation, settingsReachTheFit)
{
  using Matrix4 = typename TestFixture::Matrix4;
  Matrix4 motion;
  this->fit_.setMotionModel(MotionModel::Rigid);
  this->fit_.setSolver(MotionSolver::ClosedForm);
  this->fit_.setCorrespondenceWeights(this->weights_);
  this->fit_.estimateRigidTransformation(this->source_, this->target_, motion);
  EXPECT_EQ(motion,
            this->wanted(MotionModel::Rigid, MotionSolver::ClosedForm, this->weights_));
  EXPECT_NE(motion, this->wanted(MotionModel::Rigid, MotionSolver::ClosedForm));
  EXPECT_NE(
      motion,
      this->wanted(MotionModel::Planar, MotionSolver::ClosedForm, this->weights_));
}

TYPED_TEST(PlanarEstimation, whatDoesNotFitIsRefusedAndNothingTouched)
{
  using Matrix4 = typename TestFixture::Matrix4;
  const Matrix4 before = Matrix4::Constant(7);
  Matrix4 motion = before;
  Indices fewer = this->all_;
  fewer.pop_back();
  const auto& [source, target, all, fit] =
      std::tie(this->source_, this->target_, this->all_, this->fit_);
  EXPECT_THROW(fit.estimateRigidTransformation(source, fewer, target, motion),
               BadArgumentException);
  EXPECT_THROW(fit.estimateRigidTransformation(source, all, target, fewer, motion),
               BadArgumentException);
  EXPECT_THROW(fit.estimateRigidTransformation(source, PointCloud<PointXYZ>(), motion),
               BadArgumentException);
  for (const int outside : {-1, static_cast<int>(source.size()), 1 << 30}) {
    Indices wrong = all;
    wrong[2] = outside;
    EXPECT_THROW(fit.estimateRigidTransformation(source, wrong, target, motion),
                 BadArgumentException);
    EXPECT_THROW(fit.estimateRigidTransformation(source, all, target, wrong, motion),
                 BadArgumentException);
    for (const Correspondence& match :
         {Correspondence(outside, 0, 0.0F), Correspondence(0, outside, 0.0F)})
      EXPECT_THROW(fit.estimateRigidTransformation(
                       source, target, Correspondences{match}, motion),
                   BadArgumentException);
  }
  this->fit_.setCorrespondenceWeights({1, 2});
  EXPECT_THROW(fit.estimateRigidTransformation(source, target, motion),
               BadArgumentException);
  EXPECT_EQ(motion, before);
  for (const double bad : {-1.0,
                           std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()})
    EXPECT_THROW(this->fit_.setCorrespondenceWeights({1, bad, 1}),
                 BadArgumentException);
  EXPECT_EQ(this->fit_.getCorrespondenceWeights(), (std::vector<double>{1, 2}));
}

TYPED_TEST(PlanarEstimation, nothingToGoByIsNoMotion)
{
  using Matrix4 = typename TestFixture::Matrix4;
  Matrix4 motion = Matrix4::Zero();
  this->fit_.estimateRigidTransformation(
      this->source_, this->target_, Correspondences(), motion);
  EXPECT_EQ(motion, Matrix4::Identity());
}

} // namespace
} // namespace pcl::acmap::test
