#include "house_map.h"

#include <pcl/pipeline/map_quality.h>
#include <pcl/pipeline/plane_sightings.h>
#include <pcl/pipeline/unseen_surfaces.h>

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** A room of 5 x 4 m, 2.5 m high, z up; planes 0 to 5 are floor, ceiling and walls. */
CompactMap
makeRoom(double seen_ceiling = 5)
{
  CompactMap map;
  map.up = Vector3d::UnitZ();
  addPlane(map, level({0, 0}, {5, 4}, 0, true));
  addPlane(map, level({0, 0}, {seen_ceiling, 4}, 2.5, false));
  addPlane(map, upright({0, 4}, {0, 0}, 0, 2.5));
  addPlane(map, upright({0, 0}, {5, 0}, 0, 2.5));
  addPlane(map, upright({5, 0}, {5, 4}, 0, 2.5));
  addPlane(map, upright({5, 4}, {0, 4}, 0, 2.5));
  return named(map);
}

UnseenSurfaces
unseenOf(const CompactMap& map)
{
  return findUnseenSurfaces(map, makeFloorPlan(map));
}

TEST(UnseenSurfaces, AreNoneInARoomThatWasSeen)
{
  const UnseenSurfaces unseen = unseenOf(makeRoom());
  EXPECT_NEAR(unseen.seen_area, 2 * 20 + 18 * 2.5, 4);
  EXPECT_LT(unseen.unseen_area, 1);
  EXPECT_GT(unseen.seenShare(), 0.98);
}

TEST(UnseenSurfaces, AreTheCeilingThatWasNotSeen)
{
  const UnseenSurfaces unseen = unseenOf(makeRoom(3));
  EXPECT_NEAR(unseen.unseen_area, 8, 1.2);
  for (const UnseenPatch& patch : unseen.patches)
    if (patch.role == SurfaceRole::Ceiling) {
      EXPECT_GT(patch.center.x(), 2.7);
      EXPECT_NEAR(patch.center.z(), 2.5, 1e-6);
      EXPECT_LT(patch.normal.z(), -0.99);
    }
}

TEST(UnseenSurfaces, OfAMapWithoutARoomAreUnknown)
{
  EXPECT_TRUE(std::isnan(unseenOf(CompactMap()).seenShare()));
  CompactMap broken = makeRoom();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  broken.planes[3].coefficients.setConstant(nan);
  broken.planes[4].polygons[0].outer[1].setConstant(static_cast<float>(nan));
  EXPECT_LT(unseenOf(broken).seenShare(), 0.9);
}

/** Points of a cloud with views. */
struct SeenPoint {
  float x, y, z;
  std::int32_t view;
};

/** What observations saw of planes of a map: each one square of 0.1 m spacing, moved along its
 * normal. */
class Observed {
public:
  explicit Observed(const CompactMap& map)
  : map_(map)
  {}

  void
  see(std::size_t plane, std::int32_t view, double from, double to, double moved)
  {
    const PlanePatch& one = map_.planes[plane];
    for (double u = from; u < to; u += 0.05)
      for (double v = -1; v < 1; v += 0.05) {
        const Vector3d place = one.center + u * one.axis_u + v * one.axis_v +
                               moved * one.coefficients.head<3>();
        points_.push_back({static_cast<float>(place.x()),
                           static_cast<float>(place.y()),
                           static_cast<float>(place.z()),
                           view});
        labels_.push_back(static_cast<std::int32_t>(plane));
      }
  }

  PlaneSightings
  sightings(const std::vector<Eigen::Vector3f>& sensors) const
  {
    PCLPointCloud2 cloud;
    cloud.height = 1;
    cloud.width = static_cast<std::uint32_t>(points_.size());
    cloud.point_step = sizeof(SeenPoint);
    cloud.row_step = cloud.width * cloud.point_step;
    for (const auto& [name, offset, type] :
         {std::tuple("x", 0, PCLPointField::FLOAT32),
          std::tuple("y", 4, PCLPointField::FLOAT32),
          std::tuple("z", 8, PCLPointField::FLOAT32),
          std::tuple("view", 12, PCLPointField::INT32)}) {
      PCLPointField field;
      field.name = name;
      field.offset = static_cast<std::uint32_t>(offset);
      field.datatype = static_cast<std::uint8_t>(type);
      field.count = 1;
      cloud.fields.push_back(field);
    }
    cloud.data.resize(points_.size() * sizeof(SeenPoint));
    std::memcpy(cloud.data.data(), points_.data(), cloud.data.size());
    PointLabels labels;
    labels.resize(labels_.size());
    std::copy(labels_.begin(), labels_.end(), labels.begin());
    return collectSightings(CloudRows::of(cloud), labels, map_.planes, sensors);
  }

private:
  const CompactMap& map_;
  std::vector<SeenPoint> points_;
  std::vector<std::int32_t> labels_;
};

const std::vector<Eigen::Vector3f> two_sensors(2, {2.5F, 2, 1.2F});

/** Two observations that see the middle of all planes, and differ by this along the normals. */
MapQualityReport
qualityOf(const CompactMap& map,
          double apart,
          const std::optional<VerdictOutcome>& verdict = {},
          double begin_of_second = -1,
          double end_of_second = 1)
{
  Observed observed(map);
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane) {
    observed.see(plane, 0, -1, 1, -apart / 2);
    observed.see(plane, 1, begin_of_second, end_of_second, apart / 2);
  }
  return assessMapQuality(map, observed.sightings(two_sensors), unseenOf(map), verdict);
}

TEST(MapQuality, IsGoodWhereObservationsAgree)
{
  const MapQualityReport report = qualityOf(makeRoom(), 0);
  EXPECT_EQ(report.outcome, MapQualityOutcome::Good) << report.sentence;
  EXPECT_LT(report.sharpness.value, 1e-4);
  EXPECT_GT(report.coverage.value, 0.95);
  EXPECT_EQ(report.rays.value, 1);
  EXPECT_EQ(report.overlap.value, 1);
  EXPECT_THAT(describeQuality(report), testing::StartsWith("Good: "));
}

TEST(MapQuality, TellsHowFarObservationsAreApart)
{
  for (const double apart : {0.006, 0.08}) {
    const MapQualityReport report = qualityOf(makeRoom(), apart);
    EXPECT_NEAR(report.sharpness.value, apart / std::sqrt(2), 0.1 * apart);
    EXPECT_NEAR(report.roughness[2], apart / 2, 0.1 * apart);
    EXPECT_EQ(report.outcome,
              apart < 0.01 ? MapQualityOutcome::Usable : MapQualityOutcome::NotUsable);
    EXPECT_THAT(report.sentence, HasSubstr(apart < 0.01 ? "4.2 mm" : "57 mm"));
  }
}

TEST(MapQuality, ObeysTheVerdictOnThePoses)
{
  const CompactMap room = makeRoom();
  EXPECT_EQ(qualityOf(room, 0, VerdictOutcome::Contradicted).outcome,
            MapQualityOutcome::NotUsable);
  EXPECT_EQ(qualityOf(room, 0, VerdictOutcome::Undetermined).outcome,
            MapQualityOutcome::Good);
}

TEST(MapQuality, IsUndeterminedWithoutOverlap)
{
  const MapQualityReport report = qualityOf(makeRoom(), 0, {}, 1.25, 1.95);
  EXPECT_EQ(report.outcome, MapQualityOutcome::Undetermined);
  EXPECT_EQ(report.overlap.value, 0);
  EXPECT_THAT(report.sentence, HasSubstr("observation 1"));
}

TEST(MapQuality, NamesTheObservationThatIsJoinedWorst)
{
  const CompactMap room = makeRoom();
  Observed observed(room);
  for (std::int32_t view = 0; view < 4; ++view)
    observed.see(3, view, -2 + 0.5 * view, -1 + 0.5 * view, 0);
  observed.see(3, 4, 0.3, 2.4, 0); // hardly sees what the one before it saw
  const MapQualityReport report =
      assessMapQuality(room,
                       observed.sightings(std::vector<Eigen::Vector3f>(
                           5, Eigen::Vector3f(2.5F, 2, 1.2F))),
                       unseenOf(room),
                       {});
  EXPECT_EQ(report.weakest_observation, 4U);
  EXPECT_LT(report.overlap.value, 0.25);
  EXPECT_GT(report.overlap.value, 0);
}

TEST(MapQuality, CountsRaysThatPassThroughSurfaces)
{
  CompactMap room = makeRoom();
  Observed observed(room);
  for (std::size_t plane = 0; plane < room.planes.size(); ++plane)
    observed.see(plane, 0, -1, 1, 0);
  // the second sensor stands behind wall 3 and sees wall 5 through it
  observed.see(5, 1, -1, 1, 0);
  const MapQualityReport report =
      assessMapQuality(room,
                       observed.sightings({{2.5F, 2, 1.2F}, {2.5F, -1, 1.2F}}),
                       unseenOf(room),
                       {});
  EXPECT_NEAR(report.rays.value, 6.0 / 7, 0.05);
  EXPECT_EQ(report.outcome, MapQualityOutcome::NotUsable);
  EXPECT_THAT(report.sentence, HasSubstr("pass through surfaces"));
}

TEST(MapQuality, IsUsableWhereLittleWasSeen)
{
  CompactMap room = makeRoom();
  room.planes.resize(3);
  room = named(room);
  const MapQualityReport report = qualityOf(room, 0);
  EXPECT_EQ(report.outcome, MapQualityOutcome::Usable);
  EXPECT_THAT(report.sentence, HasSubstr("only"));
}

TEST(MapQuality, OfNothingIsUndetermined)
{
  const MapQualityReport report =
      assessMapQuality(CompactMap(), PlaneSightings(), UnseenSurfaces(), {});
  EXPECT_EQ(report.outcome, MapQualityOutcome::Undetermined);
  EXPECT_FALSE(report.sentence.empty());
}

} // namespace
} // namespace pcl::acmap::test
