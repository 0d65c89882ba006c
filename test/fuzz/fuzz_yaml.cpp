#include "checks.h"

#include <pcl/core/impl/yaml_node.h>

#include <cmath>

using namespace pcl::acmap;

namespace {

/** The properties of a node are consistent with its accessors. Exceptions take time, so
 * the number of visited nodes is limited. */
void
walk(const YamlNode& node, int& left)
{
  constexpr std::size_t maximum = std::size_t{1} << 31;
  if (left-- <= 0)
    return;
  test::acceptedBy([&] { return node.text().size(); });
  test::acceptedBy([&] { return node.boolean(); });
  if (const auto number = test::acceptedBy([&] { return node.number(-1e9, 1e9); }))
    test::require(std::abs(*number) <= 1e9);
  if (const auto count = test::acceptedBy([&] { return node.count(1, maximum); }))
    test::require(*count >= 1 && *count <= maximum);
  switch (node.kind()) {
  case YamlNode::Kind::scalar:
    break;
  case YamlNode::Kind::list:
    for (const YamlNode& value : node.list(0, maximum))
      walk(value, left);
    break;
  case YamlNode::Kind::map:
    for (const YamlNode& key : node.keys()) {
      test::require(node.find(key.text()) == &node.at(key.text()));
      walk(node.at(key.text()), left);
    }
    break;
  }
}

} // namespace

/** Bytes are rejected, or give a tree whose nodes can be visited. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  int nodes = 8;
  if (const auto tree = test::acceptedBy([&] { return parseYaml("input", text); }))
    walk(*tree, nodes);
  return 0;
}
