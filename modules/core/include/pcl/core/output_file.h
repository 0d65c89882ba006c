#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <cstdio>
#include <string>

namespace pcl::acmap {

/** \brief What a link points to, through all links; the path itself where it is none. A
 * link stays a link: what it points to is replaced. \ingroup core */
ACMAP_EXPORT std::string
followLinks(const std::string& path);

/** \brief A file that is written beside its target and renamed into place by
 * commit (): a killed run, an exception or a full disk leaves the old file or none.
 *
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

  /** \brief Flushes, closes and renames. Nothing can be written afterwards.
   * \throws OutputFileException when any of it failed */
  void
  commit();

private:
  std::string path_;
  std::string target_; // path_ with its links followed
  std::string temporary_;
  std::FILE* file_ = nullptr;
};

} // namespace pcl::acmap
