#pragma once

#include <pcl/core/hidden_folder.h>

#include <functional>
#include <list>
#include <string>

namespace pcl::acmap {

/** \brief Files of a run that appear together: each is written into a hidden folder
 * next to its target, and \ref commit renames them all. If a run fails before, existing
 * files are unchanged and no new ones appear. */
class OutputGroup {
public:
  /** \brief Writes a file.
   * \param[in] path its target
   * \param[in] save writes to the given path, which has the extension of the target
   * \throws OutputFileException of save, with the path replaced by the target */
  void
  write(const std::string& path,
        const std::function<void(const std::string& place)>& save);

  /** \throws OutputFileException when a file could not be renamed */
  void
  commit();

private:
  struct Entry {
    explicit Entry(const std::string& path);

    std::string path;   ///< as given by the user
    std::string target; ///< with symbolic links resolved
    HiddenFolder hidden;
    std::string place; ///< path in the hidden folder
  };

  std::list<Entry> entries_;
};

} // namespace pcl::acmap
