#pragma once

#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/egomotion/impl/egomotion_kernel.h>
#include <pcl/egomotion/revisit_detection_types.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref detectRevisits; see RevisitDetection. */
struct RevisitSettings {
  std::size_t min_separation = 10; ///< views between the two of a revisit
};

/** \brief Returns a view; called from several threads, several times for each view. */
using CameraViewReader = std::function<CameraView(std::size_t)>;

/** \brief Finds pairs of views that see the same place.
 * \param[out] report counts are added
 * \return in the order of the later view, then of the earlier one
 * \throws CancelledException when the progress callback cancels */
ACMAP_EXPORT std::vector<Revisit>
detectRevisits(const CameraViewReader& read,
               std::size_t views,
               const RevisitSettings& settings,
               const Progress& progress,
               RevisitReport& report);

} // namespace pcl::acmap
