#pragma once

#include "triangle_builder.h"

namespace pcl::acmap::dewall {

/** \brief Numbers the components of all parts consecutively, in their triangles and in
 * the arrays, and joins them with their orientations.
 *
 * Two halves together may form a Moebius strip, which none of them can detect. Then the
 * triangles that contradict previous ones, in the order of the parts, are removed.
 * \param[out] removed these triangles
 * \return the mesh of all points, for the last passes; the triangles remain in the
 * parts */
GrowingMesh
joinParts(MeshArrays& arrays,
          std::vector<Part>& parts,
          std::vector<GrownTriangle>& removed);

} // namespace pcl::acmap::dewall
