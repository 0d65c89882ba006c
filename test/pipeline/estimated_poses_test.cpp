#include "messages.h"
#include "temporary_folder.h"

#include <pcl/pipeline/estimated_poses.h>

#include <gmock/gmock.h>

#include <fstream>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

EstimatedPoses
sample()
{
  EstimatedPoses poses;
  poses.places = {0, 2, 3};
  for (const double x : {0.0, 1.0 / 3, 2e-7}) {
    poses.trajectory.stamps.push_back(x);
    poses.trajectory.poses.emplace_back(Eigen::Translation3d(x, 0, -x));
  }
  poses.noise = OdometryNoise{1.0 / 7, 0, 0.1, 1e-9};
  return poses;
}

class PosesInAFolder : public testing::Test {
protected:
  void
  write(const std::string& yaml) const
  {
    std::ofstream(folder_.path("poses.yaml")) << yaml;
  }

  std::string
  fault() const
  {
    return messageOf<InputFileException>([&] { loadEstimatedPoses(folder_.path("")); });
  }

  TemporaryFolder folder_;
};

TEST_F(PosesInAFolder, comeBackExactly)
{
  EstimatedPoses there = sample();
  for (const bool has_noise : {true, false}) {
    if (has_noise) {
      there.up = Eigen::Vector3d(0, -0.1, 1.0 / 3);
      there.verdict = VerdictOutcome::Contradicted;
    }
    else {
      there.noise.reset();
      there.up.reset();
      there.verdict.reset();
    }
    saveEstimatedPoses(folder_.path(""), there);
    const auto back = loadEstimatedPoses(folder_.path(""));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->places, there.places);
    EXPECT_EQ(back->trajectory.stamps, there.trajectory.stamps);
    for (std::size_t i = 0; i < there.places.size(); ++i)
      EXPECT_EQ(back->trajectory.poses[i].matrix(), there.trajectory.poses[i].matrix());
    EXPECT_EQ(back->up, there.up);
    EXPECT_EQ(back->verdict, there.verdict);
    ASSERT_EQ(back->noise.has_value(), has_noise);
    if (has_noise) {
      EXPECT_EQ(back->noise->length, there.noise->length);
      EXPECT_EQ(back->noise->turn_per_radian, there.noise->turn_per_radian);
    }
  }
}

TEST_F(PosesInAFolder, mayBeMissing)
{
  EXPECT_FALSE(loadEstimatedPoses(folder_.path("")));
}

TEST_F(PosesInAFolder, thatAreMalformedAreRefused)
{
  saveEstimatedPoses(folder_.path(""), sample());
  write("format: 1\nobservations: [0, 1]\n");
  EXPECT_THAT(fault(), HasSubstr("names 2 observations, trajectory.txt has 3 poses"));
  write("format: 1\nobservations: [0, 2, 1]\n");
  EXPECT_THAT(fault(), HasSubstr("line 2, column 22: '1' is refused"));
  write("format: 1\nobservations: [0, 1, 2]\nodometry_noise: [1, 2, -3, 4]\n");
  EXPECT_THAT(fault(), HasSubstr("line 3, column 24: '-3' is refused"));
  write("format: 2\nobservations: [0, 1, 2]\nverdict: perhaps\n");
  EXPECT_THAT(fault(), HasSubstr("perhaps"));
  write("format: 1\nobservations: []\n");
  EXPECT_THAT(fault(), HasSubstr("observations"));
  write("format: 3\nobservations: [0, 1, 2]\n");
  EXPECT_THAT(fault(), HasSubstr("written by a newer acmap"));
  write("format: 1\nobservations: [0, 1, 2]\nother: 1\n");
  EXPECT_THAT(fault(), HasSubstr("other"));
  write("format");
  EXPECT_THAT(fault(), HasSubstr("poses.yaml"));
  EstimatedPoses poses = sample();
  poses.places.pop_back();
  EXPECT_THROW(saveEstimatedPoses(folder_.path(""), poses), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
