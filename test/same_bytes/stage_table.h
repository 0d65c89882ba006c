#pragma once

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A run of a tool on outputs of earlier stages of the table. */
struct Stage {
  std::string name;
  std::string program;
  /** \brief `<` and a path is the output of an earlier stage, starting with its name;
   * `>` and a name is an output of this stage; all others are passed unchanged. */
  std::vector<std::string> arguments;
  bool has_threads = true;    ///< supports --threads
  bool needs_display = false; ///< its pictures depend on the renderer: no fingerprint
};

/** \brief All tools that compute something, in an order in which their inputs exist. */
const std::vector<Stage>&
stageTable();

/** \brief Names of the inputs that exist before the first stage. */
constexpr const char *scene_file = "small_corridor.yaml", *boards_folder = "boards",
                     *recording_folder = "recording";

/** \brief Number of board images of three cameras in \ref boards_folder. */
constexpr std::size_t board_shots = 6;

} // namespace pcl::acmap::test
