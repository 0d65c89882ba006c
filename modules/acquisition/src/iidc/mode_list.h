#pragma once

#include "register_access.h"

#include <pcl/acquisition/iidc_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief The format whose modes have sizes and packets to choose. */
constexpr int scalable_format = 7;

/** \brief The modes that a camera claims to have and that make sense, ascending. Those of
 * format 7 come once for each colour. */
std::vector<IidcMode>
listModes(const RegisterAccess& camera);

/** \brief Frames a second of a rate's number in the registers, 0 to 7. */
float
fixedRate(unsigned number);

} // namespace pcl::acmap
