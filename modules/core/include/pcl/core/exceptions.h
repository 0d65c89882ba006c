#pragma once

#include <pcl/core/export.h>
#include <pcl/exceptions.h>

namespace pcl {

/** \brief A file that is missing, unreadable, truncated or malformed; the message names
 * the file and what is wrong with it. \ingroup core */
class ACMAP_EXPORT InputFileException : public IOException {
public:
  using IOException::IOException;
};

/** \brief A file that could not be written whole; what stood there before is untouched.
 * \ingroup core */
class ACMAP_EXPORT OutputFileException : public IOException {
public:
  using IOException::IOException;
};

/** \brief Work that would take more memory than allowed, refused before it began; the
 * message names both amounts. \ingroup core */
class ACMAP_EXPORT MemoryLimitException : public PCLException {
public:
  using PCLException::PCLException;
};

/** \brief Thrown by a verb whose progress callback asked to stop; its outputs are
 * untouched. \ingroup core */
class ACMAP_EXPORT CancelledException : public PCLException {
public:
  using PCLException::PCLException;
};

} // namespace pcl
