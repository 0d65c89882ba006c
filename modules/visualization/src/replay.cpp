#include "replay.h"

#include "vtk_pieces.h"

#include <pcl/core/exceptions.h>

#include <Eigen/Geometry>

#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr Color marker_color = {1.00, 0.55, 0.05};
constexpr double marker_pixels = 4;

/** \brief The viewing frustum of a camera as lines; its apex is the camera. */
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

/** \param[in] T_map_camera pose of the camera */
void
place(vtkActor* marker, const Eigen::Isometry3d& T_map_camera)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix->SetElement(row, column, T_map_camera(row, column));
  marker->SetUserMatrix(matrix);
}

} // namespace

void
Replay::start()
{
  if (!flight_) {
    Flight flight(stage_.trajectory());
    if (flight.isEmpty())
      throw acmap::BadArgument("there is no trajectory to fly along");
    flight_ = std::move(flight);
    time_ = 0;
  }
  if (time_ >= flight_->seconds())
    time_ = 0;
  if (!marker_) {
    marker_ = actorOfMarker();
    stage_.renderer()->AddActor(marker_);
  }
  running_ = true;
  advance(0);
}

void
Replay::stop()
{
  running_ = false;
}

void
Replay::leave()
{
  running_ = false;
  flight_.reset();
  if (marker_)
    stage_.renderer()->RemoveActor(marker_);
  marker_ = nullptr;
}

void
Replay::advance(double seconds)
{
  if (!running_)
    return;
  time_ = std::min(time_ + seconds, flight_->seconds());
  place(marker_, flight_->poseAt(time_));
  stage_.look(flight_->eyeAt(time_));
  // for a trajectory without length the first frame is the last one
  running_ = time_ < flight_->seconds();
}

std::string
Replay::describe() const
{
  if (!flight_)
    return {};
  return "pose " + std::to_string(flight_->rowAt(time_)) + " of 0 to " +
         std::to_string(stage_.trajectory().poses.size() - 1);
}

} // namespace pcl::acmap
