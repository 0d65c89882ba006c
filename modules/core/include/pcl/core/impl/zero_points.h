#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/types.h>

#include <optional>

namespace pcl::acmap {

/** \brief The places of the points but those at (0, 0, 0), which invalid ones are in files of
 * some programs, if these are more than one of a thousand: a sensor there never measures
 * itself. Nothing otherwise, or if all are there. */
ACMAP_EXPORT std::optional<Indices>
withoutZeros(const PointView& points);

} // namespace pcl::acmap
