#pragma once

#include <pcl/core/yaml_node.h>

#include <Eigen/Core>

#include <string>

namespace pcl::acmap {

/** \brief Largest coordinate of a scene, metres. */
constexpr double farthest_place = 1e4;

/** \brief Reads a list of three numbers: a position or an edge, metres. */
Eigen::Vector3d
vectorOf(const YamlNode& node);

/** \brief Reads an angle of at most two full turns in degrees and returns radians. */
double
angleOf(const YamlNode& node);

/** \brief The only key of a map, such as `box` in `- box: {...}`.
 * \throws InputFileException unless there is exactly one key */
const YamlNode&
onlyKeyOf(const YamlNode& node);

/** \brief Runs an action that may reject a value; the error then names the line of the
 * node. */
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
