#pragma once

#include "stage_log.h"

#include <pcl/core/impl/point_view.h>

#include <string>

namespace pcl::acmap {

/** \brief Compares a length that the user gave in metres with the extent of the cloud
 * that it divides: warns if only few parts are left.
 * \param[in] option its name, with its dashes
 * \param[in] points in metres
 * \throws UsageError if it exceeds the cloud, for example if it was given in
 * millimetres */
void
requireFineLength(const std::string& option,
                  double metres,
                  const PointView& points,
                  StageLog& log);

} // namespace pcl::acmap
