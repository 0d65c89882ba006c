#include <pcl/core/exceptions.h>
#include <pcl/core/rigid_motion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace pcl::acmap::test {

namespace {

Eigen::Isometry3d
altered(int row, int column, double value)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.matrix()(row, column) = value;
  return pose;
}

std::string
faultOf(const Eigen::Matrix4d& pose)
{
  try {
    const RigidMotion motion(pose);
    return {};
  }
  catch (const BadArgumentException& fault) {
    return fault.what();
  }
}

Eigen::Matrix4f
randomStep(std::mt19937& random)
{
  std::normal_distribution<float> normal(0, 0.1F);
  Eigen::Affine3f step(Eigen::AngleAxisf(
      normal(random),
      Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized()));
  step.translation() << normal(random), normal(random), normal(random);
  return step.matrix();
}

TEST(RigidMotion, isNoMirrorNoScaleNoShear)
{
  EXPECT_FALSE(isRigid(altered(0, 0, -1))) << "mirror";
  EXPECT_FALSE(isRigid(altered(1, 1, 1.001))) << "scale";
  EXPECT_FALSE(isRigid(altered(0, 1, 0.01))) << "shear";
  EXPECT_FALSE(isRigid(altered(2, 2, 0))) << "flat";
  EXPECT_TRUE(isRigid(altered(0, 0, 1 + 1e-4))) << "rounding";
  EXPECT_FALSE(isRigid(altered(0, 0, 1 + 1e-5), 1e-6));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    EXPECT_FALSE(isRigid(altered(0, 3, bad)));
    EXPECT_FALSE(isRigid(altered(1, 2, bad)));
  }
}

TEST(RigidMotion, saysWhatIsWrong)
{
  const auto has = [](const Eigen::Isometry3d& pose, const char* words) {
    const std::string fault = faultOf(pose.matrix());
    EXPECT_NE(fault.find(words), std::string::npos) << fault;
    EXPECT_EQ(fault.find("a pose is "), 0U) << fault;
  };
  has(altered(0, 0, -1), "it mirrors");
  has(altered(1, 1, 1.01), "deviate by 0.0201");
  has(altered(0, 3, std::nan("")), "not finite");
  has(altered(3, 1, 0.5), "last row");
  EXPECT_THROW(requirePlace(altered(2, 3, 2e9)), BadArgumentException);
}

TEST(RigidMotion, takesAThousandProductsOfFloats)
{
  std::mt19937 random(4);
  for (int chain = 0; chain < 20; ++chain) {
    Eigen::Matrix4f product = Eigen::Matrix4f::Identity();
    Eigen::Matrix4d exact = Eigen::Matrix4d::Identity();
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Matrix4f step = randomStep(random);
      product = product * step;
      exact = exact * RigidMotion(step).get().matrix();
    }
    const Eigen::Isometry3d pose = RigidMotion(product);
    EXPECT_TRUE(isRigid(pose, 1e-12));
    EXPECT_LT((pose.linear() - exact.topLeftCorner<3, 3>()).norm(), 1e-3);
    EXPECT_EQ(pose.translation(), (product.topRightCorner<3, 1>().cast<double>()));
  }
}

TEST(RigidMotion, isEachTypeOfEigen)
{
  std::mt19937 random(5);
  const Eigen::Matrix4f matrix = randomStep(random);
  const Eigen::Isometry3d expected = RigidMotion(matrix);
  EXPECT_TRUE(RigidMotion(Eigen::Affine3f(matrix)).get().isApprox(expected, 1e-15));
  EXPECT_TRUE(RigidMotion(Eigen::Isometry3f(matrix)).get().isApprox(expected, 1e-15));
  EXPECT_TRUE(RigidMotion(Eigen::Affine3d(matrix.cast<double>().eval()))
                  .get()
                  .isApprox(expected, 1e-15));
  EXPECT_TRUE(RigidMotion(Eigen::AffineCompact3f(Eigen::Affine3f(matrix)))
                  .get()
                  .isApprox(expected, 1e-15));
  EXPECT_TRUE(RigidMotion(matrix.cast<double>()).get().isApprox(expected, 1e-15));
  EXPECT_TRUE(RigidMotion(matrix * matrix).get().isApprox(expected * expected, 1e-6));
}

TEST(RigidMotion, keepsTheBitsOfAGoodPose)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()));
  pose.translation() << 1, -2, 1e8;
  EXPECT_EQ(RigidMotion(pose).get().matrix(), pose.matrix());
}

} // namespace
} // namespace pcl::acmap::test
