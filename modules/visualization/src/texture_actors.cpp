#include "map_actors.h"
#include "vtk_pieces.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap {
namespace {

constexpr float anisotropy = 8;

bool
hasKnownTexels(const TexturePicture& chart)
{
  return chart.kinds.empty() ||
         std::any_of(chart.kinds.begin(), chart.kinds.end(), [](TexelKind kind) {
           return kind != TexelKind::None;
         });
}

vtkSmartPointer<vtkTexture>
textureOf(const TexturePicture& chart, double exposure)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(chart.colors.width, chart.colors.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* const bytes = static_cast<std::uint8_t*>(image->GetScalarPointer());
  std::transform(chart.colors.values.begin(),
                 chart.colors.values.end(),
                 bytes,
                 [&](std::uint8_t value) {
                   return static_cast<std::uint8_t>(
                       std::min(255L, std::lround(exposure * value)));
                 });
  for (std::size_t i = 0; i < chart.kinds.size(); ++i)
    if (chart.kinds[i] == TexelKind::None)
      std::memset(bytes + 3 * i, unknown_grey, 3);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetMaximumAnisotropicFiltering(anisotropy);
  texture->RepeatOff();
  texture->EdgeClampOn();
  return texture;
}

vtkSmartPointer<vtkFloatArray>
placesOf(const MapFaces& part)
{
  auto places = vtkSmartPointer<vtkFloatArray>::New();
  places->SetNumberOfComponents(2);
  for (const Eigen::Vector2f& place : part.places)
    places->InsertNextTuple2(place.x(), place.y());
  return places;
}

vtkSmartPointer<vtkActor>
frontOf(const MapFaces& part,
        const TexturePicture* chart,
        double exposure,
        vtkPolyData* data)
{
  auto front = actorOf(data, front_color, false);
  front->GetProperty()->SetInterpolationToFlat();
  front->GetProperty()->BackfaceCullingOn();
  if (chart) {
    data->GetPointData()->SetTCoords(placesOf(part));
    front->GetProperty()->SetColor(1, 1, 1);
    front->GetProperty()->LightingOff();
    front->SetTexture(textureOf(*chart, exposure));
  }
  return front;
}

} // namespace

Actors
actorsOfTextures(const std::vector<MapFaces>& faces, double exposure, bool hide_backs)
{
  const bool is_colorless =
      std::none_of(faces.begin(), faces.end(), [](const MapFaces& part) {
        return part.chart && hasKnownTexels(*part.chart);
      });
  Actors actors;
  for (const MapFaces& part : faces) {
    vtkNew<vtkPolyData> data;
    data->SetPoints(pointsOf(part.points));
    data->SetPolys(cellsOf(part.faces));
    actors.push_back(
        frontOf(part, is_colorless ? nullptr : part.chart, exposure, data));
    if (hide_backs)
      continue;
    const auto back = actorOf(data, back_color, false);
    back->GetProperty()->SetInterpolationToFlat();
    back->GetProperty()->FrontfaceCullingOn();
    actors.push_back(back);
  }
  return actors;
}

} // namespace pcl::acmap
