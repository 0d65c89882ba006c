#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/stage_controls.h>
#include <pcl/memory.h>
#include <pcl/segmentation/box_fitting_types.h>

#include <utility>
#include <vector>

namespace pcl {

/** \brief Finds the boxes among the planes of a map: furniture, crates and pillars.
 *
 * It is future work (ii) of "Active Stereo Based Compact Mapping" (IV). A box begins at
 * a convex edge of two polygons at a right angle, and takes further polygons that meet
 * it in convex edges. Sides that were not seen are where a plane of the map bounds the
 * box, such as the floor, or where its faces end. One side may be slanted: a polygon at
 * another angle that has convex edges with two others. A box is taken if at least four
 * sides are planes, seen or bounding, and if its parameters and the residuals of its faces
 * need fewer bits than the planes. Boxes whose sizes agree within their standard
 * deviations share one size, as instances of a template.
 *
 * Rooms are no boxes, because they are seen from inside: their edges are concave. A box
 * that spans from plane to plane, as from floor to ceiling, must be longer in that
 * direction than wide, with all sides known: a block between corridors is no box.
 *
 * Input and result are in metres, in the frame of the planes. The result is the same for
 * every number of threads: the search uses one. It takes O(n^2) for n polygons.
 * \code
 * pcl::BoxFitting fitting;
 * fitting.setPlanes (planes);                          // of PlaneHypothesisClustering
 * std::vector<pcl::BoxPatch> boxes;
 * fitting.segment (boxes);
 * for (const pcl::BoxPatch& box : boxes)
 *   std::cout << box.size.transpose () << " m\n";
 * \endcode
 * \ingroup segmentation */
class ACMAP_EXPORT BoxFitting : public StageControls<BoxFittingReport> {
public:
  using Ptr = shared_ptr<BoxFitting>;
  using ConstPtr = shared_ptr<const BoxFitting>;

  /** \brief Sets the planes with their polygons and covariances. Planes that are not
   * finite, or have no normal of length 1, are skipped and counted. */
  void
  setPlanes(std::vector<PlanePatch> planes)
  {
    planes_ = std::move(planes);
    has_planes_ = true;
  }

  const std::vector<PlanePatch>&
  getPlanes() const
  {
    return planes_;
  }

  /** \brief Finds the boxes.
   * \param[out] boxes by falling volume; empty, with the reason in the report, if
   * there are none. Their faces name the planes by their index.
   * \throws InitFailedException without planes: \ref setPlanes was not called
   * \throws CancelledException if the progress callback stopped it */
  void
  segment(std::vector<BoxPatch>& boxes);

private:
  std::vector<PlanePatch> planes_;
  bool has_planes_ = false;
};

} // namespace pcl
