#include "bench.h"
#include "cell_polygons.h"

#include <pcl/core/polygon_triangles.h>

#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <set>

namespace pcl::acmap::bench {
namespace {

using Triangles = TriangleMesh::Triangles;
using Loop = std::vector<Eigen::Vector3f>;

/** \brief A polygon and the unit cells that it consists of. */
struct Region {
  PlanePolygon polygon;
  test::Cells cells;
};

std::vector<Region>
regions(bool pinched)
{
  std::vector<Region> all;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const test::CellRegion region(seed, 4 + static_cast<int>(seed % 9));
    for (const auto& [polygon, cells] : region.polygons(pinched))
      all.push_back({polygon, cells});
  }
  return all;
}

bool
hasTouchingLoops(const PlanePolygon& polygon)
{
  std::set<std::pair<float, float>> places;
  const std::vector<Eigen::Vector3f> points = pointsOfPolygon(polygon);
  for (const Eigen::Vector3f& point : points)
    places.emplace(point.x(), point.y());
  return places.size() < points.size();
}

double
signedArea(const Loop& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = loop[i].cast<double>();
    const Eigen::Vector3d b = loop[(i + 1) % loop.size()].cast<double>();
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

/** \brief VTK needs outlines that turn left and holes that turn right. */
Region
oriented(Region region)
{
  if (signedArea(region.polygon.outer) < 0)
    std::reverse(region.polygon.outer.begin(), region.polygon.outer.end());
  for (Loop& hole : region.polygon.holes)
    if (signedArea(hole) > 0)
      std::reverse(hole.begin(), hole.end());
  return region;
}

Triangles
byVtk(const PlanePolygon& polygon)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto add = [&](const Loop& loop) {
    lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Eigen::Vector3f& point : loop)
      lines->InsertCellPoint(points->InsertNextPoint(point.x(), point.y(), point.z()));
    lines->InsertCellPoint(first);
  };
  add(polygon.outer);
  for (const Loop& hole : polygon.holes)
    add(hole);
  vtkNew<vtkPolyData> contours;
  contours->SetPoints(points);
  contours->SetLines(lines);
  vtkNew<vtkContourTriangulator> triangulator;
  triangulator->SetInputData(contours);
  triangulator->Update();
  Triangles triangles;
  vtkNew<vtkIdList> corners;
  vtkCellArray* const cells = triangulator->GetOutput()->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners) != 0;)
    triangles.push_back({static_cast<std::int32_t>(corners->GetId(0)),
                         static_cast<std::int32_t>(corners->GetId(1)),
                         static_cast<std::int32_t>(corners->GetId(2))});
  return triangles;
}

Triangles
byAcmap(const PlanePolygon& polygon)
{
  return trianglesOfPolygon(polygon, Eigen::Vector3d::UnitZ());
}

/** \brief Number of regions that the triangles do not cover exactly once. */
template <typename Triangulate>
std::size_t
wrong(const std::vector<Region>& regions, const Triangulate& triangulate)
{
  return static_cast<std::size_t>(
      std::count_if(regions.begin(), regions.end(), [&](const Region& region) {
        return test::wronglyCovered(
                   region.polygon, region.cells, triangulate(region.polygon)) != 0;
      }));
}

template <typename Triangulate>
double
microseconds(const std::vector<Region>& regions, const Triangulate& triangulate)
{
  std::size_t sum = 0;
  const double seconds = medianThread(5, [&] {
    for (const Region& region : regions)
      sum += triangulate(region.polygon).size();
  });
  return sum > 0 ? 1e6 * seconds / static_cast<double>(regions.size()) : 0;
}

void
printRegions(const std::string& name, const std::vector<Region>& regions)
{
  Row() << name << regions.size() << wrong(regions, byAcmap) << wrong(regions, byVtk)
        << figure(microseconds(regions, byAcmap), 1)
        << figure(microseconds(regions, byVtk), 1);
}

const Section polygons_section("polygons", [] {
  printHead(
      "outlines and holes | regions | wrong | wrong, VTK | us per region | us, VTK");
  std::vector<Region> apart, touching, pinched;
  for (const Region& region : regions(false))
    (hasTouchingLoops(region.polygon) ? touching : apart).push_back(oriented(region));
  for (const Region& region : regions(true))
    if (hasTouchingLoops(region.polygon))
      pinched.push_back(oriented(region));
  printRegions("apart", apart);
  printRegions("touch each other", touching);
  printRegions("touch themselves", pinched);
});

} // namespace
} // namespace pcl::acmap::bench
