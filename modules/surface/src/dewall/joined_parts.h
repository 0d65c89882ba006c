#pragma once

#include "triangle_builder.h"

namespace pcl::acmap::dewall {

/** \brief Numbers the components of all parts through, in their triangles and in the
 * arrays, and joins them by parity.
 *
 * Two halves may close a Moebius band together that neither sees: then the triangles that
 * contradict what stands before them, in the order of the parts, are taken out.
 * \param[out] removed those triangles
 * \return the mesh of all points, for the last passes; the triangles stay in the parts */
GrowingMesh
joinParts(MeshArrays& arrays,
          std::vector<Part>& parts,
          std::vector<GrownTriangle>& removed);

} // namespace pcl::acmap::dewall
