#pragma once

#include "map_faces.h"
#include "map_lines.h"
#include "scene_renderer.h"
#include "vtk_pieces.h"

namespace pcl::acmap {

/** \brief Faces with the colours of their charts, without lighting; those without a
 * chart are grey, with lighting, and so are all if no chart has a known colour.
 * \param[in] exposure of the map */
Actors
actorsOfTextures(const std::vector<MapFaces>& faces, double exposure, bool hide_backs);

/** \brief Faces in the colours of their planes.
 * \param[in] opacity 0 to 1 */
Actors
actorsOfPlanes(const std::vector<MapFaces>& faces, bool hide_backs, double opacity);

/** \brief Lines in the colours of their planes. */
vtkSmartPointer<vtkActor>
actorOfOutlines(const std::vector<MapLine>& lines);

/** \brief The lines of one surface, which can be hidden while it looks away. */
struct SurfaceOutline {
  vtkSmartPointer<vtkActor> lines;
  Eigen::Vector4d plane; ///< of a cylinder: in the middle of its arc

  /** \brief Does the surface look away from an eye? */
  bool
  looksAway(const Eigen::Vector3d& eye) const
  {
    return plane.dot(eye.homogeneous()) < 0;
  }
};

/** \brief Lines in one colour. */
vtkSmartPointer<vtkActor>
actorOfLines(const std::vector<MapLine>& lines, const Color& color, double pixels);

/** \brief A line through the poses. */
MapLine
lineOf(const Trajectory& trajectory);

/** \brief Adds the places of the poses to points that a camera has to see, so often that
 * none is left out as noise. */
void
addPlaces(const Trajectory& trajectory, std::vector<Eigen::Vector3f>& points);

/** \brief A line through the poses, and at up to 50 of them the axes x (red), y (green)
 * and z (blue) of the camera.
 * \param[in] length of the axes, metres */
Actors
actorsOfTrajectory(const Trajectory& trajectory, double length);

constexpr Color trajectory_color = {0.90, 0.10, 0.45};

} // namespace pcl::acmap
