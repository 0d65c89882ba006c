#pragma once

#include "register_access.h"

#include <pcl/acquisition/iidc_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief The format whose modes have variable image and packet sizes. */
constexpr int scalable_format = 7;

/** \brief Lists the modes that a camera reports and whose registers are valid, in
 * ascending order. A mode of format 7 is listed once per colour coding. */
std::vector<IidcMode>
listModes(const RegisterAccess& camera);

/** \brief Frames per second of a rate number of the registers, 0 to 7. */
float
fixedRate(unsigned number);

} // namespace pcl::acmap
