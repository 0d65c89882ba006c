#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Files of a run that appear together: each is written to a hidden place beside
 * its target, and \ref commit renames them all. A run that fails before leaves the old
 * files, or none. */
class OutputGroup {
public:
  OutputGroup() = default;

  /** \brief Removes what was not committed. */
  ~OutputGroup();

  OutputGroup(const OutputGroup&) = delete;
  OutputGroup&
  operator=(const OutputGroup&) = delete;

  /** \brief Writes a file.
   * \param[in] path its target
   * \param[in] save writes to the place that it is given, whose ending is the target's
   * \throws OutputFileException of save, with the target for the place */
  void
  write(const std::string& path,
        const std::function<void(const std::string& place)>& save);

  /** \throws OutputFileException when a file could not be put into place */
  void
  commit();

private:
  struct Entry {
    std::string path;   ///< as the user named it
    std::string target; ///< with links followed
    std::string place;
  };

  std::vector<Entry> entries_;
};

} // namespace pcl::acmap
