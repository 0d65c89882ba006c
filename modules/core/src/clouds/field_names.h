#pragma once

#include "clouds/field_layout.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl::acmap {

/** \brief PCL's name of a coordinate, a normal or a colour (`red`, `green`, `blue`) that a file
 * spells in another way, in capitals or as nx or diffuse_red; else an empty text. The single
 * letters r, g, b are not understood. */
std::string
standardName(std::string_view name);

/** \brief Gives coordinates, normals and colours PCL's names, unless another field has that
 * name already; r, g, b only if all three are there. */
void
renameFields(std::vector<SourceField>& fields);

} // namespace pcl::acmap
