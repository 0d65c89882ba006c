#pragma once

#include "clouds.h"
#include "mesh_checker.h"

namespace pcl::acmap::test {

/** \brief How well a mesh covers its true surface, in percent of the interior's
 * area. */
struct Coverage {
  double uncovered = 0;
  double overlapped = 0; ///< covered by more than one triangle
};

/** \brief Rasterizes the triangles in the parameters of the sheet.
 * \param[in] margin ignored along the border, in spacings
 * \param[in] resolution samples per spacing */
Coverage
measureCoverage(const SheetCloud& sheet,
                const Triangles& mesh,
                double margin = 2,
                double resolution = 16);

} // namespace pcl::acmap::test
