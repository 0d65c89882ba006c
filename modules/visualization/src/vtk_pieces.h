#pragma once

#include <Eigen/Core>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

using Color = std::array<double, 3>; ///< 0 to 1
using ByteColor = std::array<std::uint8_t, 3>;

vtkSmartPointer<vtkPoints>
pointsOf(const std::vector<Eigen::Vector3f>& places);

vtkSmartPointer<vtkUnsignedCharArray>
colorsOf(const std::vector<ByteColor>& values);

/** \brief Creates cells from lists of vertices of fixed or variable length. */
template <typename Cells>
vtkSmartPointer<vtkCellArray>
cellsOf(const Cells& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& corners : cells) {
    array->InsertNextCell(static_cast<int>(corners.size()));
    for (const std::int32_t corner : corners)
      array->InsertCellPoint(corner);
  }
  return array;
}

vtkSmartPointer<vtkCellArray>
singlePoints(std::size_t count);

vtkSmartPointer<vtkActor>
actorOf(vtkPolyData* data, const Color& color, bool use_point_colors);

/** \brief Lines without lighting, in front of the facets with which they coincide. */
vtkSmartPointer<vtkActor>
linesOf(vtkPolyData* data, const Color& color, bool use_point_colors, double pixels);

/** Front and back colour of surfaces without colours. */
constexpr std::array<double, 3> front_color = {0.80, 0.80, 0.78};
constexpr std::array<double, 3> back_color = {0.55, 0.62, 0.78};

} // namespace pcl::acmap
