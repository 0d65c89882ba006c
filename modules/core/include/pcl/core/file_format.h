#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::acmap {

class YamlNode;

/** \brief The newest format of each kind of file that acmap writes, which is also the
 * newest one that it reads; see doc/formats.md. The format is stored in the file;
 * without it, the file has format 1. \ingroup core */
namespace file_formats {

inline constexpr std::size_t map = 2;     ///< map.json, PLANES.json
inline constexpr std::size_t rig = 2;     ///< rig.yaml, rectified or calibrated
inline constexpr std::size_t scene = 1;   ///< of pcl_simulated_rig
inline constexpr std::size_t session = 1; ///< session.yaml, with the key version
inline constexpr std::size_t frame = 1;   ///< frame_000000.acf
inline constexpr std::size_t truth = 1;   ///< truth.json
inline constexpr std::size_t figures = 1; ///< of acmap_paper_figures
inline constexpr std::size_t camera = 1;  ///< of pcl_rgbd_import
inline constexpr std::size_t stage = 2;   ///< stage.json
inline constexpr std::size_t report = 1;  ///< report.json
inline constexpr std::size_t poses = 2;   ///< poses.yaml

} // namespace file_formats

/** \brief Describes why a file of a format cannot be read, as a continuation of the
 * file name; empty if it can be read.
 * \param[in] newest newest known format \ingroup core */
ACMAP_EXPORT std::string
faultOfFormat(std::uint64_t format, std::size_t newest);

/** \brief Rejects a document that was written by a newer version of acmap.
 * \param[in] document a map; without the key it has format 1
 * \param[in] newest newest known format
 * \param[in] key key of the format number
 * \throws InputFileException naming both formats \ingroup core */
ACMAP_EXPORT void
requireFormat(const YamlNode& document,
              std::size_t newest,
              const std::string& key = "format");

} // namespace pcl::acmap
