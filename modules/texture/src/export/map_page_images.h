#pragma once

#include <pcl/core/compact_map.h>

#include <filesystem>
#include <string>

namespace pcl::acmap {

/** \throws InputFileException when it cannot be read, or is empty */
std::string
bytesOf(const std::filesystem::path& path);

/** \brief JSON as the content of a script element: no text in it ends the element. */
std::string
inScript(std::string json);

/** \brief Has an observation seen the colour of a texel? True for maps without images of kinds.
 * \throws InputFileException when one cannot be read */
bool
hasSeenTexels(const CompactMap& map, const std::filesystem::path& folder);

/** \brief The images of kinds that a map names, as JSON: base64 by name.
 * \throws InputFileException as \ref bytesOf */
std::string
kindsOf(const CompactMap& map, const std::filesystem::path& folder);

/** \brief Small pictures of the large pages of a map, which a browser shows until it has
 * unpacked these, as JSON: {"size":[columns,rows],"jpeg":"base64"} by name.
 * \throws InputFileException when a page cannot be read */
std::string
previewsOf(const CompactMap& map, const std::filesystem::path& folder);

} // namespace pcl::acmap
