#pragma once

#include <vector>

namespace pcl::acmap {

/** \brief A file of share/scenes. */
struct StandardSceneText {
  const char* name; // without its ending
  const char* text;
};

/** \brief All of them; CMake writes the list. */
const std::vector<StandardSceneText>&
standardSceneTexts();

} // namespace pcl::acmap
