#pragma once

#include <pcl/core/export.h>

#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief Base 64 with padding, on one line. */
ACMAP_EXPORT std::string
base64(std::string_view bytes);

} // namespace pcl::acmap
