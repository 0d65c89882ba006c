#include <pcl/core/impl/yaml_node.h>

#include "files/text_number.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

const YamlNode*
YamlNode::find(const std::string& key) const
{
  const auto& known = keys();
  const auto at = std::find_if(
      known.begin(), known.end(), [&](const auto& k) { return k.text_ == key; });
  return at == known.end() ? nullptr : &values_[std::size_t(at - known.begin())];
}

const YamlNode&
YamlNode::at(const std::string& key) const
{
  const YamlNode* const value = find(key);
  if (!value)
    fail("key " + inQuotes(key) + " is missing");
  return *value;
}

const std::vector<YamlNode>&
YamlNode::keys() const
{
  if (kind_ != Kind::map)
    fail("a map of keys and values is needed here");
  return keys_;
}

void
YamlNode::requireKeys(const std::vector<std::string>& known) const
{
  for (const YamlNode& key : keys()) {
    if (std::find(known.begin(), known.end(), key.text_) != known.end())
      continue;
    std::string list;
    for (const std::string& name : known)
      list += (list.empty() ? "" : ", ") + name;
    key.fail("key " + inQuotes(key.text_) + " is not known here; known are " + list);
  }
}

const std::vector<YamlNode>&
YamlNode::list(std::size_t minimum, std::size_t maximum) const
{
  if (kind_ == Kind::list && values_.size() >= minimum && values_.size() <= maximum)
    return values_;
  const std::string length =
      minimum == maximum ? std::to_string(minimum)
                         : std::to_string(minimum) + " to " + std::to_string(maximum);
  fail("a list of " + length + " values is needed here" +
       (kind_ == Kind::list ? ", not of " + std::to_string(values_.size()) : ""));
}

const std::string&
YamlNode::text() const
{
  if (kind_ != Kind::scalar || text_.empty())
    fail("a single value is needed here");
  return text_;
}

double
YamlNode::number(double minimum, double maximum) const
{
  double value = 0;
  if (parseNumber(text(), value) && std::isfinite(value) && value >= minimum &&
      value <= maximum)
    return value;
  std::ostringstream fault;
  fault << inQuotes(text_) << " is refused: a number within [" << minimum << ", "
        << maximum << "] is needed here";
  fail(fault.str());
}

std::size_t
YamlNode::count(std::size_t minimum, std::size_t maximum) const
{
  std::uint64_t value = 0;
  if (parseCount(text(), value) && value >= minimum && value <= maximum)
    return static_cast<std::size_t>(value);
  fail(inQuotes(text_) + " is refused: a whole number within [" +
       std::to_string(minimum) + ", " + std::to_string(maximum) + "] is needed here");
}

bool
YamlNode::boolean() const
{
  if (text() != "true" && text_ != "false")
    fail(inQuotes(text_) + " is refused: true or false is needed here");
  return text_ == "true";
}

void
YamlNode::fail(const std::string& fault) const
{
  constexpr std::size_t longest_name = 40;
  throw InputFileException(*file_ + ": line " + std::to_string(line_) + ", column " +
                           std::to_string(column_) + ": " +
                           (name_.empty() ? "" : inPrint(name_, longest_name) + ": ") +
                           fault);
}

} // namespace pcl::acmap
