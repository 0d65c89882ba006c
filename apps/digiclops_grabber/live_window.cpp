#include "live_window.h"

#include <pcl/visualization/display_connection.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageMapper3D.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <chrono>
#include <cmath>

namespace pcl::acmap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_pictures(100);
constexpr int window_width = 1120;
constexpr int window_height = 720;
constexpr double images_from = 0.71; // the cloud takes this fraction of the width
constexpr double ahead = 3.0;        // metres, centre of rotation of the view
// degrees, vertical: more than the field of view of a rig
constexpr double view_angle = 55.0;

/** \brief A VTK image of a camera image, its first row at the top. */
vtkSmartPointer<vtkImageData>
pictureOf(const CameraImage& image)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(image.width, image.height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto width = static_cast<std::size_t>(image.width);
  for (int row = 0; row < image.height; ++row) {
    auto* to = static_cast<unsigned char*>(
        picture->GetScalarPointer(0, image.height - 1 - row, 0));
    const std::uint8_t* from =
        &image.values[static_cast<std::size_t>(row) * width * channels];
    for (std::size_t i = 0; i < 3 * width; ++i)
      to[i] = channels == 3 ? from[i] : from[i / 3];
  }
  return picture;
}

vtkSmartPointer<vtkPolyData>
dataOf(const PointCloud<PointXYZRGBSigma>& cloud)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const PointXYZRGBSigma& point : cloud) {
    if (!std::isfinite(point.z))
      continue;
    const vtkIdType id = points->InsertNextPoint(point.x, point.y, point.z);
    cells->InsertNextCell(1, &id);
    const std::array<unsigned char, 3> color = {point.r, point.g, point.b};
    colors->InsertNextTypedTuple(color.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetPointData()->SetScalars(colors);
  return data;
}

} // namespace

struct LiveWindow::Window {
  explicit Window(std::mutex& mutex)
  : drawing(mutex)
  {
    window->SetSize(window_width, window_height);
    window->SetWindowName("pcl_digiclops_grabber");
    addCloud();
    for (std::size_t i = 0; i < images.size(); ++i)
      addImage(i);
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor->SetInteractorStyle(style);
    interactor->SetRenderWindow(window);
    interactor->Initialize();
    window->Render();
  }

  void
  addCloud()
  {
    points_mapper->SetInputData(vtkNew<vtkPolyData>());
    points->SetMapper(points_mapper);
    points->GetProperty()->SetPointSize(2);
    points->GetProperty()->LightingOff();
    stage->AddActor(points);
    stage->SetViewport(0, 0, images_from, 1);
    stage->SetBackground(0.10, 0.11, 0.13);
    // behind the camera, in its direction of view: x right, y down
    stage->GetActiveCamera()->SetPosition(0, 0, -1);
    stage->GetActiveCamera()->SetFocalPoint(0, 0, ahead);
    stage->GetActiveCamera()->SetViewUp(0, -1, 0);
    stage->GetActiveCamera()->SetViewAngle(view_angle);
    window->AddRenderer(stage);
  }

  void
  addImage(std::size_t i)
  {
    const double height = 1.0 / static_cast<double>(images.size());
    const double top = 1.0 - height * static_cast<double>(i);
    corners[i]->SetViewport(images_from, top - height, 1, top);
    corners[i]->InteractiveOff();
    window->AddRenderer(corners[i]);
  }

  void
  setImage(std::size_t i, const CameraImage& image)
  {
    const bool is_first = images[i]->GetInput() == nullptr;
    images[i]->SetInputData(pictureOf(image));
    if (!is_first)
      return;
    corners[i]->AddActor(images[i]);
    corners[i]->GetActiveCamera()->ParallelProjectionOn();
    corners[i]->ResetCamera();
    corners[i]->GetActiveCamera()->SetParallelScale(0.5 * image.height);
  }

  DisplayConnection connection; // needed as long as VTK draws
  std::mutex& drawing;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkRenderer> stage;
  vtkNew<vtkPolyDataMapper> points_mapper;
  vtkNew<vtkActor> points;
  std::array<vtkNew<vtkRenderer>, 3> corners;
  std::array<vtkNew<vtkImageActor>, 3> images;
  bool is_new = false;
  Clock::time_point last;
};

LiveWindow::LiveWindow(std::mutex& drawing)
{
  const std::lock_guard lock(drawing);
  window_ = std::make_unique<Window>(drawing);
}

LiveWindow::~LiveWindow() = default;

void
LiveWindow::show(const TrinocularFrame& frame)
{
  // most frames of a stream are replaced before they could be seen
  if (Clock::now() - window_->last < between_pictures)
    return;
  const std::lock_guard lock(window_->drawing);
  for (std::size_t i = 0; i < frame.images.size(); ++i)
    if (!frame.images[i].empty())
      window_->setImage(i, frame.images[i]);
  window_->is_new = true;
}

void
LiveWindow::show(const PointCloud<PointXYZRGBSigma>& cloud)
{
  const std::lock_guard lock(window_->drawing);
  window_->points_mapper->SetInputData(dataOf(cloud));
  window_->stage->ResetCameraClippingRange();
  window_->is_new = true;
}

bool
LiveWindow::isClosed() const
{
  return window_->interactor->GetDone();
}

void
LiveWindow::update()
{
  if (Clock::now() - window_->last < between_pictures || isClosed())
    return;
  window_->last = Clock::now();
  const std::lock_guard lock(window_->drawing);
  window_->interactor->ProcessEvents();
  if (window_->is_new && !isClosed())
    window_->window->Render();
  window_->is_new = false;
}

} // namespace pcl::acmap
