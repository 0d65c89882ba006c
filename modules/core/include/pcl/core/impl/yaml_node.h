#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A value of a YAML document together with its line: a scalar, a list or a map.
 * Every fault is an \ref InputFileException with file, line, column.
 *
 * Anchors, aliases and duplicate keys are rejected, so that the memory of a document is
 * bounded by its length. \ingroup core */
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

  /** \brief Returns the value of a key, or nullptr if it is missing.
   * \throws InputFileException when this is not a map */
  const YamlNode*
  find(const std::string& key) const;

  /** \throws InputFileException when this is not a map or the key is missing */
  const YamlNode&
  at(const std::string& key) const;

  /** \brief The keys of a map in their order, as nodes that contain their positions. */
  const std::vector<YamlNode>&
  keys() const;

  /** \throws InputFileException naming the first key that is not in the list */
  void
  requireKeys(const std::vector<std::string>& known) const;

  /** \param[in] minimum minimum length
   * \param[in] maximum maximum length
   * \throws InputFileException when this is not a list of such a length */
  const std::vector<YamlNode>&
  list(std::size_t minimum, std::size_t maximum) const;

  /** \throws InputFileException when this is not a scalar or is empty */
  const std::string&
  text() const;

  /** \brief Returns a finite number in [least, most]. */
  double
  number(double minimum, double maximum) const;

  /** \brief Returns an integer in [least, most]. */
  std::size_t
  count(std::size_t minimum, std::size_t maximum) const;

  /** \brief `true` or `false`. */
  bool
  boolean() const;

  /** \brief Reports a fault of this value.
   * \throws InputFileException "file: line 3, column 7: key: fault" */
  [[noreturn]] void
  fail(const std::string& fault) const;

private:
  friend class YamlTree;

  Kind kind_;
  std::shared_ptr<const std::string> file_;
  int line_;         // from 1
  int column_;       // from 1
  std::string name_; // key of this value, empty for other nodes
  std::string text_;
  std::vector<YamlNode> keys_;
  std::vector<YamlNode> values_; // of a list, or of the keys
};

/** \brief Reads a YAML document that is a map. A first line `%YAML:1.0`, as written by
 * OpenCV's FileStorage, is accepted. The maximum size is 16 MB.
 * \throws InputFileException naming file and fault */
ACMAP_EXPORT YamlNode
loadYaml(const std::string& path);

/** \brief Parses a YAML document in memory.
 * \param[in] name replaces the file name in messages
 * \param[in] text the document */
ACMAP_EXPORT YamlNode
parseYaml(const std::string& name, const std::string& text);

} // namespace pcl::acmap
