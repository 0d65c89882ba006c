#include "mesh_figures.h"

#include "statistics.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl::acmap::bench {
namespace {

using test::Points;
using test::Triangle;
using test::Triangles;

using Corners = std::array<Eigen::Vector3d, 3>;

/** Number of triangles above each cell of the truth. */
class CoverRaster {
public:
  CoverRaster(const SceneTruth& truth, double tolerance)
  : truth_(truth)
  , tolerance_(tolerance)
  {
    for (const TruthSurface& surface : truth.surfaces())
      counts_.emplace_back(surface.visible.size(), 0);
  }

  void
  add(const Corners& corners)
  {
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    double reach = tolerance_;
    for (const Eigen::Vector3d& corner : corners)
      reach = std::max(reach, tolerance_ + (corner - middle).norm());
    for (std::size_t s = 0; s < counts_.size(); ++s)
      if (truth_.surfaces()[s].distance(middle) <= reach)
        addTo(s, corners);
  }

  void
  count(MeshFigures& figures) const
  {
    std::size_t visible = 0, covered = 0, overlapped = 0;
    for (std::size_t s = 0; s < counts_.size(); ++s)
      for (std::size_t cell = 0; cell < counts_[s].size(); ++cell)
        if (truth_.surfaces()[s].visible[cell]) {
          ++visible;
          covered += counts_[s][cell] > 0;
          overlapped += counts_[s][cell] > 1;
        }
    figures.cover = percent(covered, visible);
    figures.overlap = percent(overlapped, visible);
  }

private:
  /** x and y in cells, with integers at the cells' centres; z in metres. */
  static Corners
  inCells(const TruthSurface& surface, const Corners& corners)
  {
    Corners result;
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = surface.coordinates(corners[k]);
      for (int axis = 0; axis < 2; ++axis)
        result[k][axis] =
            result[k][axis] * surface.cells[axis] / surface.size[axis] - 0.5;
    }
    return result;
  }

  void
  addTo(std::size_t s, const Corners& corners)
  {
    const TruthSurface& surface = truth_.surfaces()[s];
    const Corners place = inCells(surface, corners);
    const Eigen::Vector3d along_b = place[1] - place[0];
    const Eigen::Vector3d along_c = place[2] - place[0];
    const double area = along_b.x() * along_c.y() - along_c.x() * along_b.y();
    constexpr double min_area = 1e-12; // seen edge-on
    if (std::abs(area) < min_area)
      return;
    Eigen::Array3d minimum =
        place[0].array().min(place[1].array()).min(place[2].array());
    Eigen::Array3d maximum =
        place[0].array().max(place[1].array()).max(place[2].array());
    const int first_i = std::max(0, static_cast<int>(std::ceil(minimum[0])));
    const int first_j = std::max(0, static_cast<int>(std::ceil(minimum[1])));
    const int last_i =
        std::min(surface.cells[0] - 1, static_cast<int>(std::floor(maximum[0])));
    const int last_j =
        std::min(surface.cells[1] - 1, static_cast<int>(std::floor(maximum[1])));
    for (int i = first_i; i <= last_i; ++i)
      for (int j = first_j; j <= last_j; ++j) {
        const double x = i - place[0].x();
        const double y = j - place[0].y();
        const double b = (x * along_c.y() - along_c.x() * y) / area;
        const double c = (along_b.x() * y - x * along_b.y()) / area;
        constexpr double rounding = 1e-9;
        if (b < -rounding || c < -rounding || b + c > 1 + rounding)
          continue;
        const double height = place[0].z() + b * along_b.z() + c * along_c.z();
        std::uint8_t& count = counts_[s][surface.cellIndex(i, j)];
        if (std::abs(height) <= tolerance_ && count < 2)
          ++count;
      }
  }

  const SceneTruth& truth_;
  double tolerance_;
  std::vector<std::vector<std::uint8_t>> counts_; // saturated at 2
};

double
angleDegrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / M_PI;
}

} // namespace

NormalErrors
measureNormals(const SceneTruth& truth,
               const Points& places,
               const Points& normals,
               double voxel)
{
  std::vector<double> all, away;
  std::size_t backs_all = 0, backs_away = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!normals[i].allFinite())
      continue;
    const TruthSurface& surface = truth.nearest(places[i]);
    const double error = angleDegrees(normals[i], surface.normal);
    all.push_back(error);
    const bool is_back = error > 90;
    backs_all += is_back;
    if (truth.distanceToOthers(places[i], surface) <= creaseMargin(voxel))
      continue;
    away.push_back(error);
    backs_away += is_back;
  }
  constexpr double nearly_all = 0.95;
  return {median(away),
          quantile(away, nearly_all),
          median(all),
          quantile(all, nearly_all),
          percent(backs_away, away.size()),
          percent(backs_all, all.size())};
}

MeshFigures
measureMesh(const SceneTruth& truth,
            const Points& points,
            const Triangles& triangles,
            double voxel)
{
  constexpr double min_tolerance = 0.05;
  CoverRaster raster(truth, std::max(min_tolerance, voxel / 2));
  Points middles, normals;
  double area = 0;
  for (const Triangle& t : triangles) {
    const Corners corners = {points[t[0]], points[t[1]], points[t[2]]};
    const Eigen::Vector3d cross =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    area += cross.norm() / 2;
    normals.push_back(cross.normalized());
    middles.push_back((corners[0] + corners[1] + corners[2]) / 3);
    raster.add(corners);
  }
  MeshFigures figures;
  figures.normals = measureNormals(truth, middles, normals, voxel);
  raster.count(figures);
  figures.area = 100 * (area / truth.visibleArea() - 1);
  const test::MeshCounts counts = test::countMesh(points, triangles);
  figures.boundary = percent(counts.boundary_edges, counts.edges);
  return figures;
}

} // namespace pcl::acmap::bench
