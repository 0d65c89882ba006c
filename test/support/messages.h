#pragma once

#include <exception>
#include <string>

namespace pcl::acmap::test {

/** \brief Message of the exception of a type that a function throws.
 * \param[in] nothing what is returned if it throws none */
template <typename Exception = std::exception, typename Work>
std::string
messageOf(const Work& work, const char* nothing = "")
{
  try {
    work();
  }
  catch (const Exception& exception) {
    return exception.what();
  }
  return nothing;
}

/** \brief Throws the error that ended the last stream of a grabber, if there was one. */
template <typename GrabberT>
void
rethrowError(const GrabberT& grabber)
{
  if (const std::exception_ptr error = grabber.getError())
    std::rethrow_exception(error);
}

/** \brief Message of the error that ended the last stream of a grabber; empty if there was
 * none. */
template <typename GrabberT>
std::string
errorOf(const GrabberT& grabber)
{
  return messageOf([&] { rethrowError(grabber); });
}

} // namespace pcl::acmap::test
