#include "overlay.h"

#include "picture.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr Color ink = {0.114, 0.153, 0.200}; // colours of the page
constexpr Color faint = {0.365, 0.420, 0.486};
constexpr int font_pixels = 15;
constexpr int row_pixels = 24;
constexpr int border = 12;
constexpr int panel_width = 190;
constexpr int swatch_pixels = 12;

/** \brief A filled rectangle, from its lower left corner. */
vtkSmartPointer<vtkActor2D>
rectangle(float width, float height, const Color& color, double opacity)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(
      pointsOf({{0, 0, 0}, {width, 0, 0}, {width, height, 0}, {0, height, 0}}));
  data->SetPolys(cellsOf(std::vector<std::array<std::int32_t, 4>>{{0, 1, 2, 3}}));
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

void
setStyle(vtkTextActor& text, const Color& color)
{
  text.GetTextProperty()->SetFontSize(font_pixels);
  text.GetTextProperty()->SetColor(color[0], color[1], color[2]);
}

void
setBox(vtkTextActor& text)
{
  setStyle(text, ink);
  text.GetTextProperty()->SetBackgroundColor(1, 1, 1);
  text.GetTextProperty()->SetBackgroundOpacity(0.92);
  text.GetTextProperty()->SetLineSpacing(1.25);
  text.GetTextProperty()->SetFrame(1);
  text.GetTextProperty()->SetFrameColor(0.835, 0.863, 0.894);
  text.VisibilityOff();
}

void
setText(vtkTextActor& actor, const std::string& text)
{
  actor.SetInput(text.c_str());
  actor.SetVisibility(!text.empty());
}

/** \brief Lines with room beside them, as the text of a box has none. */
std::string
padded(const std::string& text)
{
  std::string lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines += (lines.empty() ? "   " : "\n   ") + line + "   ";
  return lines;
}

/** \brief Moves a box to a share of the room that the window leaves it. */
void
place(vtkTextActor& text, vtkRenderer* renderer, double right, double top)
{
  if (!text.GetVisibility())
    return;
  double size[2];
  text.GetSize(renderer, size);
  const int* const window = renderer->GetSize();
  text.SetPosition(border + right * (window[0] - 2 * border - size[0]),
                   border + top * (window[1] - 2 * border - size[1]));
}

} // namespace

Overlay::Overlay(vtkRenderWindow& window)
: window_(window)
{
  window.SetNumberOfLayers(2);
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  setStyle(*hint_, faint);
  setBox(*card_);
  setBox(*notice_);
  hint_->GetTextProperty()->SetJustificationToCentered();
  hint_->GetTextProperty()->SetBackgroundColor(
      background[0], background[1], background[2]);
  hint_->GetTextProperty()->SetBackgroundOpacity(0.75);
  for (auto* text : {hint_.Get(), card_.Get(), notice_.Get()})
    renderer_->AddActor2D(text);
  observer_ = renderer_->AddObserver(vtkCommand::StartEvent, this, &Overlay::layOut);
  window.AddRenderer(renderer_);
}

Overlay::~Overlay()
{
  renderer_->RemoveObserver(observer_);
  window_.RemoveRenderer(renderer_);
}

void
Overlay::setCamera(vtkRenderer* scene)
{
  if (scene && !scene_)
    bar_.addTo(renderer_);
  scene_ = scene;
}

void
Overlay::setRows(const std::vector<LayerRow>& rows)
{
  for (const Row& row : rows_)
    for (vtkProp* prop : {static_cast<vtkProp*>(row.name),
                          static_cast<vtkProp*>(row.count),
                          static_cast<vtkProp*>(row.swatch)})
      renderer_->RemoveViewProp(prop);
  if (panel_)
    renderer_->RemoveViewProp(panel_);
  rows_.clear();
  panel_ = rectangle(panel_width,
                     static_cast<float>(row_pixels * rows.size() + border),
                     {1, 1, 1},
                     0.92);
  renderer_->AddViewProp(panel_);
  for (const LayerRow& row : rows) {
    const Color& color = row.is_shown ? ink : faint;
    Row& drawn = rows_.emplace_back();
    drawn.name = vtkSmartPointer<vtkTextActor>::New();
    drawn.count = vtkSmartPointer<vtkTextActor>::New();
    drawn.name->SetInput((std::string(1, row.key) + "   " + row.name).c_str());
    drawn.count->SetInput(row.count.c_str());
    drawn.count->GetTextProperty()->SetJustificationToRight();
    drawn.swatch =
        rectangle(swatch_pixels, swatch_pixels, row.color, row.is_shown ? 1 : 0.2);
    for (const auto& text : {drawn.name, drawn.count}) {
      setStyle(*text, color);
      renderer_->AddViewProp(text);
    }
    drawn.name->GetTextProperty()->SetBold(row.is_shown);
    renderer_->AddViewProp(drawn.swatch);
  }
}

std::optional<std::size_t>
Overlay::rowAt(int column, int row) const
{
  const int below_top = window_.GetSize()[1] - border - border / 2 - row;
  const int place = below_top / row_pixels;
  if (column < border || column > border + panel_width || below_top < 0 ||
      place >= static_cast<int>(rows_.size()))
    return {};
  return static_cast<std::size_t>(place);
}

void
Overlay::setHint(const std::string& text)
{
  setText(*hint_, text);
}

void
Overlay::setCard(const std::string& text)
{
  setText(*card_, padded(text));
}

void
Overlay::setNotice(const std::string& text)
{
  setText(*notice_, padded(text));
}

void
Overlay::layOut()
{
  const int width = window_.GetSize()[0], height = window_.GetSize()[1];
  if (panel_)
    panel_->SetPosition(
        border, height - border - row_pixels * static_cast<int>(rows_.size()) - border);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int base =
        height - border - border / 2 - row_pixels * static_cast<int>(i + 1) + 7;
    rows_[i].swatch->SetPosition(border + 10, base);
    rows_[i].name->SetPosition(border + 32, base);
    rows_[i].count->SetPosition(border + panel_width - 10, base);
  }
  hint_->SetPosition(width / 2.0, border);
  place(*card_, renderer_, 1, 1);
  place(*notice_, renderer_, 0.5, 0.5);
  if (!scene_)
    return;
  vtkCamera& camera = *scene_->GetActiveCamera();
  const double metres =
      camera.GetParallelProjection()
          ? 2 * camera.GetParallelScale()
          : 2 * camera.GetDistance() * std::tan(camera.GetViewAngle() / 2 * degree);
  bar_.set(metres / height, width, height);
}

} // namespace pcl::acmap
