#pragma once

#include "small_scenes.h"

#include <pcl/simulation/simulated_observation.h>

namespace pcl::acmap::test {

/** \brief Change of inverse depth for one disparity step, 1/m. */
double
inverseStep(const SimulatedScene& scene);

SimulatedScene
standardSeenByKinect(const std::string& name);

/** \brief A crop of a Kinect's image with full resolution. */
void
useSmallKinect(SimulatedScene& scene, int width = 160);

SimulatedScene
wallSeenByKinect(double depth, int width = 160);

/** \brief A wall at 3 m, and in front of its centre a board of 20 cm at 1.5 m. */
SimulatedScene
boardBeforeAWall();

/** \brief A plane that intersects the optical axis at 1 m, rotated about y. */
SimulatedScene
slantedWall(double degrees);

/** \brief A view with its true depths. */
struct SeenView {
  explicit SeenView(const SimulatedScene& scene, std::size_t view = 0)
  : image(castView(scene.geometry, scene.rig, scene.views[view]))
  , observation(observe(scene, image, view, 1))
  , rig(scene.rig)
  {}

  const ObservationPixel&
  at(int row, int column) const
  {
    return observation.pixels[indexOf(row, column)];
  }

  std::size_t
  indexOf(int row, int column) const
  {
    return static_cast<std::size_t>(row * observation.width + column);
  }

  double
  trueDepth(int row, int column) const
  {
    return image.distance[indexOf(row, column)] * pixelRay(rig, column, row).z();
  }

  /** \brief Error of inverse depth, 1/m; NaN if nothing was measured. */
  double
  error(int row, int column) const
  {
    return 1.0 / static_cast<double>(at(row, column).z) - 1.0 / trueDepth(row, column);
  }

  bool
  isAwayFromEdges(int row, int column, int distance) const
  {
    if (row < distance || row >= observation.height - distance || column < distance ||
        column >= observation.width - distance)
      return false;
    for (int r = row - distance; r <= row + distance; ++r)
      for (int c = column - distance; c <= column + distance; ++c)
        if (image.surface[indexOf(r, c)] != image.surface[indexOf(row, column)])
          return false;
    return true;
  }

  double
  measuredShare() const
  {
    return static_cast<double>(observation.points) /
           static_cast<double>(observation.pixels.size());
  }

  SurfaceImage image;
  SimulatedObservation observation;
  TrinocularRig rig;
};

} // namespace pcl::acmap::test
