#include "picture.h"
#include "vtk_pieces.h"

#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/live_viewer.h>

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageMapper3D.h>
#include <vtkInteractorStyleTerrain.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <deque>

namespace pcl {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_pictures{100};
constexpr double images_from = 0.71; // the cloud takes this part of the width

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
  std::vector<Eigen::Vector3f> places;
  std::vector<acmap::ByteColor> colors;
  for (const PointXYZRGBSigma& point : cloud) {
    if (!std::isfinite(point.z))
      continue;
    places.emplace_back(point.x, point.y, point.z);
    colors.push_back({point.r, point.g, point.b});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(acmap::pointsOf(places));
  data->SetVerts(acmap::singlePoints(places.size()));
  data->GetPointData()->SetScalars(acmap::colorsOf(colors));
  return data;
}

/** \param[in] areas those of the plan, else its lines */
vtkSmartPointer<vtkPolyData>
dataOf(const std::vector<PlanLine>& lines, bool areas)
{
  std::vector<Eigen::Vector3f> places;
  std::vector<std::vector<std::int32_t>> cells;
  std::vector<acmap::ByteColor> colors;
  for (const PlanLine& line : lines) {
    if (line.points.empty() || line.is_area != areas)
      continue;
    const float height = areas ? 0.F : 0.01F;
    cells.emplace_back();
    for (const Eigen::Vector2d& point : line.points) {
      cells.back().push_back(static_cast<std::int32_t>(places.size()));
      places.emplace_back(point.cast<float>().x(), point.cast<float>().y(), height);
    }
    colors.push_back(line.color);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(acmap::pointsOf(places));
  if (areas)
    data->SetPolys(acmap::cellsOf(cells));
  else
    data->SetLines(acmap::cellsOf(cells));
  data->GetCellData()->SetScalars(acmap::colorsOf(colors));
  return data;
}

/** \brief A text at the lower left of a part of the window. */
vtkSmartPointer<vtkTextActor>
makeLabel(vtkRenderer* renderer, int font_pixels)
{
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->GetTextProperty()->SetFontSize(font_pixels);
  label->GetTextProperty()->SetColor(0.114, 0.153, 0.200);
  label->GetTextProperty()->SetBackgroundColor(1, 1, 1);
  label->GetTextProperty()->SetBackgroundOpacity(0.8);
  label->SetPosition(8, 8);
  renderer->AddActor2D(label);
  return label;
}

/** \brief Counts events of the last two seconds. */
class Rate {
public:
  void
  count()
  {
    const Clock::time_point now = Clock::now();
    times_.push_back(now);
    while (now - times_.front() > window_)
      times_.pop_front();
  }

  /** \brief "12 frames/s"; empty as long as it is not known. */
  std::string
  describe() const
  {
    if (times_.size() < 2 || Clock::now() - times_.back() > window_)
      return {};
    const std::chrono::duration<double> seconds = times_.back() - times_.front();
    std::array<char, 40> text;
    std::snprintf(text.data(),
                  text.size(),
                  "%.3g frames/s",
                  static_cast<double>(times_.size() - 1) /
                      std::max(seconds.count(), 1e-3));
    return text.data();
  }

private:
  static constexpr std::chrono::seconds window_{2};
  std::deque<Clock::time_point> times_;
};

constexpr std::array<const char*, 3> camera_names = {
    "right camera", "left camera", "top camera"};

} // namespace

struct LiveViewer::Parts {
  Parts(std::mutex& mutex, const std::string& title)
  : drawing(mutex)
  {
    const std::lock_guard lock(drawing);
    window->SetSize(1120, 720);
    window->SetWindowName(title.c_str());
    addCloud();
    for (std::size_t i = 0; i < images.size(); ++i) {
      const double height = 1.0 / static_cast<double>(images.size());
      const double top = 1.0 - height * static_cast<double>(i);
      corners[i]->SetViewport(images_from, top - height, 1, top);
      corners[i]->InteractiveOff();
      corners[i]->SetBackground(acmap::background.data());
      window->AddRenderer(corners[i]);
    }
    vtkNew<vtkInteractorStyleTerrain> style;
    interactor->SetInteractorStyle(style);
    interactor->SetRenderWindow(window);
    interactor->Initialize();
    window->Render();
    acmap::DisplayConnection::surviveLossOf(window->GetGenericDisplayId());
  }

  void
  addCloud()
  {
    constexpr double ahead = 3.0; // metres, centre of rotation of the view
    // degrees, vertical: more than the field of view of a rig
    constexpr double view_angle = 55.0;
    points_mapper->SetInputData(vtkNew<vtkPolyData>());
    points->SetMapper(points_mapper);
    points->GetProperty()->SetPointSize(3);
    points->GetProperty()->LightingOff();
    scene->AddActor(points);
    scene->SetViewport(0, 0, images_from, 1);
    scene->SetBackground(acmap::background.data());
    makeLabel(scene, label_pixels)->SetInput("newest view");
    status = makeLabel(scene, status_pixels);
    status->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    status->GetTextProperty()->SetVerticalJustificationToTop();
    status->SetPosition(0.015, 0.98);
    status->SetInput("waiting for the first view");
    // behind the camera, in its direction of view: x right, y down
    scene->GetActiveCamera()->SetPosition(0, 0, -1);
    scene->GetActiveCamera()->SetFocalPoint(0, 0, ahead);
    scene->GetActiveCamera()->SetViewUp(0, -1, 0);
    scene->GetActiveCamera()->SetViewAngle(view_angle);
    window->AddRenderer(scene);
  }

  void
  addPlan()
  {
    constexpr double plan_height = 0.45; // of the window
    scene->SetViewport(0, plan_height, images_from, 1);
    plan_scene->SetViewport(0, 0, images_from, plan_height);
    plan_scene->SetBackground(0.97, 0.98, 0.99);
    makeLabel(plan_scene, label_pixels)->SetInput("plan so far");
    plan_scene->GetActiveCamera()->ParallelProjectionOn();
    plan_scene->InteractiveOff();
    plan->SetMapper(plan_mapper);
    plan->GetProperty()->SetLineWidth(3);
    areas->SetMapper(areas_mapper);
    for (const auto& part : {areas.Get(), plan.Get()}) {
      part->GetProperty()->LightingOff();
      plan_scene->AddActor(part);
    }
    window->AddRenderer(plan_scene);
    is_plan_shown = true;
  }

  /** \param[in] bounds least and most x and y */
  void
  turnPlan(const double* bounds)
  {
    const bool is_tall = bounds[3] - bounds[2] > bounds[1] - bounds[0];
    plan_scene->GetActiveCamera()->SetViewUp(is_tall ? -1 : 0, is_tall ? 0 : 1, 0);
    plan_scene->ResetCamera();
  }

  void
  setImage(std::size_t i, const CameraImage& image)
  {
    const bool is_first = images[i]->GetInput() == nullptr;
    images[i]->SetInputData(pictureOf(image));
    if (!is_first)
      return;
    corners[i]->AddActor(images[i]);
    labels[i] = makeLabel(corners[i], label_pixels);
    labels[i]->SetInput(camera_names[i]);
    corners[i]->GetActiveCamera()->ParallelProjectionOn();
    corners[i]->ResetCamera();
    corners[i]->GetActiveCamera()->SetParallelScale(0.5 * image.height);
  }

  static constexpr int label_pixels = 14;
  static constexpr int status_pixels = 20;

  acmap::DisplayConnection connection; // needed as long as VTK draws
  std::mutex& drawing;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkRenderer> scene;
  vtkNew<vtkPolyDataMapper> points_mapper;
  vtkNew<vtkActor> points;
  vtkNew<vtkRenderer> plan_scene;
  vtkNew<vtkPolyDataMapper> plan_mapper;
  vtkNew<vtkActor> plan;
  vtkNew<vtkPolyDataMapper> areas_mapper;
  vtkNew<vtkActor> areas;
  vtkSmartPointer<vtkTextActor> status;
  std::array<vtkSmartPointer<vtkTextActor>, 3> labels;
  Rate rate;
  bool is_plan_shown = false;
  std::array<vtkNew<vtkRenderer>, 3> corners;
  std::array<vtkNew<vtkImageActor>, 3> images;
  bool is_new = false;
  Clock::time_point last;
};

LiveViewer::LiveViewer(std::mutex& drawing, const std::string& title)
: parts_(std::make_unique<Parts>(drawing, title))
{}

LiveViewer::~LiveViewer() = default;

void
LiveViewer::show(const TrinocularFrame& frame)
{
  parts_->rate.count();
  // most frames of a stream are replaced before they could be seen
  if (Clock::now() - parts_->last < between_pictures)
    return;
  const std::lock_guard lock(parts_->drawing);
  for (std::size_t i = 0; i < frame.images.size(); ++i)
    if (!frame.images[i].empty())
      parts_->setImage(i, frame.images[i]);
  if (const std::string rate = parts_->rate.describe();
      !rate.empty() && parts_->labels[0])
    parts_->labels[0]->SetInput((camera_names[0] + (", " + rate)).c_str());
  parts_->is_new = true;
}

void
LiveViewer::show(const PointCloud<PointXYZRGBSigma>& cloud)
{
  const std::lock_guard lock(parts_->drawing);
  parts_->points_mapper->SetInputData(dataOf(cloud));
  parts_->scene->ResetCameraClippingRange();
  parts_->is_new = true;
}

void
LiveViewer::showPlan(const std::vector<PlanLine>& lines)
{
  const std::lock_guard lock(parts_->drawing);
  if (!parts_->is_plan_shown)
    parts_->addPlan();
  parts_->plan_mapper->SetInputData(dataOf(lines, false));
  parts_->areas_mapper->SetInputData(dataOf(lines, true));
  parts_->turnPlan(parts_->plan_mapper->GetBounds());
  parts_->is_new = true;
}

void
LiveViewer::showStatus(const std::string& text)
{
  const std::lock_guard lock(parts_->drawing);
  parts_->status->SetInput(text.c_str());
  parts_->is_new = true;
}

void
LiveViewer::update()
{
  if (Clock::now() - parts_->last < between_pictures || isClosed())
    return;
  parts_->last = Clock::now();
  const std::lock_guard lock(parts_->drawing);
  parts_->interactor->ProcessEvents();
  if (parts_->is_new && !isClosed())
    parts_->window->Render();
  parts_->is_new = false;
}

bool
LiveViewer::isClosed() const
{
  return parts_->interactor->GetDone() || !parts_->connection.isOpen();
}

} // namespace pcl
