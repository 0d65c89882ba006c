#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::acmap {

class YamlNode;

/** \brief The newest format of each kind of file that acmap writes, which is the newest it
 * reads; see doc/formats.md. A file tells its own; one that does not is of format 1.
 * \ingroup core */
namespace file_formats {

inline constexpr std::size_t map = 1;     ///< map.json, PLANES.json
inline constexpr std::size_t rig = 1;     ///< rig.yaml, rectified or calibrated
inline constexpr std::size_t scene = 1;   ///< of pcl_simulated_rig
inline constexpr std::size_t session = 1; ///< session.yaml, where the key is version
inline constexpr std::size_t frame = 1;   ///< frame_000000.acf
inline constexpr std::size_t truth = 1;   ///< truth.json
inline constexpr std::size_t figures = 1; ///< of pcl_paper_figures
inline constexpr std::size_t camera = 1;  ///< of pcl_rgbd_import
inline constexpr std::size_t stage = 1;   ///< stage.json
inline constexpr std::size_t report = 1;  ///< report.json

} // namespace file_formats

/** \brief Why a file of a format cannot be read, to follow its name; empty when it can.
 * \param[in] newest that is known \ingroup core */
ACMAP_EXPORT std::string
faultOfFormat(std::uint64_t format, std::size_t newest);

/** \brief Refuses a document that a newer acmap wrote.
 * \param[in] document a map; without the key it is of format 1
 * \param[in] newest that is known
 * \param[in] key that has the format's number
 * \throws InputFileException naming both formats \ingroup core */
ACMAP_EXPORT void
requireFormat(const YamlNode& document,
              std::size_t newest,
              const std::string& key = "format");

} // namespace pcl::acmap
