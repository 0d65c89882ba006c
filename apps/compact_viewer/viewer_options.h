#pragma once

#include "tool.h"

#include <pcl/visualization/layered_scene.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

struct ViewerOptions {
  std::string input;
  std::string screenshot;
  std::vector<float> from;
  std::vector<float> look;
  std::vector<float> up;
  std::string size = "1280x960";
  std::vector<std::string> layers;
  std::string place;
  std::optional<std::size_t> at_pose;
  std::optional<std::size_t> wall_step;
  bool before = false;
  bool boundary = false;
  bool hide_backs = false;
  bool grey = false;
  bool labels = false;
};

void
addOptions(Tool& tool, ViewerOptions& options);

/** \throws UsageError for options that exclude each other */
LayeredView
viewOf(const ViewerOptions& options);

} // namespace pcl::acmap
