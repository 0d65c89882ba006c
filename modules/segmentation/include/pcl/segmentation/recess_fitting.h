#pragma once

#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/recess_patch.h>
#include <pcl/core/stage_controls.h>
#include <pcl/memory.h>
#include <pcl/segmentation/recess_fitting_types.h>

#include <utility>
#include <vector>

namespace pcl {

/** \brief Finds recesses in the walls of a map: closed doors, windows and niches.
 *
 * It is future work (ii) of "Active Stereo Based Compact Mapping" (IV), as \ref BoxFitting
 * is. A recess is a rectangular opening of a vertical wall, and a plane parallel to the
 * wall, the leaf, 3 to 50 cm behind it. The opening is enclosed by the wall, or reaches
 * down to the floor. A recess is taken if its parameters and the residuals of its planes
 * need fewer bits than leaf, outline and opening. Recesses whose sizes agree within their
 * standard deviations share one size, as doors in a row, and need bits only for their
 * place.
 *
 * Input and result are in metres, in the frame of the planes, whose vertical direction
 * is estimated (\ref upDirection). The result is the same for every number of threads:
 * the search uses one. It takes O(n^2) for n polygons.
 * \code
 * pcl::RecessFitting fitting;
 * fitting.setPlanes (planes);                          // of PlaneHypothesisClustering
 * std::vector<pcl::RecessPatch> recesses;
 * fitting.segment (recesses);
 * for (const pcl::RecessPatch& recess : recesses)
 *   std::cout << recess.size.transpose () << " m\n";
 * \endcode
 * \ingroup segmentation */
class ACMAP_EXPORT RecessFitting : public StageControls<RecessFittingReport> {
public:
  using Ptr = shared_ptr<RecessFitting>;
  using ConstPtr = shared_ptr<const RecessFitting>;

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

  /** \brief Finds the recesses.
   * \param[out] recesses by falling volume; empty, with the reason in the report, if
   * there are none. They name wall and leaf by their index.
   * \throws InitFailedException without planes: \ref setPlanes was not called
   * \throws CancelledException if the progress callback stopped it */
  void
  segment(std::vector<RecessPatch>& recesses);

private:
  std::vector<PlanePatch> planes_;
  bool has_planes_ = false;
};

} // namespace pcl
