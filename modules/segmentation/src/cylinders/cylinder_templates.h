#pragma once

#include <pcl/core/cylinder_patch.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap::cylinders {

/** Gives cylinders whose radii agree within their standard deviations one radius, fitted to
 * all of them, and one number, in the order of the cylinders.
 * \return the number of templates */
std::size_t
shareRadii(std::vector<CylinderPatch>& patches);

} // namespace pcl::acmap::cylinders
