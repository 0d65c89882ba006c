#pragma once

#include <pcl/simulation/simulated_scene.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap {

constexpr const char* rig_name = "rig.yaml";
constexpr const char* truth_name = "truth.json";

/** \brief Number of points that a session has, or can have, on the true planes. */
struct PointCounts {
  std::size_t all = 0;
  /** \brief Index: label, the plane of the scene + 1; 0 is on no plane. */
  std::vector<std::size_t> of_label;
};

/** \brief The first fields of every `truth.json`. */
nlohmann::ordered_json
truthHead(const SimulatedScene& scene, std::uint64_t seed, std::size_t observations);

/** \brief The true planes in the map frame.
 * \param[in] counts added to each plane */
nlohmann::ordered_json
truthPlanes(const SimulatedScene& scene, const PointCounts& counts);

/** \throws OutputFileException when it could not be written completely */
void
saveTruth(const std::string& path, const nlohmann::ordered_json& truth);

} // namespace pcl::acmap
