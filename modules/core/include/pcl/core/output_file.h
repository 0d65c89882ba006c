#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/hidden_folder.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Resolves symbolic links; returns the path itself if it is not a link. The
 * link is kept and its target is replaced. \ingroup core */
ACMAP_EXPORT std::string
followLinks(const std::string& path);

/** \brief A file that has no name until commit () puts it into place. After a killed
 * process, an exception or a full disk, there is either the old file or none.
 *
 * If the file system does not support unnamed files, the file is written into a
 * HiddenFolder in the folder of its target, which is removed by the next process
 * if this one is killed. If the target is a symbolic link, the link is kept and the
 * file that it points to is replaced; its permissions are kept. Devices and pipes are
 * written to directly. \ingroup core */
class ACMAP_EXPORT OutputFile {
public:
  /** \throws OutputFileException when the file cannot be created */
  explicit OutputFile(const std::string& path);

  /** \brief Removes the written data unless it was committed. */
  ~OutputFile();

  OutputFile(const OutputFile&) = delete;
  OutputFile&
  operator=(const OutputFile&) = delete;

  /** \throws OutputFileException when the bytes could not be written */
  void
  write(const void* data, std::size_t bytes);

  /** \brief Flushes and closes the file and puts it into place. Nothing can be written
   * afterwards.
   * \throws OutputFileException when one of these steps failed */
  void
  commit();

private:
  /** \brief Opens an unnamed file, or one in a hidden folder. */
  void
  openBeside();

  /** \brief Creates the hidden folder. */
  void
  hide();

  std::string path_;
  std::string target_; // target with links resolved
  int unnamed_ = -1;   // descriptor of the file while it has no name
  std::optional<HiddenFolder> hidden_;
  std::string temporary_; // path of the file in the hidden folder
  std::FILE* file_ = nullptr;
};

} // namespace pcl::acmap
