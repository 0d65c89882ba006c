#include "curve_chart.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartMatrix.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

/** Distinct for who does not see red and green, and in print. */
constexpr std::array<std::array<unsigned char, 3>, 4> colors = {
    {{0, 90, 160}, {213, 94, 0}, {0, 140, 100}, {110, 110, 110}}};
constexpr std::array<int, 4> markers = {vtkPlotPoints::CIRCLE,
                                        vtkPlotPoints::SQUARE,
                                        vtkPlotPoints::DIAMOND,
                                        vtkPlotPoints::CROSS};

constexpr int panel_width = 620, panel_height = 400;
constexpr int font_size = 15;

vtkNew<vtkTable>
tableOf(const Curve& curve)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("x");
  y->SetName("y");
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (std::isfinite(curve.y[i])) {
      x->InsertNextValue(curve.x[i]);
      y->InsertNextValue(curve.y[i]);
    }
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}

void
addCurve(vtkChartXY& chart, const Curve& curve, std::size_t number)
{
  const auto& color = colors[number % colors.size()];
  auto* const plot = vtkPlotPoints::SafeDownCast(chart.AddPlot(vtkChart::LINE));
  plot->SetInputData(tableOf(curve), 0, 1);
  plot->SetLabel(curve.name);
  plot->SetColor(color[0], color[1], color[2], 255);
  plot->SetWidth(2);
  plot->SetMarkerStyle(markers[number % markers.size()]);
  plot->SetMarkerSize(9);
}

void
setAxis(vtkAxis& axis, const std::string& title)
{
  axis.SetTitle(title);
  axis.GetTitleProperties()->SetBold(0);
  axis.GetTitleProperties()->SetFontSize(font_size);
  axis.GetLabelProperties()->SetFontSize(font_size);
}

/** From 0 to a little above the largest value. */
void
setRange(vtkAxis& axis, const std::vector<Curve>& curves)
{
  double most = 0;
  for (const Curve& curve : curves)
    for (const double y : curve.y)
      if (std::isfinite(y))
        most = std::max(most, y);
  constexpr double margin = 1.08;
  axis.SetRange(0, most > 0 ? margin * most : 1);
  axis.SetBehavior(vtkAxis::FIXED);
}

void
fill(vtkChartXY& chart,
     const CurvePanel& panel,
     const std::string& x_title,
     bool is_logarithmic,
     bool has_legend)
{
  for (std::size_t i = 0; i < panel.curves.size(); ++i)
    addCurve(chart, panel.curves[i], i);
  setAxis(*chart.GetAxis(vtkAxis::BOTTOM), x_title);
  setAxis(*chart.GetAxis(vtkAxis::LEFT), panel.y_title);
  chart.GetAxis(vtkAxis::BOTTOM)->SetLogScale(is_logarithmic);
  setRange(*chart.GetAxis(vtkAxis::LEFT), panel.curves);
  chart.SetShowLegend(has_legend);
  chart.GetLegend()->SetLabelSize(font_size);
  chart.GetLegend()->SetVerticalAlignment(vtkChartLegend::BOTTOM);
}

void
write(const std::string& path, vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
    throw std::runtime_error(path + " could not be written");
}

} // namespace

void
drawCurves(const std::string& path,
           const std::string& x_title,
           bool is_logarithmic,
           const std::vector<CurvePanel>& panels)
{
  constexpr int columns = 2;
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  vtkNew<vtkContextView> view;
  view->GetRenderer()->SetBackground(1, 1, 1);
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetMultiSamples(8);
  view->GetRenderWindow()->SetSize(columns * panel_width, rows * panel_height);
  vtkNew<vtkChartMatrix> charts;
  charts->SetSize({columns, rows});
  charts->SetGutter({90, 90});
  charts->SetBorders(80, 70, 30, 30);
  view->GetScene()->AddItem(charts);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int place = static_cast<int>(i);
    // charts are counted from below
    const vtkVector2i where(place % columns, rows - 1 - place / columns);
    fill(*vtkChartXY::SafeDownCast(charts->GetChart(where)),
         panels[i],
         x_title,
         is_logarithmic,
         i == 0 && panels[i].curves.size() > 1);
  }
  view->GetRenderWindow()->Render();
  write(path, view->GetRenderWindow());
}

} // namespace pcl::acmap::bench
