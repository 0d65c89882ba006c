#pragma once

#include "labeling/candidate_grid.h"
#include "outlines/loop.h"
#include "planes/known_planes.h"

#include <pcl/core/triangle_mesh.h>

#include <optional>

namespace pcl::acmap {

namespace outlines {

/** Converts loops to polygons and adds them to the patch, with their area: each hole is
 * assigned to the smallest rim around it. Small holes and islands of a few triangles
 * are artefacts of the mesh and are ignored. The loops may cross, because they were
 * moved onto lines and simplified independently.
 * \param[in] shaped in the patch's frame, metres
 * \param[in] min_area minimum area of a polygon or a hole, square metres
 * \param[in] spacing metres; points within a thousandth of it are merged */
void
setPolygons(const std::vector<Loop>& shaped,
            double min_area,
            double spacing,
            PlanePatch& patch);

/** \brief The boundaries of the mesh on planes. */
class MeshOutlines {
public:
  /** Takes time for all points and faces, unless no plane is wanted.
   * \param[in] is_wanted for each plane, will it be outlined?
   * \param[in] known must outlive this object
   * \param[in] most_of_faces how much more than its faces a rectangle may cover */
  MeshOutlines(const TriangleMesh::Triangles& triangles,
               const std::vector<bool>& is_wanted,
               const KnownPlanes& known,
               double most_of_faces);

  /** Sets the polygons of a plane that is wanted: the boundaries of its mesh faces, moved onto the
   * intersection lines with its neighbours and simplified with a tolerance of one
   * spacing. Openings are kept. A plane without such a polygon, and a strip, gets
   * rectangles where its points are, unless these are so many times the faces that they
   * stand for: rings of a scanner enclose what was not seen.
   * \param[in,out] patch of the plane, without polygons; their area is added to its */
  void
  outline(std::size_t plane, PlanePatch& patch) const;

private:
  const KnownPlanes& known_;
  double most_of_faces_;
  std::optional<labeling::CandidateGrid> grid_;
  std::vector<TriangleMesh::Triangles> of_planes_;
  std::vector<double>
      seen_areas_; ///< of the faces with a side on the plane, square metres
};

} // namespace outlines

/** Sets the polygons of all planes to the boundaries of the mesh, as in the paper's mode.
 * The area of each plane is set to that of its polygons. */
void
outlineFromMesh(const TriangleMesh::Triangles& triangles, KnownPlanes& known);

} // namespace pcl::acmap
