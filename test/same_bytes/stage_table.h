#pragma once

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A run of a tool on what earlier stages of the table made. */
struct Stage {
  std::string name;
  std::string program;
  /** \brief Of `<` and a path: what an earlier stage made, by its name; of `>` and a
   * name: what this one makes; the rest as it stands. */
  std::vector<std::string> arguments;
  bool has_threads = true;    ///< it takes --threads
  bool needs_display = false; ///< its pictures differ with the renderer: no fingerprint
};

/** \brief All tools that compute, in an order in which each finds its inputs. */
const std::vector<Stage>&
stageTable();

/** \brief Names of what is there before the first stage. */
constexpr const char *scene_file = "small_corridor.yaml", *boards_folder = "boards",
                     *recording_folder = "recording";

/** \brief Board images of three cameras that \ref boards_folder holds. */
constexpr std::size_t board_shots = 6;

} // namespace pcl::acmap::test
