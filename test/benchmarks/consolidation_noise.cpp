#include "bench.h"
#include "bench_data.h"
#include "meshes.h"
#include "processes.h"
#include "simulated_clouds.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/filters/approximate_voxel_grid.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/filters/voxel_grid.h>

#include <functional>
#include <iomanip>
#include <map>
#include <unordered_map>

namespace pcl::acmap::bench {
namespace {

/** \brief The true noise of a simulated cloud, metres: each point is compared with the
 * plane of its label. */
struct NoiseTruth {
  /** \brief Median over the surface of the standard deviation across it, in square
   * cells of 10 cm, or larger ones if needed for 16 points on average; cells with
   * fewer than 9 points are ignored. */
  double sigma = 0;

  double spacing = 0; ///< square root of the visible area per point

  /** \brief RMS along the ray, by distance to the sensor. The bins are those of
   * NoiseScale, with twice the binary logarithm of their minimum distance as key. */
  std::map<int, double> ranges;
};

struct SquareSum {
  std::size_t count = 0;
  double sum = 0;

  void
  add(double value)
  {
    ++count;
    sum += value * value;
  }

  double
  root() const
  {
    return std::sqrt(sum / static_cast<double>(count));
  }
};

std::uint64_t
cellKey(const TruthPlane& plane,
        std::uint32_t label,
        const Eigen::Vector3d& point,
        double edge)
{
  constexpr double middle = 1 << 23; // keeps both indices positive
  const SimulatedRectangle& rectangle = plane.rectangles.front();
  const Eigen::Vector3d offset = point - rectangle.corner;
  const double u = std::floor(offset.dot(rectangle.edge_u.normalized()) / edge);
  const double v = std::floor(offset.dot(rectangle.edge_v.normalized()) / edge);
  return std::uint64_t{label} << 48 | static_cast<std::uint64_t>(u + middle) << 24 |
         static_cast<std::uint64_t>(v + middle);
}

double
medianOfCells(const std::unordered_map<std::uint64_t, SquareSum>& cells)
{
  constexpr std::size_t min_points = 9;
  std::vector<double> deviations;
  for (const auto& [key, cell] : cells)
    if (cell.count >= min_points)
      deviations.push_back(cell.root());
  return median(deviations);
}

/** \brief The bin of a distance in metres. */
int
rangeBin(double distance)
{
  return static_cast<int>(std::floor(2 * std::log2(distance)));
}

NoiseTruth
measureTruth(const SimulatedCloud& cloud, double visible_area)
{
  constexpr double min_edge = 0.1;
  constexpr double points_of_an_edge = 4;
  NoiseTruth truth;
  truth.spacing = std::sqrt(visible_area / static_cast<double>(cloud.size()));
  const double edge = std::max(min_edge, points_of_an_edge * truth.spacing);
  std::unordered_map<std::uint64_t, SquareSum> cells;
  std::map<int, SquareSum> ranges;
  const std::vector<Eigen::Vector3f> origins = cloud.sensorOrigins();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t label = cloud.merged.label[i];
    if (label == 0)
      continue;
    const TruthPlane& plane = cloud.merged.planes[label - 1];
    const Eigen::Vector3d normal = plane.coefficients.head<3>();
    const Eigen::Vector3d point = cloud.merged.points[i].cast<double>();
    const double height = normal.dot(point) + plane.coefficients[3];
    cells[cellKey(plane, label, point, edge)].add(height);
    const auto view = static_cast<std::size_t>(cloud.merged.view[i]);
    const Eigen::Vector3d ray = point - origins[view].cast<double>();
    ranges[rangeBin(ray.norm())].add(height / normal.dot(ray.normalized()));
  }
  truth.sigma = medianOfCells(cells);
  for (const auto& [bin, sum] : ranges)
    truth.ranges[bin] = sum.root();
  return truth;
}

constexpr double noise_reach = 15; // percent

double
deviation(double measured, double truth)
{
  return 100 * (measured / truth - 1);
}

/** A measured cloud of the corridor. */
struct MeasuredNoise {
  MeasuredNoise(const SimulatedCloud& cloud, double visible_area)
  : name(cloud.name)
  , scale(measureNoiseScale(cloud.points(), cloud.sensors(), 1))
  , truth(measureTruth(cloud, visible_area))
  {}

  std::string name;
  NoiseScale scale;
  NoiseTruth truth;
};

const Section corridor_section("noise", [] {
  std::vector<MeasuredNoise> all;
  for (const std::size_t view : {0, 40, 53})
    all.emplace_back(makeViewCloud(corridor().scene(), view),
                     corridor().truthOfView(view).visibleArea());
  const double area = corridor().wholeTruth().visibleArea();
  for (const std::size_t size : {100000, 1000000})
    all.emplace_back(makeRandomPart(corridor().whole(), size, size), area);
  all.emplace_back(corridor().whole(), area);
  printHead("cloud | sigma, true mm | measured | off by % | spacing, true mm | "
            "measured | off by % | confidence");
  for (const MeasuredNoise& one : all)
    Row() << one.name << figure(milli * one.truth.sigma, 2)
          << figure(milli * one.scale.sigma, 2)
          << within(deviation(one.scale.sigma, one.truth.sigma), noise_reach, 1)
          << figure(milli * one.truth.spacing, 1)
          << figure(milli * one.scale.spacing, 1)
          << within(deviation(one.scale.spacing, one.truth.spacing), noise_reach, 1)
          << figure(one.scale.confidence, 2);
  printHead("cloud | distance, m | along the ray, true mm | measured | off by %");
  for (const MeasuredNoise& one : all)
    for (const NoiseScale::Range& range : one.scale.ranges) {
      const double truth = one.truth.ranges.at(rangeBin(range.distance));
      Row() << one.name << figure(range.distance, 2) << figure(milli * truth, 2)
            << figure(milli * range.sigma, 2)
            << within(deviation(range.sigma, truth), noise_reach, 1);
    }
});

/** A real cloud to test NoiseScale. */
struct NoiseCloud {
  const char* name;
  const char* path;
  bool is_view;  ///< observed from its viewpoint; otherwise the sensors are unknown
  bool is_exact; ///< a noise-free model
};

constexpr NoiseCloud clouds[] = {
    {"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd", true, false},
    {"office1", "E_meshing/office1.pcd", true, false},
    {"capture0001", "E_meshing/capture0001.pcd", true, false},
    {"bun0", "E_meshing/bun0.pcd", false, false},
    {"stanford-bunny", "E_meshing/stanford-bunny.obj", false, false},
    {"fandisk", "E_meshing/fandisk.obj", false, true},
    {"room_scan1", "C_sequence/pcl_room_scans/room_scan1.pcd", false, false},
    {"grenoble_room", "D_large/grenoble_room_5.2M.ply.xz", false, false},
    {"wtc37_corridor", "D_large/wtc37_corridor_1M.ply.xz", false, false},
};

std::size_t
countFinite(const PointView& points)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    count += points[i].allFinite();
  return count;
}

std::string
textOf(const std::vector<NoiseScale::Range>& ranges)
{
  std::ostringstream text;
  text << std::setprecision(2);
  for (const NoiseScale::Range& range : ranges)
    text << (text.tellp() > 0 ? ", " : "") << 1000 * range.sigma << " at "
         << range.distance << " m";
  return text.str();
}

std::string
verdictOf(const NoiseCloud& cloud, const NoiseScale& scale)
{
  std::string verdict;
  if (cloud.is_exact)
    verdict = scale.hasNoise() ? "**noise** (missed: none)" : "no noise (a model)";
  for (const std::string& remark : scale.remarks)
    verdict += (verdict.empty() ? "" : "; ") + remark;
  return verdict;
}

const Section real_section("noise", [] {
  printHead("real cloud | points | sigma, mm | spacing, mm | where sparse, mm | "
            "confidence | along the ray, mm | remarks");
  for (const NoiseCloud& cloud : clouds)
    if (const auto path = pathOfData(cloud.path)) {
      const PointCloudFile file = loadMaybePacked(*path);
      const PointView points = file.points();
      const SensorView sensors =
          cloud.is_view ? SensorView(file.sensor_origin) : SensorView();
      const NoiseScale scale = measureNoiseScale(points, sensors, 1);
      Row() << cloud.name << countFinite(points) << figure(milli * scale.sigma, 3)
            << figure(milli * scale.spacing, 2)
            << figure(milli * scale.sparse_spacing, 2) << figure(scale.confidence, 2)
            << textOf(scale.ranges) << verdictOf(cloud, scale);
    }
});

template <typename PointT>
std::size_t
consolidateCloud(const typename PointCloud<PointT>::Ptr& input,
                 const SimulatedCloud& cloud,
                 double voxel)
{
  VoxelConsolidation<PointT> consolidation;
  consolidation.setVoxelSize(voxel);
  consolidation.setNumberOfThreads(1);
  consolidation.setViewpoints(cloud.sensorOrigins());
  consolidation.setInputCloud(input);
  PointCloud<PointT> output;
  consolidation.filter(output);
  return output.size();
}

template <typename Grid>
std::size_t
downsample(const PointCloud<PointXYZ>::Ptr& input)
{
  constexpr float leaf = 0.05f; // metres
  Grid grid;
  grid.setLeafSize(leaf, leaf, leaf);
  grid.setInputCloud(input);
  PointCloud<PointXYZ> output;
  grid.filter(output);
  return output.size();
}

std::size_t
readAndSum(const PointCloud<PointXYZ>& cloud)
{
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  for (const PointXYZ& point : cloud)
    sum += point.getVector4fMap();
  return sum.allFinite() ? 1 : 0;
}

/** A timed function; returns its number of points or triangles. */
struct Timed {
  std::string name;
  double reach; ///< us per point
  std::function<std::size_t()> run;
  std::size_t result = 0;
  std::vector<double> seconds = {};
};

std::vector<Timed>
allTimed(const SimulatedCloud& cloud)
{
  const auto plain = plainPoints(cloud);
  const auto map = mapPoints(cloud);
  std::vector<Timed> all;
  const auto add = [&](const std::string& name, double reach, const auto& run) {
    all.push_back({name, reach, run});
  };
  for (const double voxel : {0.05, 0.0}) {
    const std::string size = ", " + voxelName(voxel);
    add("VoxelConsolidation, colour and view" + size, 0.2, [=, &cloud] {
      return consolidateCloud<PointXYZRGBNormalView>(map, cloud, voxel);
    });
    add("VoxelConsolidation, PointXYZ" + size, 0.2, [=, &cloud] {
      return consolidateCloud<PointXYZ>(plain, cloud, voxel);
    });
    ConsolidationReport report;
    const auto consolidation =
        std::make_shared<Consolidation>(consolidate(cloud, voxel, report));
    add("mesh of the representatives" + size,
        no_reach,
        [consolidation, edge = report.voxel_size] {
          return meshOf(*consolidation, edge).triangles.size();
        });
  }
  add("NoiseScale alone", no_reach, [&cloud] {
    measureNoiseScale(cloud.points(), cloud.sensors(), 1);
    return std::size_t{1};
  });
  add("PCL VoxelGrid, 5 cm, PointXYZ", no_reach, [=] {
    return downsample<VoxelGrid<PointXYZ>>(plain);
  });
  add("PCL ApproximateVoxelGrid, 5 cm, PointXYZ", no_reach, [=] {
    return downsample<ApproximateVoxelGrid<PointXYZ>>(plain);
  });
  add("lower bound: read and sum, PointXYZ", no_reach, [=] {
    return readAndSum(*plain);
  });
  return all;
}

void
printTimes(const SimulatedCloud& cloud, std::size_t rounds)
{
  std::vector<Timed> all = allTimed(cloud);
  for (std::size_t round = 0; round < rounds; ++round)
    for (Timed& one : all)
      one.seconds.push_back(measureThread([&] { one.result = one.run(); }));
  const double micro = 1e6 / static_cast<double>(cloud.size());
  for (const Timed& one : all)
    Row() << cloud.name << cloud.size() << one.name << one.result
          << atMost(micro * median(one.seconds), one.reach, 4);
}

const Section time_section("time", [] {
  constexpr std::size_t rounds = 5, few_rounds = 3;
  printHead("cloud | points | what | points or triangles out | CPU us a point");
  printTimes(makeViewCloud(corridor().scene(), 0), rounds);
  printTimes(makeRandomPart(corridor().whole(), 1000000, 1000000), rounds);
  printTimes(corridor().whole(), few_rounds);
});

/** \param[in] run returns the number of points of the output
 * \param[in] cells counts them, after the run */
template <typename Run, typename Cells>
void
printMemory(const std::string& name,
            std::size_t point_bytes,
            const Run& run,
            const Cells& cells)
{
  constexpr double mega = 1e6, cell_bytes = 112;
  const PeakMemory memory;
  const auto output = static_cast<double>(run() * point_bytes);
  const auto peak = static_cast<double>(memory.bytes());
  const auto count = static_cast<double>(cells());
  const double allowed = output + count * cell_bytes;
  Row() << name << figure(output / mega, 1) << figure(count, 0)
        << figure(allowed / mega, 1) << atMost(peak / mega, allowed / mega, 1);
}

const Section memory_section("time", [] {
  printHead("what | output, MB | cells | output and cells, MB | peak on top, MB");
  const SimulatedCloud& cloud = corridor().whole();
  for (const double voxel : {0.05, 0.0}) {
    ConsolidationReport report;
    const auto cells = [&] {
      return sumVoxels(cloud.points(), cloud.sensors(), report.voxel_size, 1)
          .cells.size();
    };
    printMemory(
        "kernel, " + voxelName(voxel),
        sizeof(Representative),
        [&] { return consolidate(cloud, voxel, report).representatives.size(); },
        cells);
    const auto map = mapPoints(cloud);
    printMemory(
        "VoxelConsolidation, colour and view, " + voxelName(voxel),
        sizeof(PointXYZRGBNormalView),
        [&] { return consolidateCloud<PointXYZRGBNormalView>(map, cloud, voxel); },
        cells);
  }
});

} // namespace
} // namespace pcl::acmap::bench
