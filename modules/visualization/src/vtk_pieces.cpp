#include "vtk_pieces.h"

#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace pcl::acmap {

vtkSmartPointer<vtkPoints>
pointsOf(const std::vector<Eigen::Vector3f>& places)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), places[i].data());
  return points;
}

vtkSmartPointer<vtkUnsignedCharArray>
colorsOf(const std::vector<ByteColor>& values)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  for (const ByteColor& color : values)
    colors->InsertNextTypedTuple(color.data());
  return colors;
}

vtkSmartPointer<vtkCellArray>
singlePoints(std::size_t count)
{
  std::vector<std::array<std::int32_t, 1>> cells(count);
  for (std::size_t i = 0; i < count; ++i)
    cells[i] = {static_cast<std::int32_t>(i)};
  return cellsOf(cells);
}

vtkSmartPointer<vtkActor>
actorOf(vtkPolyData* data, const Color& color, bool use_point_colors)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(use_point_colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

vtkSmartPointer<vtkActor>
linesOf(vtkPolyData* data, const Color& color, bool use_point_colors, double pixels)
{
  auto lines = actorOf(data, color, use_point_colors);
  lines->GetProperty()->SetLineWidth(static_cast<float>(pixels));
  lines->GetProperty()->LightingOff();
  // lines coincide with the facets they bound; without the offset they would flicker
  lines->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  lines->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4);
  return lines;
}

} // namespace pcl::acmap
