#pragma once

#include "camera.h"
#include "map_actors.h"
#include "map_camera.h"

#include <pcl/visualization/map_snapshot.h>

#include <vtkRenderer.h>

#include <string>

namespace pcl::acmap {

/** \brief A map and its view; creates the actors. */
class MapDrawing {
public:
  /** \param[in] map must outlive this object
   * \param[in] others points that the first camera has to see, too
   * \throws BadArgumentException for an invalid view
   * \throws InitFailedException when the map has no face */
  MapDrawing(const CompactMap& map,
             const MapView& view,
             const std::vector<Eigen::Vector3f>& others = {});

  const Camera&
  camera() const
  {
    return camera_;
  }

  const MapFrame&
  frame() const
  {
    return frame_;
  }

  /** \brief The visible faces without charts; a plan leaves some out. */
  std::vector<MapFaces>
  drawnFaces() const;

  bool
  hidesBacks() const
  {
    return hides_backs_;
  }

  /** \throws BadArgumentException for charts that do not fit the map */
  Actors
  textures() const;

  /** \param[in] opacity 0 to 1 */
  Actors
  planes(double opacity) const;

  Actors
  outlines() const;

  /** \brief Outlines of all drawn planes and cylinders. */
  std::vector<MapLine>
  outlineLines() const;

  /** \brief The outline of each drawn plane and cylinder, apart. */
  std::vector<SurfaceOutline>
  outlinesApart() const;

  /** \brief Adds walls, trajectory and scale bar to a plan; does nothing for other
   * views. */
  void
  addPlanTo(vtkRenderer* renderer) const;

private:
  /** \param[in] surface as the plane in MapFaces */
  std::vector<MapLine>
  linesOf(std::size_t surface) const;

  /** \param[in] plane as in MapFaces */
  bool
  isDrawn(std::size_t plane) const;

  std::vector<MapFaces>
  drawn(std::vector<MapFaces> faces) const;

  const CompactMap& map_;
  MapView view_;
  bool hides_backs_;
  std::vector<MapFaces> faces_;
  std::vector<Eigen::Vector3f> samples_;
  MapFrame frame_;
  Camera camera_;
};

} // namespace pcl::acmap
