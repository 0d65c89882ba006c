#pragma once

#include <pcl/core/hidden_folder.h>

#include <functional>
#include <list>
#include <string>

namespace pcl::acmap {

/** \brief Files of a run that appear together: each is written into a hidden folder beside
 * its target, and \ref commit renames them all. A run that fails before leaves the old
 * files, or none. */
class OutputGroup {
public:
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
    explicit Entry(const std::string& path);

    std::string path;   ///< as the user named it
    std::string target; ///< with links followed
    HiddenFolder hidden;
    std::string place; ///< in there
  };

  std::list<Entry> entries_;
};

} // namespace pcl::acmap
