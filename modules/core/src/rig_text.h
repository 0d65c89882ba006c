#pragma once

#include <pcl/core/trinocular_rig.h>

#include <string>

namespace pcl::acmap {

/** \brief The text of a `rig.yaml` with a sound rig. */
std::string
rigText(const TrinocularRig& rig);

} // namespace pcl::acmap
