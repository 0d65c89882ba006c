#pragma once

#include "clouds.h"
#include "mesh_checker.h"

namespace pcl::acmap::test {

/** \brief How a mesh lies on its truth, in percent of the interior's area. */
struct Coverage {
  double uncovered = 0;
  double overlapped = 0; ///< lies under more than one triangle
};

/** \brief Rasters the triangles, unrolled to the sheet's parameters, and counts.
 * \param[in] margin left out along the rim, in spacings
 * \param[in] resolution samples per spacing */
Coverage
measureCoverage(const SheetCloud& sheet,
                const Triangles& mesh,
                double margin = 2,
                double resolution = 16);

} // namespace pcl::acmap::test
