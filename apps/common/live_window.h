#pragma once

#include "memory.h"

#include <pcl/conversions.h>
#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/point_cloud.h>
#include <pcl/texture/floor_plan.h>
#include <pcl/visualization/display_connection.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
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
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A VTK image of a camera image, its first row at the top. */
inline vtkSmartPointer<vtkImageData>
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

inline vtkSmartPointer<vtkPolyData>
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

/** \brief The plan of a map so far as coloured lines: its floor, its walls, and the way
 * of the camera. */
class PlanLines {
public:
  explicit PlanLines(const FloorPlan& plan)
  : plan_(plan)
  {
    colors_->SetNumberOfComponents(3);
    for (const auto& polygon : plan.floors)
      for (const std::vector<Eigen::Vector2d>& loop : polygon)
        add(loop, true, {70, 74, 84});
    for (const PlanWall& wall : plan.walls)
      add({wall.from, wall.to}, false, {235, 235, 235});
  }

  void
  addWay(const std::vector<std::optional<Eigen::Isometry3d>>& poses)
  {
    std::vector<Eigen::Vector2d> way;
    for (const auto& pose : poses)
      if (pose)
        way.emplace_back(pose->translation().dot(plan_.x_axis),
                         pose->translation().dot(plan_.y_axis));
    add(way, false, {90, 160, 255});
  }

  vtkSmartPointer<vtkPolyData>
  data() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(lines_);
    data->GetCellData()->SetScalars(colors_);
    return data;
  }

private:
  void
  add(const std::vector<Eigen::Vector2d>& line,
      bool is_closed,
      const std::array<unsigned char, 3>& color)
  {
    if (line.empty())
      return;
    const vtkIdType first = points_->GetNumberOfPoints();
    lines_->InsertNextCell(static_cast<int>(line.size()) + (is_closed ? 1 : 0));
    for (const Eigen::Vector2d& point : line)
      lines_->InsertCellPoint(points_->InsertNextPoint(point.x(), point.y(), 0));
    if (is_closed)
      lines_->InsertCellPoint(first);
    colors_->InsertNextTypedTuple(color.data());
  }

  const FloorPlan& plan_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> lines_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

/** \brief A window with the last cloud, next to it the last images in small size, and
 * below it the plan of the map so far if one is made. Used by one thread. After the user has closed it, nothing is shown any more. */
class LiveWindow {
public:
  /** \param[in] drawing is locked during drawing; outlives the window
   * \throws InitFailedException with advice when there is no X server */
  LiveWindow(std::mutex& drawing, const std::string& title)
  : drawing_(drawing)
  {
    const std::lock_guard lock(drawing_);
    window_->SetSize(1120, 720);
    window_->SetWindowName(title.c_str());
    addCloud();
    for (std::size_t i = 0; i < images_.size(); ++i) {
      const double height = 1.0 / static_cast<double>(images_.size());
      const double top = 1.0 - height * static_cast<double>(i);
      corners_[i]->SetViewport(images_from, top - height, 1, top);
      corners_[i]->InteractiveOff();
      window_->AddRenderer(corners_[i]);
    }
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor_->SetInteractorStyle(style);
    interactor_->SetRenderWindow(window_);
    interactor_->Initialize();
    window_->Render();
    DisplayConnection::surviveLossOf(window_->GetGenericDisplayId());
  }

  /** \brief Sets the images of a frame; the next \ref update draws them. */
  void
  show(const TrinocularFrame& frame)
  {
    // most frames of a stream are replaced before they could be seen
    if (Clock::now() - last_ < between_pictures)
      return;
    const std::lock_guard lock(drawing_);
    for (std::size_t i = 0; i < frame.images.size(); ++i)
      if (!frame.images[i].empty())
        setImage(i, frame.images[i]);
    is_new_ = true;
  }

  /** \brief Sets a cloud in the camera's frame. */
  void
  show(const PointCloud<PointXYZRGBSigma>& cloud)
  {
    const std::lock_guard lock(drawing_);
    points_mapper_->SetInputData(dataOf(cloud));
    scene_->ResetCameraClippingRange();
    is_new_ = true;
  }

  /** \brief Sets the newest view of a map that is being made, and its plan. */
  void
  show(const MappingState& state)
  {
    if (state.newest && state.newest != newest_) {
      newest_ = state.newest;
      PointCloud<PointXYZRGBSigma> cloud;
      fromPCLPointCloud2(newest_->cloud, cloud);
      show(cloud);
    }
    const std::lock_guard lock(drawing_);
    if (!is_plan_shown_)
      addPlan();
    if (state.provisional && state.provisional != provisional_)
      floor_plan_ = makeFloorPlan(*state.provisional);
    provisional_ = state.provisional;
    PlanLines lines(floor_plan_);
    lines.addWay(state.poses);
    plan_mapper_->SetInputData(lines.data());
    turnPlan(plan_mapper_->GetBounds());
    is_new_ = true;
  }

  /** \brief Draws new data and processes mouse events, at a limited rate. */
  void
  update()
  {
    if (Clock::now() - last_ < between_pictures || isClosed())
      return;
    last_ = Clock::now();
    const std::lock_guard lock(drawing_);
    interactor_->ProcessEvents();
    if (is_new_ && !isClosed())
      window_->Render();
    is_new_ = false;
  }

  /** \brief Has the user closed it, or did the X server go away? */
  bool
  isClosed() const
  {
    return interactor_->GetDone() || !connection_.isOpen();
  }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds between_pictures{100};
  static constexpr double images_from = 0.71; // the cloud takes this part of the width

  void
  addCloud()
  {
    constexpr double ahead = 3.0; // metres, centre of rotation of the view
    // degrees, vertical: more than the field of view of a rig
    constexpr double view_angle = 55.0;
    points_mapper_->SetInputData(vtkNew<vtkPolyData>());
    points_->SetMapper(points_mapper_);
    points_->GetProperty()->SetPointSize(2);
    points_->GetProperty()->LightingOff();
    scene_->AddActor(points_);
    scene_->SetViewport(0, 0, images_from, 1);
    scene_->SetBackground(0.10, 0.11, 0.13);
    // behind the camera, in its direction of view: x right, y down
    scene_->GetActiveCamera()->SetPosition(0, 0, -1);
    scene_->GetActiveCamera()->SetFocalPoint(0, 0, ahead);
    scene_->GetActiveCamera()->SetViewUp(0, -1, 0);
    scene_->GetActiveCamera()->SetViewAngle(view_angle);
    window_->AddRenderer(scene_);
  }

  void
  addPlan()
  {
    constexpr double plan_height = 0.45; // of the window
    scene_->SetViewport(0, plan_height, images_from, 1);
    plan_scene_->SetViewport(0, 0, images_from, plan_height);
    plan_scene_->SetBackground(0.06, 0.07, 0.09);
    plan_scene_->GetActiveCamera()->ParallelProjectionOn();
    plan_scene_->InteractiveOff();
    plan_->SetMapper(plan_mapper_);
    plan_->GetProperty()->SetLineWidth(2);
    plan_->GetProperty()->LightingOff();
    plan_scene_->AddActor(plan_);
    window_->AddRenderer(plan_scene_);
    is_plan_shown_ = true;
  }

  /** Lays the longer side of the plan along the window.
   * \param[in] bounds least and most x and y */
  void
  turnPlan(const double* bounds)
  {
    const bool is_tall = bounds[3] - bounds[2] > bounds[1] - bounds[0];
    plan_scene_->GetActiveCamera()->SetViewUp(is_tall ? -1 : 0, is_tall ? 0 : 1, 0);
    plan_scene_->ResetCamera();
  }

  void
  setImage(std::size_t i, const CameraImage& image)
  {
    const bool is_first = images_[i]->GetInput() == nullptr;
    images_[i]->SetInputData(pictureOf(image));
    if (!is_first)
      return;
    corners_[i]->AddActor(images_[i]);
    corners_[i]->GetActiveCamera()->ParallelProjectionOn();
    corners_[i]->ResetCamera();
    corners_[i]->GetActiveCamera()->SetParallelScale(0.5 * image.height);
  }

  UnlimitedMemory while_open_;
  DisplayConnection connection_; // needed as long as VTK draws
  std::mutex& drawing_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<vtkRenderer> scene_;
  vtkNew<vtkPolyDataMapper> points_mapper_;
  vtkNew<vtkActor> points_;
  vtkNew<vtkRenderer> plan_scene_;
  vtkNew<vtkPolyDataMapper> plan_mapper_;
  vtkNew<vtkActor> plan_;
  FloorPlan floor_plan_;
  std::shared_ptr<const PointCloudFile> newest_;  ///< that is shown
  std::shared_ptr<const CompactMap> provisional_; ///< of the plan
  bool is_plan_shown_ = false;
  std::array<vtkNew<vtkRenderer>, 3> corners_;
  std::array<vtkNew<vtkImageActor>, 3> images_;
  bool is_new_ = false;
  Clock::time_point last_;
};

} // namespace pcl::acmap
