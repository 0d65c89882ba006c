#include "yaml_values.h"

namespace pcl::acmap {

Eigen::Vector3d
vectorOf(const YamlNode& node)
{
  const auto& items = node.list(3, 3);
  Eigen::Vector3d vector;
  for (int axis = 0; axis < 3; ++axis)
    vector[axis] =
        items[static_cast<std::size_t>(axis)].number(-farthest_place, farthest_place);
  return vector;
}

double
angleOf(const YamlNode& node)
{
  constexpr double max_degrees = 720.0;
  constexpr double degree = 3.14159265358979323846 / 180.0;
  return node.number(-max_degrees, max_degrees) * degree;
}

const YamlNode&
onlyKeyOf(const YamlNode& node)
{
  if (node.keys().size() != 1)
    node.fail("one key is needed here, not " + std::to_string(node.keys().size()));
  return node.keys().front();
}

} // namespace pcl::acmap
