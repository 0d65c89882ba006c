#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/hidden_folder.h>

#include <functional>
#include <list>
#include <string>

namespace pcl::acmap {

/** \brief Files of a run that appear together: each is written into a hidden folder
 * next to its target, and \ref commit renames them all. If a run fails before, existing
 * files are unchanged and no new ones appear.
 * \code
 * pcl::acmap::OutputGroup outputs;
 * outputs.write ("planes.json", [&] (const std::string& place) { pcl::saveMapFile (place, map); });
 * outputs.write ("mesh.ply", [&] (const std::string& place) { pcl::saveTriangleMesh (place, cloud, mesh); });
 * outputs.commit ();
 * \endcode
 * \ingroup core */
class ACMAP_EXPORT OutputGroup {
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
