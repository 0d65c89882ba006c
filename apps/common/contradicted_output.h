#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace pcl::acmap {

/** \brief A folder of results that is emptied if their own evidence contradicts them. */
class ContradictedOutput {
public:
  ContradictedOutput() = default;

  /** \brief Remembers what the folder holds before the run. */
  explicit ContradictedOutput(const std::string& folder);

  /** \brief Moves what the run has written to FOLDER.contradicted, in place of what an
   * earlier run has put there.
   * \return the new folder
   * \throws OutputFileException when it could not be moved, or when FOLDER.contradicted is
   * none that a run has made */
  std::string
  setAside() const;

private:
  std::string folder_;
  std::map<std::string, std::filesystem::file_time_type> before_; ///< entries
  bool was_there_ = false;
};

} // namespace pcl::acmap
