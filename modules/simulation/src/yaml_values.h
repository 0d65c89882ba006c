#pragma once

#include <pcl/core/yaml_node.h>

#include <Eigen/Core>

#include <string>

namespace pcl::acmap {

/** \brief Largest coordinate of a scene, metres. */
constexpr double farthest_place = 1e4;

/** \brief Three numbers in a list: a place or an edge, metres. */
Eigen::Vector3d
vectorOf(const YamlNode& node);

/** \brief Degrees within a full turn or two, as radians. */
double
angleOf(const YamlNode& node);

/** \brief The one key of a map of one, such as `box` in `- box: {...}`.
 * \throws InputFileException when there are none or several */
const YamlNode&
onlyKeyOf(const YamlNode& node);

/** \brief Runs what may refuse a value; the refusal then names the line of the node. */
template <typename Action>
void
atLineOf(const YamlNode& node, const Action& action)
{
  try {
    action();
  }
  catch (const BadArgumentException& exception) {
    // PCL puts ": " before every message
    const std::string fault = exception.what();
    node.fail(fault.substr(fault.find_first_not_of(": ")));
  }
}

} // namespace pcl::acmap
