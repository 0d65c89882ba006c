#include "bench.h"
#include "bench_data.h"
#include "plane_finders.h"
#include "plane_matches.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/moments.h>
#include <pcl/core/random.h>
#include <pcl/point_types.h>

#include <functional>
#include <map>
#include <memory>

namespace pcl::acmap::bench {
namespace {

/** Statistics of a subset of the true planes. */
struct PlaneSelection {
  FoundShare share;                    ///< of those with points
  std::vector<double> angles, offsets; ///< degrees and metres, of those found
  std::size_t points = 0, right = 0;   ///< correctly labelled

  void
  add(std::size_t t, const PlaneOverlaps& overlaps, const PlaneMatches& matches)
  {
    points += overlaps.truthSize(t);
    for (std::size_t f = 0; f < overlaps.founds(); ++f)
      if (overlaps.majority(f) == static_cast<std::int32_t>(t))
        right += overlaps.common(f, t);
    share += {matches.finder[t] < 0 ? 0U : 1U, 1};
    if (matches.finder[t] < 0)
      return;
    angles.push_back(matches.deviation[t].angle);
    offsets.push_back(matches.deviation[t].offset);
  }

  double
  labels() const
  {
    return percent(right, points);
  }
};

/** Quality of a plane detection. A true plane counts as found if a detected plane has
 * most of its points from it, and deviates by less than \ref MatchLimits. */
struct PlaneScores {
  PlaneSelection main;  ///< floor, ceiling, walls, ends
  PlaneSelection doors; ///< planes of doors
  PlaneSelection large; ///< all planes with at least \ref largeCount points
  PlaneSelection named; ///< main, door and large planes
  PlaneSelection all;
  std::size_t given = 0;      ///< detected planes, correct or not
  std::size_t spurious = 0;   ///< less than half from one true plane, or too large a
                              ///< deviation
  std::size_t duplicates = 0; ///< of planes that were found with more points
  double precision = 0;       ///< points assigned to a plane that belong to it, %
  double seconds = 0;
};

PlaneScores
scorePlanes(const PlaneCase& plane_case, const FoundPlanes& found)
{
  const std::vector<TruthPlane>& planes = plane_case.truth.planes;
  const PlaneOverlaps overlaps(
      plane_case.truth.labels, planes.size(), found.labels, found.planes.size());
  const PlaneMatches matches = matchPlanes(plane_case, found, overlaps);
  const std::size_t large_count = largeCount(plane_case.truth.labels.size());
  PlaneScores scores;
  for (std::size_t t = 0; t < planes.size(); ++t) {
    if (overlaps.truthSize(t) == 0)
      continue;
    const bool is_main = isMainPlane(planes[t]), is_door = isDoorPlane(planes[t]),
               is_large = overlaps.truthSize(t) >= large_count;
    for (const auto& [selection, is_in] :
         {std::pair{&scores.main, is_main},
          {&scores.doors, is_door},
          {&scores.large, is_large},
          {&scores.named, is_main || is_door || is_large},
          {&scores.all, true}})
      if (is_in)
        selection->add(t, overlaps, matches);
  }
  std::size_t right = 0, labelled = 0;
  for (std::size_t f = 0; f < overlaps.founds(); ++f) {
    const std::int32_t truth = overlaps.majority(f);
    right += truth >= 0 ? overlaps.common(f, static_cast<std::size_t>(truth)) : 0;
    labelled += overlaps.foundSize(f);
  }
  scores.precision = percent(right, labelled);
  scores.given = found.planes.size();
  scores.spurious = matches.spurious;
  scores.duplicates = matches.duplicates;
  scores.seconds = found.seconds;
  return scores;
}

/** Targets for acmap; every plane that counts should be found. */
struct PlaneReach {
  double spurious = no_reach;
  double angle = no_reach;  // degrees
  double offset = no_reach; // millimetres
  double labels = no_reach; // percent
  double seconds = no_reach;

  std::string
  judged(const FoundShare& share) const
  {
    const bool is_missed = !std::isnan(seconds) && share.found < share.there;
    return is_missed ? "**" + share.text() + "** (missed: all)" : share.text();
  }
};

void
printCase(const PlaneCase& plane_case, const PlaneReach& reach)
{
  const PlaneInput& input = plane_case.input;
  std::cout << "\n"
            << plane_case.name << ": " << input.points->size()
            << " points; measured sigma " << milli * input.sigma << " mm, spacing "
            << milli * input.spacing << " mm; tolerance of the peers "
            << milli * input.tolerance << " mm\n";
  std::vector<std::pair<const NamedFinder*, PlaneScores>> all;
  const std::vector<NamedFinder> finders = allFinders();
  for (const NamedFinder& finder : finders)
    if (input.points->size() <= finder.max_points)
      all.emplace_back(&finder, scorePlanes(plane_case, findPlanes(finder, input)));
  const auto reachOf = [&](const NamedFinder& finder) {
    return finder.is_ours ? reach : PlaneReach();
  };
  printHead("finder | planes given | main planes found | doors | planes with 0.3 % of "
            "the points | all planes | spurious | duplicates | CPU s");
  for (const auto& [finder, scores] : all) {
    const PlaneReach target = reachOf(*finder);
    Row() << finder->name << scores.given << target.judged(scores.main.share)
          << target.judged(scores.doors.share) << target.judged(scores.large.share)
          << scores.all.share.text() << atMost(scores.spurious, target.spurious, 0)
          << atMost(scores.duplicates, target.spurious, 0)
          << atMost(scores.seconds, target.seconds, 3);
  }
  printHead("finder | main planes: largest angle, degrees | mean | largest offset, mm "
            "| mean | all found: largest angle, degrees | mean | largest offset, mm | "
            "mean | labels right % | of all points % | of the labelled points %");
  for (const auto& [finder, scores] : all) {
    const PlaneReach target = reachOf(*finder);
    Row() << finder->name << atMost(largest(scores.main.angles), target.angle, 3)
          << figure(meanOf(scores.main.angles), 3)
          << atMost(milli * largest(scores.main.offsets), target.offset, 2)
          << figure(milli * meanOf(scores.main.offsets), 2)
          << figure(largest(scores.all.angles), 3)
          << figure(meanOf(scores.all.angles), 3)
          << figure(milli * largest(scores.all.offsets), 2)
          << figure(milli * meanOf(scores.all.offsets), 2)
          << atLeast(scores.named.labels(), target.labels, 2)
          << figure(scores.all.labels(), 2) << figure(scores.precision, 2);
  }
}

const Section view_section("view", [] {
  printCase(makePlaneCase(makeViewCloud(corridor().scene(), 0)),
            {0, 0.03, 0.1, 99.5, 0.060});
});

const Section views_section("views", [] {
  constexpr std::size_t last = 105, step = 7;
  const std::vector<NamedFinder> finders = allFinders();
  std::vector<std::vector<PlaneScores>> all(finders.size());
  for (std::size_t view = 0; view <= last; view += step) {
    const PlaneCase plane_case = makePlaneCase(makeViewCloud(corridor().scene(), view));
    for (std::size_t f = 0; f < finders.size(); ++f)
      all[f].push_back(scorePlanes(plane_case, finders[f].find(plane_case.input)));
  }
  printHead("finder | main planes found | planes with 0.3 % of the points | spurious | "
            "duplicates | main planes: largest angle, degrees | largest offset, mm | "
            "labels right % | CPU s a view");
  for (std::size_t f = 0; f < finders.size(); ++f) {
    FoundShare main, large;
    std::size_t spurious = 0, duplicates = 0;
    std::vector<double> angles, offsets, labels, seconds;
    for (const PlaneScores& view : all[f]) {
      main += view.main.share;
      large += view.large.share;
      spurious += view.spurious;
      duplicates += view.duplicates;
      const PlaneSelection& found = view.main;
      angles.insert(angles.end(), found.angles.begin(), found.angles.end());
      offsets.insert(offsets.end(), found.offsets.begin(), found.offsets.end());
      labels.push_back(view.named.labels());
      seconds.push_back(view.seconds);
    }
    Row() << finders[f].name << main.text() << large.text() << spurious << duplicates
          << figure(largest(angles), 3) << figure(milli * largest(offsets), 2)
          << figure(meanOf(labels), 2) << figure(meanOf(seconds), 3);
  }
});

const Section noisy_section("noisy", [] {
  constexpr double disparity_noise = 0.5; // px
  SimulatedScene scene = corridor().scene();
  scene.sensor.noise_growth =
      disparity_noise /
      (scene.rig.focal_length * std::abs(scene.rig.baseline_horizontal));
  scene.sensor.min_noise = 0;
  scene.sensor.max_noise = std::numeric_limits<double>::max();
  PlaneCase plane_case = makePlaneCase(makeViewCloud(scene, 0));
  plane_case.name += ", disparities with a noise of 0.5 px";
  printCase(plane_case, {});
});

const Section million_section("million", [] {
  printCase(makePlaneCase(makeRandomPart(corridor().whole(), 1000000, 1)),
            {0, 0.05, 0.5, 99, 0.6});
});

const Section whole_section("whole", [] {
  printCase(makePlaneCase(corridor().whole()), {0, 0.05, 0.5, 99, 12});
});

constexpr double grid = 0.01; // metres

/** Calls place (column, row), which gives the position of a point of a grid. */
template <typename Place>
void
addGrid(int columns, int rows, const Place& place, PointCloud<PointXYZ>& points)
{
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector3d p = place(grid * column, grid * row);
      points.emplace_back(static_cast<float>(p.x()),
                          static_cast<float>(p.y()),
                          static_cast<float>(p.z()));
    }
}

/** Two boards of 2 m by 1.5 m, one behind the other. */
PointCloud<PointXYZ>::Ptr
makeBoards(double noise)
{
  const auto points = std::make_shared<PointCloud<PointXYZ>>();
  Random random(1);
  for (const double z : {0.0, 0.12})
    addGrid(
        200,
        150,
        [&](double x, double y) {
          return Eigen::Vector3d(x, y, noise > 0 ? z + noise * random.normal() : z);
        },
        *points);
  return points;
}

/** A wall 4 m wide and 2.5 m high, curved with a radius of 8 m. */
PointCloud<PointXYZ>::Ptr
makeCurvedWall(double noise)
{
  constexpr double radius = 8;
  const auto points = std::make_shared<PointCloud<PointXYZ>>();
  Random random(1);
  addGrid(
      400,
      250,
      [&](double along, double y) {
        const double angle = (along - 2) / radius;
        const double range = radius + noise * random.normal();
        return Eigen::Vector3d(range * std::sin(angle), y, range * std::cos(angle));
      },
      *points);
  return points;
}

void
printShape(const std::string& name,
           std::size_t planes,
           const PointCloud<PointXYZ>::Ptr& points,
           double noise)
{
  const PlaneInput input{points, {}, {}, noise, grid, toleranceFor(noise)};
  for (const NamedFinder& finder : allFinders()) {
    const FoundPlanes found = findPlanes(finder, input);
    const std::string number = std::to_string(found.planes.size());
    const bool is_missed = finder.is_ours && found.planes.size() != planes;
    Row() << name << points->size() << planes << finder.name
          << (is_missed ? "**" + number + "** (missed: " + std::to_string(planes) + ")"
                        : number)
          << figure(found.labelledPercent(), 1) << figure(found.seconds, 3);
  }
}

const Section shapes_section("shapes", [] {
  constexpr double noise = 0.005;
  printHead("shape | points | planes | finder | found | points in them % | CPU s");
  printShape("two boards 12 cm apart, exact", 2, makeBoards(0), 0);
  printShape("two boards 12 cm apart, noise 5 mm", 2, makeBoards(noise), noise);
  printShape("curved wall, radius 8 m, noise 5 mm", 0, makeCurvedWall(noise), noise);
});

/** A cloud whose planes were annotated. */
struct AnnotatedCloud {
  PointCloud<PointXYZ>::Ptr points{new PointCloud<PointXYZ>};
  std::vector<std::int32_t> labels; ///< plane of each point, -1 for none
};

/** \param[in] mark returns the plane of a point */
template <typename PointT, typename Mark>
AnnotatedCloud
readMarked(const std::string& path, const Mark& mark)
{
  PointCloud<PointT> cloud;
  fromPCLPointCloud2(loadPointCloud(path).cloud, cloud);
  AnnotatedCloud marked;
  for (const PointT& point : cloud)
    if (point.getVector3fMap().allFinite()) {
      marked.points->emplace_back(point.x, point.y, point.z);
      marked.labels.push_back(mark(point));
    }
  return marked;
}

/** Least-squares planes through the points of each annotated plane. */
std::map<std::int32_t, PlaneFit>
fitMarkedPlanes(const AnnotatedCloud& cloud)
{
  std::map<std::int32_t, Moments> moments;
  for (std::size_t i = 0; i < cloud.labels.size(); ++i)
    if (cloud.labels[i] >= 0) {
      const Eigen::Vector3d p = (*cloud.points)[i].getVector3fMap().cast<double>();
      moments[cloud.labels[i]].addShifted(Moments{1}, p.x(), p.y(), p.z());
    }
  std::map<std::int32_t, PlaneFit> planes;
  for (const auto& [plane, sums] : moments)
    planes[plane] = fitPlane(sums);
  return planes;
}

/** RMS distance of the points from their plane, metres. */
double
deviationOf(const PlaneFit& plane)
{
  return std::sqrt(std::max(plane.variances[0], 0.0));
}

/** The SynPEB scans, whose intensity is the number of the plane. */
AnnotatedCloud
readSynpeb(const std::string& path)
{
  return readMarked<PointXYZI>(path, [](const PointXYZI& point) {
    return static_cast<std::int32_t>(std::lround(point.intensity));
  });
}

/** Labels are parts of a room, 0 for none. Parts count as planes if they have at least
 * 300 points and an RMS distance of less than 2 cm from their plane. */
AnnotatedCloud
readRoomParts(const std::string& path)
{
  AnnotatedCloud cloud = readMarked<PointXYZL>(path, [](const PointXYZL& point) {
    return static_cast<std::int32_t>(point.label) - 1;
  });
  const std::map<std::int32_t, PlaneFit> planes = fitMarkedPlanes(cloud);
  for (std::int32_t& label : cloud.labels)
    if (label >= 0 &&
        (planes.at(label).count < 300 || deviationOf(planes.at(label)) > 0.02))
      label = -1;
  return cloud;
}

struct CloudSource {
  const char* name;
  const char* path;
  AnnotatedCloud (*read)(const std::string& path);
  bool is_view; ///< observed from the origin; otherwise the sensors are unknown

  /** Tolerance of the peers in metres: the value between 2 and 20 mm that is best for
   * most of them. Planes of real sensors are warped by more than their noise, so that
   * three sigma would split them. */
  double tolerance;
};

constexpr CloudSource sources[] = {
    {"synpeb test_100", "F_planes/synpeb/test_100.pcd", readSynpeb, true, 0.0026},
    {"navvis room1",
     "F_planes/navvis_room1/room1_gt_fine.pcd",
     readRoomParts,
     false,
     0.02}};

void
printCloud(const CloudSource& source, const AnnotatedCloud& cloud)
{
  const std::size_t large_count = largeCount(cloud.labels.size());
  std::vector<Eigen::Vector3f> origins;
  if (source.is_view)
    origins.emplace_back(Eigen::Vector3f::Zero());
  PlaneInput input = makePlaneInput(cloud.points, origins, {});
  input.tolerance = source.tolerance;
  std::map<std::int32_t, std::int32_t> numbers{{-1, -1}}; // from 0, without gaps
  for (const auto& [plane, fit] : fitMarkedPlanes(cloud))
    numbers.emplace(plane, static_cast<std::int32_t>(numbers.size()) - 1);
  std::vector<std::int32_t> labels;
  for (const std::int32_t label : cloud.labels)
    labels.push_back(numbers[label]);
  const auto score = [&](const FoundPlanes& found) {
    return scoreSegments(
        PlaneOverlaps(labels, numbers.size() - 1, found.labels, found.planes.size()),
        large_count);
  };
  const std::vector<double> deviations = valuesOf(
      fitMarkedPlanes(cloud), [](auto& plane) { return deviationOf(plane.second); });
  FoundPlanes none;
  none.labels.assign(labels.size(), -1);
  const SegmentScores there = score(none);
  std::cout << "\n"
            << source.name << ": " << labels.size() << " points; " << there.truths
            << " marked planes, " << there.large << " with 0.3 % of the points, rms "
            << milli * median(deviations) << " (median) to "
            << milli * largest(deviations) << " mm; measured sigma "
            << milli * input.sigma << " mm, spacing " << milli * input.spacing
            << " mm; tolerance of the peers " << milli * input.tolerance << " mm\n";
  printHead("finder | planes given | correct | of them with 0.3 % | over-segmented | "
            "under-segmented | missed | noise | marked points right % | CPU s");
  std::vector<NamedFinder> finders = allFinders();
  finders.insert(finders.begin() + 1,
                 {"acmap, tolerance given", findAcmapPlanesWithin});
  for (const NamedFinder& finder : finders) {
    const FoundPlanes found = findPlanes(finder, input);
    const SegmentScores scores = score(found);
    Row() << finder.name << scores.given << scores.correct << scores.correct_large
          << scores.over << scores.under << scores.missed << scores.noise
          << figure(scores.labels, 1) << figure(found.seconds, 3);
  }
}

const Section real_section("real", [] {
  for (const CloudSource& source : sources)
    if (const auto path = pathOfData(source.path))
      printCloud(source, source.read(*path));
});

} // namespace
} // namespace pcl::acmap::bench
