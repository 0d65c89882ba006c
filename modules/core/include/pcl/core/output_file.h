#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/hidden_folder.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What a link points to, through all links; the path itself where it is none. A
 * link stays a link: what it points to is replaced. \ingroup core */
ACMAP_EXPORT std::string
followLinks(const std::string& path);

/** \brief A file that has no name until commit () puts it into place: a killed run, an
 * exception or a full disk leaves the old file or none.
 *
 * Where the file system knows no files without a name, it is written into a
 * \ref HiddenFolder beside its target, which a killed run leaves for the next one.
 * A target that is a link keeps being one: the file that it points to is replaced, with
 * its permissions kept. A device or a pipe is written straight into. \ingroup core */
class ACMAP_EXPORT OutputFile {
public:
  /** \throws OutputFileException when the file cannot be created */
  explicit OutputFile(const std::string& path);

  /** \brief Removes what was written unless it was committed. */
  ~OutputFile();

  OutputFile(const OutputFile&) = delete;
  OutputFile&
  operator=(const OutputFile&) = delete;

  /** \throws OutputFileException when the bytes could not be written */
  void
  write(const void* data, std::size_t bytes);

  /** \brief Flushes, closes and puts it into place. Nothing can be written afterwards.
   * \throws OutputFileException when any of it failed */
  void
  commit();

private:
  /** \brief Opens a file without a name, or one in a hidden folder. */
  void
  openBeside();

  /** \brief Makes the hidden folder. */
  void
  hide();

  std::string path_;
  std::string target_; // with links followed
  int unnamed_ = -1;   // the file, where it has no name yet
  std::optional<HiddenFolder> hidden_;
  std::string temporary_; // its place in there
  std::FILE* file_ = nullptr;
};

} // namespace pcl::acmap
