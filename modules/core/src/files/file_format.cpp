#include <pcl/core/file_format.h>
#include <pcl/core/impl/yaml_node.h>

#include <limits>

namespace pcl::acmap {

std::string
faultOfFormat(std::uint64_t format, std::size_t newest)
{
  if (format <= newest)
    return "";
  return "was written by a newer acmap (format " + std::to_string(format) +
         "; this one reads up to " + std::to_string(newest) + ")";
}

void
requireFormat(const YamlNode& document, std::size_t newest, const std::string& key)
{
  const YamlNode* const node = document.find(key);
  if (!node)
    return;
  const std::string fault =
      faultOfFormat(node->count(1, std::numeric_limits<std::size_t>::max()), newest);
  if (!fault.empty())
    node->fail("the file " + fault);
}

} // namespace pcl::acmap
