#pragma once

#include <pcl/core/export.h>
#include <pcl/exceptions.h>

#include <memory>
#include <sstream>
#include <string>

namespace pcl {

namespace acmap {

/** \brief An exception of PCL whose what () is the message alone: what PCL makes of it begins
 * with ": ", and with a signature and the path of a source where its macro throws it. It is
 * caught as what it is made of. \ingroup core */
template <typename Base>
class ACMAP_EXPORT Plain : public Base {
public:
  /** \param[in] first,rest the message, as they are written to a stream */
  template <typename First, typename... Rest>
  explicit Plain(const First& first, const Rest&... rest)
  : Plain(std::make_shared<const std::string>(joined(first, rest...)))
  {}

  const char*
  what() const noexcept override
  {
    return message_->c_str();
  }

private:
  explicit Plain(std::shared_ptr<const std::string> message)
  : Base(*message)
  , message_(std::move(message))
  {}

  template <typename... Parts>
  static std::string
  joined(const Parts&... parts)
  {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
  }

  std::shared_ptr<const std::string> message_; ///< a copy of the exception cannot throw
};

using BadArgument = Plain<BadArgumentException>;
using InitFailed = Plain<InitFailedException>;
using Unorganized = Plain<UnorganizedPointCloudException>;
using IoFault = Plain<IOException>;

} // namespace acmap

/** \brief Thrown for a file that is missing, unreadable, truncated or malformed. The
 * message names the file and the fault. \ingroup core */
class ACMAP_EXPORT InputFileException : public acmap::Plain<IOException> {
public:
  using Plain::Plain;
};

/** \brief Thrown for an input that is valid, but contains nothing of what is needed. The
 * message names the input and what it lacks. \ingroup core */
class ACMAP_EXPORT EmptyInputException : public acmap::Plain<PCLException> {
public:
  using Plain::Plain;
};

/** \brief Thrown for a file that could not be written completely. An existing file of
 * that name is not changed. \ingroup core */
class ACMAP_EXPORT OutputFileException : public acmap::Plain<IOException> {
public:
  using Plain::Plain;
};

/** \brief Thrown before an operation that would take more memory than allowed. The
 * message names both amounts. \ingroup core */
class ACMAP_EXPORT MemoryLimitException : public acmap::Plain<PCLException> {
public:
  using Plain::Plain;
};

/** \brief Thrown by an operation whose progress callback requested cancellation. Its
 * outputs are not changed. \ingroup core */
class ACMAP_EXPORT CancelledException : public acmap::Plain<PCLException> {
public:
  using Plain::Plain;
};

} // namespace pcl
