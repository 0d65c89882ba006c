#pragma once

#include <pcl/core/export.h>
#include <pcl/exceptions.h>

namespace pcl {

/** \brief Thrown for a file that is missing, unreadable, truncated or malformed. The
 * message names the file and the fault. \ingroup core */
class ACMAP_EXPORT InputFileException : public IOException {
public:
  using IOException::IOException;
};

/** \brief Thrown for an input that is valid, but contains nothing of what is needed. The
 * message names the input and what it lacks. \ingroup core */
class ACMAP_EXPORT EmptyInputException : public PCLException {
public:
  using PCLException::PCLException;
};

/** \brief Thrown for a file that could not be written completely. An existing file of
 * that name is not changed. \ingroup core */
class ACMAP_EXPORT OutputFileException : public IOException {
public:
  using IOException::IOException;
};

/** \brief Thrown before an operation that would take more memory than allowed. The
 * message names both amounts. \ingroup core */
class ACMAP_EXPORT MemoryLimitException : public PCLException {
public:
  using PCLException::PCLException;
};

/** \brief Thrown by an operation whose progress callback requested cancellation. Its
 * outputs are not changed. \ingroup core */
class ACMAP_EXPORT CancelledException : public PCLException {
public:
  using PCLException::PCLException;
};

} // namespace pcl
