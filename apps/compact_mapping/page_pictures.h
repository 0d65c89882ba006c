#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Base 64 with padding, on one line. */
std::string
base64(const std::vector<std::uint8_t>& bytes);

/** \brief A figure with an embedded PNG; if the file is missing or is no complete PNG,
 * the figure says so instead.
 * \param[in] path of the file
 * \param[in] name title of the picture
 * \param[in] caption may be empty */
std::string
pictureFigure(const std::string& path,
              const std::string& name,
              const std::string& caption);

} // namespace pcl::acmap
