#include "map_actors.h"

#include "vtk_pieces.h"

#include <pcl/common/colors.h>

#include <vtkCellData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

namespace pcl::acmap {
namespace {

constexpr double outline_pixels = 2;
constexpr double trajectory_pixels = 4;
constexpr double axis_pixels = 3;
constexpr std::size_t max_axes = 50;

ByteColor
colorOf(std::size_t plane)
{
  const RGB color = GlasbeyLUT::at(plane % GlasbeyLUT::size());
  return {color.r, color.g, color.b};
}

/** \brief A colour of a plane, mixed with white, for its area. */
Color
paleColorOf(std::size_t plane)
{
  constexpr double white = 0.4;
  Color pale;
  std::size_t channel = 0;
  for (const std::uint8_t value : colorOf(plane))
    pale[channel++] = white + (1 - white) * value / 255.0;
  return pale;
}

vtkSmartPointer<vtkActor>
colored(const std::vector<MapLine>& lines,
        const std::vector<ByteColor>& colors,
        const Color& color,
        double pixels)
{
  std::vector<Eigen::Vector3f> points;
  std::vector<std::vector<std::int32_t>> cells;
  for (const MapLine& line : lines) {
    auto& cell = cells.emplace_back();
    for (const Eigen::Vector3f& point : line.points) {
      cell.push_back(static_cast<std::int32_t>(points.size()));
      points.push_back(point);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf(points));
  data->SetLines(cellsOf(cells));
  if (!colors.empty())
    data->GetCellData()->SetScalars(colorsOf(colors));
  return linesOf(data, color, !colors.empty(), pixels);
}

} // namespace

Actors
actorsOfPlanes(const std::vector<MapFaces>& faces, bool hide_backs, double opacity)
{
  Actors actors;
  for (const MapFaces& part : faces) {
    vtkNew<vtkPolyData> data;
    data->SetPoints(pointsOf(part.points));
    data->SetPolys(cellsOf(part.faces));
    const auto actor = actorOf(data, paleColorOf(part.plane), false);
    actor->GetProperty()->SetInterpolationToFlat();
    actor->GetProperty()->SetAmbient(0.5);
    actor->GetProperty()->SetDiffuse(0.6);
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->SetBackfaceCulling(hide_backs);
    // a translucent plane coincides with its textured face
    actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -2);
    actors.push_back(actor);
  }
  return actors;
}

vtkSmartPointer<vtkActor>
actorOfOutlines(const std::vector<MapLine>& lines)
{
  std::vector<ByteColor> colors;
  for (const MapLine& line : lines)
    colors.push_back(colorOf(line.plane));
  return colored(lines, colors, front_color, outline_pixels);
}

vtkSmartPointer<vtkActor>
actorOfLines(const std::vector<MapLine>& lines, const Color& color, double pixels)
{
  return colored(lines, {}, color, pixels);
}

MapLine
lineOf(const Trajectory& trajectory)
{
  MapLine line;
  for (const Eigen::Isometry3d& pose : trajectory.poses)
    if (pose.matrix().allFinite())
      line.points.push_back(pose.translation().cast<float>());
  return line;
}

void
addPlaces(const Trajectory& trajectory, std::vector<Eigen::Vector3f>& points)
{
  constexpr std::size_t one_in = 20; // of the points
  const MapLine way = lineOf(trajectory);
  const std::size_t times = points.size() / one_in / (way.points.size() + 1) + 1;
  for (std::size_t i = 0; i < times; ++i)
    points.insert(points.end(), way.points.begin(), way.points.end());
}

Actors
actorsOfTrajectory(const Trajectory& trajectory, double length)
{
  std::vector<MapLine> axes;
  std::vector<ByteColor> colors;
  const std::size_t step = trajectory.poses.size() / max_axes + 1;
  for (std::size_t i = 0; i < trajectory.poses.size(); i += step) {
    const Eigen::Isometry3d& pose = trajectory.poses[i];
    for (int axis = 0; axis < 3 && pose.matrix().allFinite(); ++axis) {
      const Eigen::Vector3d tip = pose.translation() + length * pose.linear().col(axis);
      axes.push_back({0, {pose.translation().cast<float>(), tip.cast<float>()}});
      ByteColor color = {30, 30, 30};
      color[static_cast<std::size_t>(axis)] = 220;
      colors.push_back(color);
    }
  }
  return {colored({lineOf(trajectory)}, {}, trajectory_color, trajectory_pixels),
          colored(axes, colors, trajectory_color, axis_pixels)};
}

} // namespace pcl::acmap
