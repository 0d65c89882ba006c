#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A value of a YAML document that knows the line it stands on: a scalar, a list
 * or a map. Every fault is an \ref InputFileException with file, line, column.
 *
 * Anchors, aliases and keys that stand twice are refused: what a document takes in
 * memory is bounded by its length. \ingroup core */
class ACMAP_EXPORT YamlNode {
public:
  enum class Kind { scalar, list, map };

  YamlNode(Kind kind, std::shared_ptr<const std::string> file, int line, int column)
  : kind_(kind)
  , file_(std::move(file))
  , line_(line)
  , column_(column)
  {}

  Kind
  kind() const
  {
    return kind_;
  }

  /** \brief The value of a key, nullptr without it.
   * \throws InputFileException when this is no map */
  const YamlNode*
  find(const std::string& key) const;

  /** \throws InputFileException when this is no map or the key is missing */
  const YamlNode&
  at(const std::string& key) const;

  /** \brief The keys of a map, in their order; each tells its place. */
  const std::vector<YamlNode>&
  keys() const;

  /** \throws InputFileException naming the first key that is none of these */
  void
  requireKeys(const std::vector<std::string>& known) const;

  /** \param[in] least shortest length that is legal
   * \param[in] most longest length that is legal
   * \throws InputFileException when this is no list of such a length */
  const std::vector<YamlNode>&
  list(std::size_t least, std::size_t most) const;

  /** \throws InputFileException when this is no scalar or an empty one */
  const std::string&
  text() const;

  /** \brief A finite number in [least, most]. */
  double
  number(double least, double most) const;

  /** \brief A whole number in [least, most]. */
  std::size_t
  count(std::size_t least, std::size_t most) const;

  /** \brief `true` or `false`. */
  bool
  boolean() const;

  /** \brief Refuses the document because of this value.
   * \throws InputFileException "file: line 3, column 7: key: fault" */
  [[noreturn]] void
  fail(const std::string& fault) const;

private:
  friend class YamlTree;

  Kind kind_;
  std::shared_ptr<const std::string> file_;
  int line_;         // from 1
  int column_;       // from 1
  std::string name_; // the key whose value this is, empty elsewhere
  std::string text_;
  std::vector<YamlNode> keys_;
  std::vector<YamlNode> values_; // of a list, or of the keys
};

/** \brief Reads a YAML document that is a map. A first line `%YAML:1.0`, as OpenCV's
 * FileStorage writes it, is legal. At most 16 MB.
 * \throws InputFileException naming file and fault */
ACMAP_EXPORT YamlNode
loadYaml(const std::string& path);

/** \brief The same from memory.
 * \param[in] name stands for the file in messages */
ACMAP_EXPORT YamlNode
parseYaml(const std::string& name, const std::string& text);

} // namespace pcl::acmap
