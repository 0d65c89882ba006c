#pragma once

namespace pcl::acmap {

/** \brief The style sheet of the report page, for screens, phones and print. */
const char*
pageStyle();

} // namespace pcl::acmap
