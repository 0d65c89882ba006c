#include "annotated_clouds.h"

#include "annotated_files.h"
#include "bench_data.h"
#include "statistics.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

struct CloudSource {
  const char* name;
  const char* path;
  MarkedPoints (*read)(const std::string& path);
  bool is_view; ///< observed from the origin; otherwise the sensors are unknown

  /** Tolerance of the peers in metres: the value between 2 and 20 mm that is best for
   * most of them. Planes of real sensors are warped by more than their noise, so that
   * three sigma would split them. */
  double tolerance;
};

constexpr CloudSource sources[] = {
    {"synpeb test_100", "F_planes/synpeb/test_100.pcd", readSynpeb, true, 0.0026},
    {"mosd learn0", "F_planes/mosd/learn0.pcd", readTable, true, 0.01},
    {"mosd learn5", "F_planes/mosd/learn5.pcd", readTable, true, 0.01},
    {"navvis room1",
     "F_planes/navvis_room1/room1_gt_fine.pcd",
     readRoomParts,
     false,
     0.02},
    {"ICL-NUIM", "F_planes/iclnuim_planes/depth.png", readIclnuim, true, 0.005},
};

/** Consecutive numbers from 0 in the order in which planes appear. */
class LabelNumbering {
public:
  std::int32_t
  operator()(std::int32_t plane)
  {
    if (plane < 0)
      return -1;
    const auto next = static_cast<std::int32_t>(numbers_.size());
    return numbers_.emplace(plane, next).first->second;
  }

  std::size_t
  size() const
  {
    return numbers_.size();
  }

private:
  std::map<std::int32_t, std::int32_t> numbers_;
};

AnnotatedCloud
makeCloud(const CloudSource& source, const MarkedPoints& marked)
{
  AnnotatedCloud cloud;
  cloud.name = source.name;
  const auto points = std::make_shared<PointCloud<PointXYZ>>();
  LabelNumbering numbers;
  for (const MarkedPoint& point : marked)
    if (point.place.allFinite()) {
      points->emplace_back(point.place.x(), point.place.y(), point.place.z());
      cloud.labels.push_back(numbers(point.plane));
    }
  std::vector<Eigen::Vector3f> origins;
  if (source.is_view)
    origins.emplace_back(Eigen::Vector3f::Zero());
  cloud.input = makePlaneInput(points, origins, {});
  cloud.input.tolerance = source.tolerance;
  cloud.planes = numbers.size();
  std::vector<double> deviations;
  for (const PlaneFit& plane : fitMarkedPlanes(marked))
    if (plane.count > 0)
      deviations.push_back(deviationOf(plane));
  cloud.median_rms = median(deviations);
  cloud.largest_rms = *std::max_element(deviations.begin(), deviations.end());
  return cloud;
}

} // namespace

void
forEachAnnotatedCloud(const std::function<void(const AnnotatedCloud&)>& use)
{
  for (const CloudSource& source : sources) {
    const std::optional<std::string> path = pathOfData(source.path);
    if (!path)
      continue;
    try {
      use(makeCloud(source, source.read(*path)));
    }
    catch (const std::runtime_error& error) {
      std::cerr << "left out: " << error.what() << "\n";
    }
  }
}

} // namespace pcl::acmap::bench
