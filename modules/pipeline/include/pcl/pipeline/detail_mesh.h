#pragma once

#include <pcl/core/export.h>
#include <pcl/core/map_details.h>
#include <pcl/pipeline/plane_mapping_types.h>

#include <cstddef>

namespace pcl {

/** \brief Bytes of the details of a map by default, as \ref detailBytes counts them.
 * \ingroup pipeline */
inline constexpr std::size_t default_detail_bytes = 1000000;

/** \brief Makes the details of a map: the triangles of its mesh with a corner on no plane and
 * on no cylinder, simplified by edge collapses (quadric errors).
 *
 * Vertices beside a plane, within three times its noise or a spacing, belong to it. Connected pieces of less than 5 cm, or of fewer than 12 triangles, are left out: most of
 * them are noise. All others may deviate by half the spacing of the points; if they take more
 * than \a max_bytes then, they are simplified further, and the smallest pieces are left out.
 * \param[in] found planes with the mesh on which they were found
 * \param[in] max_bytes 0: no details
 * \return without colours where the points have none, then in a grey; empty without a mesh
 * \ingroup pipeline */
ACMAP_EXPORT MapDetails
makeDetails(const MappedPlanes& found, std::size_t max_bytes = default_detail_bytes);

/** \brief Bytes that details take in map.glb: positions as floats, colours of 16
 * bits, and indices. \ingroup pipeline */
ACMAP_EXPORT std::size_t
detailBytes(const MapDetails& details);

} // namespace pcl
