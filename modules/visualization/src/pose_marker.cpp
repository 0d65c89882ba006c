#include "pose_marker.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>

namespace pcl::acmap {
namespace {

constexpr Color marker_color = {1.00, 0.55, 0.05};
constexpr double marker_pixels = 4;

} // namespace

vtkSmartPointer<vtkActor>
actorOfMarker()
{
  constexpr float x = 0.16F, y = 0.12F, z = 0.24F; // metres
  vtkNew<vtkPolyData> data;
  data->SetPoints(
      pointsOf({{0, 0, 0}, {-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}));
  data->SetLines(cellsOf(
      std::vector<std::vector<std::int32_t>>{{1, 2, 3, 4, 1}, {1, 0, 2}, {3, 0, 4}}));
  return linesOf(data, marker_color, false, marker_pixels);
}

void
place(vtkActor* marker, const Eigen::Isometry3d& T_map_camera)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix->SetElement(row, column, T_map_camera(row, column));
  marker->SetUserMatrix(matrix);
}

} // namespace pcl::acmap
