#include "office_views.h"
#include "temporary_folder.h"
#include "thread_ranks.h"

#include <pcl/core/impl/byte_parcel.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/pipeline/ranked_work.h>

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** The office as files, mapped by several ranks that are threads. */
class RankedMapping : public OfficeViews {
protected:
  void
  SetUp() override
  {
    for (std::size_t i = 0; i < views; ++i)
      saveObservation(folder_.path(observationName(i)),
                      clouds_[i]->cloud,
                      Eigen::Isometry3d::Identity());
    saveTrajectory(folder_.path(trajectory_name), trajectory_);
  }

  /** \throws what rank 0 throws */
  CompactMap
  mapBy(std::size_t ranks, const std::function<void(CompactMapping&)>& change = {})
  {
    const auto mailboxes = std::make_shared<Mailboxes>();
    std::vector<std::thread> others;
    for (std::size_t rank = 1; rank < ranks; ++rank)
      others.emplace_back([=] {
        CompactMapping mapping;
        mapping.setRanks(std::make_shared<ThreadRanks>(rank, ranks, mailboxes));
        CompactMap none;
        mapping.compute(none);
        EXPECT_TRUE(none.planes.empty());
      });
    CompactMapping mapping;
    mapping.setRanks(std::make_shared<ThreadRanks>(0, ranks, mailboxes));
    mapping.setInputSequence(ObservationSequence(folder_.path("")), true);
    if (change)
      change(mapping);
    CompactMap map;
    std::exception_ptr fault;
    try {
      mapping.compute(map);
    }
    catch (...) {
      fault = std::current_exception();
    }
    for (std::thread& other : others)
      other.join();
    EXPECT_TRUE(mailboxes->isEmpty());
    if (fault)
      std::rethrow_exception(fault);
    report_ = mapping.getReport();
    return map;
  }

  void
  spoil(std::size_t observation) const
  {
    std::ofstream(folder_.path(observationName(observation))) << "no PCD";
  }

  TemporaryFolder folder_;
  CompactMappingReport report_;
};

TEST_F(RankedMapping, GivesTheSameMapByAnyNumberOfRanks)
{
  const CompactMap alone = mapBy(1);
  EXPECT_EQ(report_.ranks, 1U);
  const MergingReport merging = report_.merging;
  const TexturingReport texture = report_.texture;
  for (const std::size_t ranks : {std::size_t{2}, std::size_t{3}, views + 2}) {
    expectSame(mapBy(ranks), alone);
    EXPECT_EQ(report_.ranks, ranks);
    EXPECT_GT(report_.rank_bytes, 20 * merging.points / ranks);
    EXPECT_EQ(report_.merging.points, merging.points);
    EXPECT_EQ(report_.merging.refined, merging.refined);
    EXPECT_EQ(report_.merging.remarks, merging.remarks);
    EXPECT_EQ(report_.texture.colored_points, texture.colored_points);
    EXPECT_EQ(report_.texture.invalid_points, texture.invalid_points);
    EXPECT_EQ(report_.texture.gains, texture.gains);
  }
}

TEST_F(RankedMapping, PaintsAsThePaperDoes)
{
  const auto paper = [](CompactMapping& mapping) {
    CompactMapping::Texturing texturing = mapping.getTexturing();
    texturing.setPaperMode(true);
    mapping.setTexturing(texturing);
  };
  expectSame(mapBy(2, paper), mapBy(1, paper));
}

TEST_F(RankedMapping, KeepsTheMaximumOfPoints)
{
  const auto few = [](CompactMapping& mapping) {
    ObservationMerging merging = mapping.getMerging();
    merging.setMaximumPoints(20000);
    mapping.setMerging(merging);
  };
  const CompactMap alone = mapBy(1, few);
  EXPECT_GT(report_.merging.every, 1U);
  expectSame(mapBy(2, few), alone);
}

TEST_F(RankedMapping, ThrowsWhatARankThrows)
{
  spoil(views - 1);
  EXPECT_THAT(
      [&] { mapBy(2); },
      testing::ThrowsMessage<InputFileException>(HasSubstr(observationName(views - 1))))
      << "a broken observation was not noticed";
}

TEST_F(RankedMapping, LeavesBrokenObservationsOfARankOut)
{
  spoil(views - 1);
  const auto skip = [](CompactMapping& mapping) { mapping.setSkipBroken(true); };
  const CompactMap alone = mapBy(1, skip);
  EXPECT_EQ(alone.trajectory.poses.size(), views - 1);
  expectSame(mapBy(2, skip), alone);
}

TEST_F(RankedMapping, EndsWithAnErrorOfRank0)
{
  const auto cancel = [](CompactMapping& mapping) {
    mapping.setProgressCallback(
        [](double done, const std::string&) { return done < 0.7; });
  };
  EXPECT_THROW(mapBy(3, cancel), CancelledException);
}

TEST_F(RankedMapping, PointsOfCloudsInMemoryAreShared)
{
  const CompactMap alone = mapBy(1);
  const auto hold = [&](CompactMapping& mapping) {
    mapping.setInputSequence(
        ObservationSequence({clouds_.begin(), clouds_.end()}, trajectory_), true);
  };
  expectSame(mapBy(2, hold), alone);
  EXPECT_EQ(report_.ranks, 2U);
  EXPECT_THAT(report_.remarks,
              testing::Contains(HasSubstr("rank 0 reads and paints alone")));
}

/** Planes of a cloud, found by several ranks that are threads. */
MappedPlanes
planesBy(std::size_t ranks, const MergedCloud& cloud)
{
  const auto mailboxes = std::make_shared<Mailboxes>();
  std::vector<std::thread> others;
  for (std::size_t rank = 1; rank < ranks; ++rank)
    others.emplace_back([=] {
      ThreadRanks served(rank, ranks, mailboxes);
      serveRanks(served);
    });
  const auto leading = std::make_shared<ThreadRanks>(0, ranks, mailboxes);
  PlaneMapping planes;
  planes.setInputCloud(cloud.cloud);
  planes.setViewpoints(cloud.viewpoints);
  planes.setRanks(leading);
  MappedPlanes found;
  planes.compute(found);
  endRanks(*leading);
  for (std::thread& other : others)
    other.join();
  EXPECT_EQ(leading->getNumberOfMessages() > ranks, ranks > 1);
  EXPECT_TRUE(mailboxes->isEmpty());
  return found;
}

void
expectSamePlanes(const MappedPlanes& a, const MappedPlanes& b)
{
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    EXPECT_EQ(a.planes[i].coefficients, b.planes[i].coefficients);
    EXPECT_EQ(a.planes[i].covariance, b.planes[i].covariance);
  }
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.finite_points, b.finite_points);
}

TEST_F(RankedMapping, SharesThePointsOfOneCloud)
{
  MergedCloud merged;
  ObservationMerging().compute(
      ObservationSequence({clouds_.begin(), clouds_.end()}, trajectory_), merged);
  PCLPointCloud2 cloud = merged.cloud.copy();
  // some are not finite, some are at the origin
  const Eigen::Vector3f nowhere = Eigen::Vector3f::Constant(std::nanf(""));
  const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < merged.cloud.size(); i += 50)
    std::memcpy(&cloud.data[i * cloud.point_step],
                (i % 100 == 0 ? nowhere : zero).data(),
                sizeof zero);
  merged.cloud = CloudRows(std::make_shared<PCLPointCloud2>(cloud));
  const MappedPlanes alone = planesBy(1, merged);
  EXPECT_GT(alone.planes.size(), 3U);
  for (const std::size_t ranks : {2, 5})
    expectSamePlanes(planesBy(ranks, merged), alone);
  for (PCLPointField& field : cloud.fields)
    if (field.name == "view")
      field.name = "other";
  merged.cloud = CloudRows(std::make_shared<PCLPointCloud2>(std::move(cloud)));
  merged.viewpoints.clear();
  expectSamePlanes(planesBy(3, merged), planesBy(1, merged));
}

TEST(ByteParcel, TellsThatAMessageEndsEarly)
{
  ByteParcel lying;
  lying.put(std::size_t{1} << 40);
  lying.put('a');
  EXPECT_THROW(lying.takeText(), IOException);
  ByteParcel parcel;
  parcel.putText("abc");
  parcel.takeText();
  EXPECT_EQ(parcel.left(), 0U);
  EXPECT_THROW(parcel.take<std::int32_t>(), IOException);
}

/** The rows of a grid of points, every 100th of which is not finite. */
PointCloudFile
gridOf(int points)
{
  PointCloud<PointXYZRGB> cloud;
  for (int i = 0; i < points; ++i) {
    PointXYZRGB point;
    point.x =
        i % 100 == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i);
    cloud.push_back(point);
  }
  PointCloudFile file;
  toPCLPointCloud2(cloud, file.cloud);
  return file;
}

/** Whether rows come as observations or as rows of another object. */
TEST(MapRowsOfRanks, AreThinnedAsObservationsAre)
{
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const std::size_t maximum : {100000, 5000, 700, 3}) {
    MapRows whole(0, true), parts(0, true), other(0, true);
    whole.setMaximum(maximum);
    parts.setMaximum(maximum);
    const PointCloudFile first = gridOf(3001), second = gridOf(2222);
    whole.append(first, pose, 0);
    whole.append(second, pose, 1);
    whole.append(first, pose, 2);
    parts.append(first, pose, 0);
    other.append(second, pose, 0);
    other.append(first, pose, 1);
    const CloudRows rows = other.finish();
    parts.appendRows({rows.data(), rows.data() + rows.bytes()}, 1);
    EXPECT_EQ(parts.every(), whole.every());
    const CloudRows expected = whole.finish(), found = parts.finish();
    ASSERT_EQ(found.bytes(), expected.bytes());
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.bytes()), 0);
  }
}

} // namespace
} // namespace pcl::acmap::test
