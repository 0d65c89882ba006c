#pragma once

#include <pcl/core/impl/hidden_folder.h>
#include <pcl/core/output_folder.h>

#include <functional>
#include <list>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Checks, before any work, that a result can be written to a path: its
 * extension is known, its folder exists and is writable, and it is not the path of an
 * input.
 * \param[in] path of the result
 * \param[in] endings legal extensions, with the dot, lower case
 * \param[in] others files of this run that the result must not replace
 * \throws OutputFileException when it cannot be written
 * \throws UsageError when it is one of the other files */
void
requireWritable(const std::string& path,
                const std::vector<std::string>& endings,
                const std::vector<std::string>& others);

/** \brief Refuses a folder that holds files with which new ones would mix.
 * \param[in] is_ours returns true for the name of such a file
 * \throws OutputFileException naming the first */
void
requireNoneIn(const OutputFolder& folder,
              const std::function<bool(const std::string& name)>& is_ours);

/** \brief Refuses a folder that holds parts of a sequence, with which new ones would
 * mix.
 * \param[in] more names that it must not hold either
 * \throws OutputFileException naming what it holds */
void
requireNoSequence(const OutputFolder& folder,
                  const std::vector<std::string>& more = {});

/** \brief Extension of a file name with its dot, in lower case; empty without one. */
std::string
endingOf(const std::string& path);

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
