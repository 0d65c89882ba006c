#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Colours and links on a terminal; plain text elsewhere, and without colours where the variable
 * NO_COLOR is set. */
class TerminalStyle {
public:
  /** \param[in] file_descriptor that is written to */
  explicit TerminalStyle(int file_descriptor);

  /** \brief The name of a line. */
  std::string
  name(const std::string& text) const;

  std::string
  warning(const std::string& text) const;

  /** \brief A path that opens with a click, where the terminal is known to have links. */
  std::string
  link(const std::string& path) const;

private:
  bool has_colour_ = false, has_links_ = false;
};

} // namespace pcl::acmap
