#include "one_view_tables.h"

#include "bench_data.h"
#include "markdown_row.h"
#include "one_view_finders.h"
#include "plane_overlaps.h"
#include "statistics.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>

namespace pcl::acmap::bench {
namespace {

/** \brief The points of a detected plane. */
struct FoundSupport {
  std::size_t points = 0;
  double depth = 0; ///< metres, mean
  double rms = 0;   ///< metres, distance from the plane
};

std::vector<FoundSupport>
supportsOf(const OneView& view, const FoundPlanes& found)
{
  std::vector<FoundSupport> supports(found.planes.size());
  for (std::size_t i = 0; i < found.labels.size(); ++i) {
    if (found.labels[i] < 0)
      continue;
    const auto f = static_cast<std::size_t>(found.labels[i]);
    const Eigen::Vector3d point =
        (*view.finite.points)[i].getVector3fMap().cast<double>();
    const double off = found.planes[f].head<3>().dot(point) + found.planes[f][3];
    ++supports[f].points;
    supports[f].depth += point.z();
    supports[f].rms += off * off;
  }
  for (FoundSupport& support : supports) {
    const auto count = static_cast<double>(std::max<std::size_t>(support.points, 1));
    support.depth /= count;
    support.rms = std::sqrt(support.rms / count);
  }
  return supports;
}

/** \brief Number of planes that are not surfaces but quantization levels of the sensor:
 * much flatter than the depth step, perpendicular to the optical axis, and parallel to
 * at least three others. */
std::size_t
countLayers(const OneView& view, const FoundPlanes& found)
{
  constexpr double max_rms = 1.0 / 3.0; // of the depth step
  constexpr double max_angle = 2.0;     // degrees
  constexpr std::size_t min_parallels = 3;
  const double cosine = std::cos(max_angle * M_PI / 180);
  const double inverse_step = inverseDepthStep(view);
  const std::vector<FoundSupport> supports = supportsOf(view, found);
  std::size_t layers = 0;
  for (std::size_t f = 0; f < found.planes.size(); ++f) {
    const Eigen::Vector3d normal = found.planes[f].head<3>();
    const double step = inverse_step * supports[f].depth * supports[f].depth;
    const auto parallels = std::count_if(
        found.planes.begin(), found.planes.end(), [&](const Eigen::Vector4d& other) {
          return std::abs(other.head<3>().dot(normal)) >= cosine;
        });
    layers += std::abs(normal.z()) >= cosine &&
              supports[f].rms<max_rms * step&& static_cast<std::size_t>(parallels)>
                  min_parallels; // the plane itself is counted too
  }
  return layers;
}

void
printRealRow(const OneView& view, const OneViewFinder& finder)
{
  const FoundPlanes found = findInView(finder, view);
  const auto on_planes = static_cast<std::size_t>(std::count_if(
      found.labels.begin(), found.labels.end(), [](auto label) { return label >= 0; }));
  MarkdownRow()
      .text(view.name)
      .count(found.labels.size())
      .text(finder.name)
      .count(found.planes.size())
      .count(countLayers(view, found))
      .number(percent(on_planes, found.labels.size()), 1)
      .number(found.seconds, 3)
      .print();
}

/** \brief A view of a table: label 0 is the table, the others are boxes. */
struct TableView {
  OneView view;
  std::vector<std::int32_t> labels; ///< of the finite points, -1 for none
  std::size_t boxes = 0;
};

TableView
loadTableView(const std::string& name, const std::string& path)
{
  constexpr std::uint32_t table_label = 1;
  PointCloud<PointXYZL> marked;
  fromPCLPointCloud2(loadPointCloud(path).cloud, marked);
  TableView table{loadOneView(name, path), {}, 0};
  std::map<std::uint32_t, std::int32_t> numbers{{0u, -1}, {table_label, 0}};
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (table.view.finite_of_pixel[i] < 0)
      continue;
    const auto next = static_cast<std::int32_t>(numbers.size()) - 1;
    table.labels.push_back(numbers.emplace(marked[i].label, next).first->second);
  }
  table.boxes = numbers.size() - 2;
  return table;
}

void
printTableRow(const TableView& table, const OneViewFinder& finder)
{
  const FoundPlanes found = findInView(finder, table.view);
  const PlaneOverlaps overlaps(
      table.labels, table.boxes + 1, found.labels, found.planes.size());
  double best = 0; // intersection over union with the table
  std::vector<std::size_t> faces(table.boxes + 1);
  std::size_t on_faces = 0, of_boxes = 0;
  for (std::size_t box = 1; box <= table.boxes; ++box)
    of_boxes += overlaps.truthSize(box);
  for (std::size_t f = 0; f < overlaps.founds(); ++f) {
    const std::size_t common = overlaps.common(f, 0);
    best = std::max(
        best, percent(common, overlaps.truthSize(0) + overlaps.foundSize(f) - common));
    const std::int32_t maximum = overlaps.majority(f);
    if (maximum <= 0)
      continue;
    const auto box = static_cast<std::size_t>(maximum);
    if (2 * overlaps.common(f, box) >= overlaps.foundSize(f)) {
      ++faces[box];
      on_faces += overlaps.common(f, box);
    }
  }
  std::string of_each;
  for (std::size_t box = 1; box <= table.boxes; ++box)
    of_each += (box > 1 ? " + " : "") + std::to_string(faces[box]);
  MarkdownRow()
      .text(table.view.name)
      .count(table.labels.size())
      .text(finder.name)
      .count(found.planes.size())
      .number(best, 1)
      .text(of_each)
      .number(percent(on_faces, of_boxes), 1)
      .number(found.seconds, 3)
      .print();
}

} // namespace

void
printRealViews()
{
  std::cout << "\n### Real views\n";
  printHead(
      {"view", "points", "finder", "planes", "layers", "points on planes %", "CPU s"});
  for (const auto& [name, path] :
       {std::pair{"office1", "E_meshing/office1.pcd"},
        {"capture0001", "E_meshing/capture0001.pcd"},
        {"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd"}})
    if (const auto found = pathOfData(path)) {
      const OneView view = loadOneView(name, *found);
      for (const OneViewFinder& finder : oneViewFinders())
        printRealRow(view, finder);
    }
}

void
printTableViews()
{
  std::cout << "\n### Boxes on a table\n";
  printHead({"view",
             "points",
             "finder",
             "planes",
             "table: intersection over union %",
             "faces on each box",
             "points of the boxes on them %",
             "CPU s"});
  for (const auto& [name, path] : {std::pair{"mosd learn0", "F_planes/mosd/learn0.pcd"},
                                   {"mosd learn5", "F_planes/mosd/learn5.pcd"}})
    if (const auto found = pathOfData(path)) {
      const TableView table = loadTableView(name, *found);
      for (const OneViewFinder& finder : oneViewFinders())
        printTableRow(table, finder);
    }
}

} // namespace pcl::acmap::bench
