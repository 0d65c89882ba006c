#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/core/impl/yaml_node.h>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <optional>
#include <set>
#include <sstream>

namespace pcl::acmap {

/** \brief Builds the tree from the events of the parser: yaml-cpp's own nodes resolve
 * aliases, so that a short document could fill the memory. */
class YamlTree : public YAML::EventHandler {
public:
  explicit YamlTree(std::string name)
  : file_(std::make_shared<const std::string>(std::move(name)))
  {}

  YamlNode
  take()
  {
    if (!root_ || root_->kind() != YamlNode::Kind::map)
      throw InputFileException(*file_ + ": has no map of keys and values");
    return std::move(*root_);
  }

  void
  OnDocumentStart(const YAML::Mark&) override
  {}

  void
  OnDocumentEnd() override
  {}

  void
  OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override
  {
    OnScalar(mark, {}, anchor, {});
  }

  void
  OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
  {
    refuseAnchor(mark);
  }

  void
  OnScalar(const YAML::Mark& mark,
           const std::string&,
           YAML::anchor_t anchor,
           const std::string& value) override
  {
    YamlNode node = begin(YamlNode::Kind::scalar, mark, anchor);
    node.text_ = value;
    place(std::move(node));
  }

  void
  OnSequenceStart(const YAML::Mark& mark,
                  const std::string&,
                  YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override
  {
    open(begin(YamlNode::Kind::list, mark, anchor));
  }

  void
  OnSequenceEnd() override
  {
    close();
  }

  void
  OnMapStart(const YAML::Mark& mark,
             const std::string&,
             YAML::anchor_t anchor,
             YAML::EmitterStyle::value) override
  {
    open(begin(YamlNode::Kind::map, mark, anchor));
  }

  void
  OnMapEnd() override
  {
    close();
  }

private:
  struct Open {
    YamlNode node;
    std::set<std::string> keys;
  };

  [[noreturn]] void
  refuseAnchor(const YAML::Mark& mark) const
  {
    nodeAt(YamlNode::Kind::scalar, mark).fail("anchors and aliases are not read");
  }

  YamlNode
  nodeAt(YamlNode::Kind kind, const YAML::Mark& mark) const
  {
    return {kind, file_, mark.line + 1, mark.column + 1};
  }

  YamlNode
  begin(YamlNode::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor)
  {
    if (anchor != YAML::NullAnchor)
      refuseAnchor(mark);
    YamlNode node = nodeAt(kind, mark);
    if (++count_ > max_values)
      node.fail("has more than " + std::to_string(max_values) +
                " values, more than a YAML file of acmap ever has");
    return node;
  }

  void
  open(YamlNode node)
  {
    if (open_.size() == deepest)
      node.fail("is nested more than " + std::to_string(deepest) + " deep");
    open_.push_back({std::move(node), {}});
  }

  void
  close()
  {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    place(std::move(node));
  }

  void
  place(YamlNode node)
  {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    YamlNode& parent = open_.back().node;
    if (parent.kind_ == YamlNode::Kind::list)
      parent.values_.push_back(std::move(node));
    else if (parent.keys_.size() == parent.values_.size())
      placeKey(std::move(node));
    else {
      const YamlNode& key = parent.keys_.back();
      node.name_ = key.text_;
      if (node.kind_ == YamlNode::Kind::scalar && node.text_.empty()) {
        // A missing value is reported at the position of its key, because the parser
        // reports it at the position of the next token.
        node.line_ = key.line_;
        node.column_ = key.column_;
      }
      parent.values_.push_back(std::move(node));
    }
  }

  void
  placeKey(YamlNode key)
  {
    Open& map = open_.back();
    if (!map.keys.insert(key.text()).second)
      key.fail("key " + inQuotes(key.text()) + " stands twice");
    map.node.keys_.push_back(std::move(key));
  }

  static constexpr std::size_t max_values = 300000;
  static constexpr std::size_t deepest = 64;

  std::shared_ptr<const std::string> file_;
  std::vector<Open> open_;
  std::size_t count_ = 0;
  std::optional<YamlNode> root_;
};

YamlNode
parseYaml(const std::string& name, const std::string& text)
{
  YamlTree tree(name);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(tree);
  }
  catch (const YAML::Exception& exception) {
    constexpr std::size_t longest = 200; // maximum length of a message
    throw InputFileException(name + ": line " +
                             std::to_string(exception.mark.line + 1) + ", column " +
                             std::to_string(exception.mark.column + 1) +
                             ": is no YAML: " + inPrint(exception.msg, longest));
  }
  return tree.take();
}

YamlNode
loadYaml(const std::string& path)
{
  constexpr std::uint64_t max_bytes = std::uint64_t{16} << 20;
  ByteSource source(path);
  if (source.remaining() > max_bytes)
    source.fail("has " + std::to_string(source.remaining()) +
                " bytes, more than a YAML file of acmap ever has");
  std::string text(static_cast<std::size_t>(source.remaining()), ' ');
  source.read(text.data(), text.size());
  return parseYaml(path, text);
}

} // namespace pcl::acmap
