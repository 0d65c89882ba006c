#pragma once

#include <functional>
#include <string>

struct _XDisplay; // Xlib's Display; its header defines macros such as None and Success

namespace pcl::acmap {

/** \brief A connection to an X server whose errors are exceptions; Xlib's own way is to
 * end the process. */
class XConnection {
public:
  /** \param[in] name of the display; empty: DISPLAY of the environment
   * \throws IOException when there is no such display */
  explicit XConnection(const std::string& name);

  /** \brief Closes it; the server frees what was made through it. */
  ~XConnection();

  XConnection(const XConnection&) = delete;
  XConnection&
  operator=(const XConnection&) = delete;

  _XDisplay*
  display() const
  {
    return display_;
  }

  /** \brief Makes requests and waits until the server has done them.
   * \param[in] doing what is being done, for the message
   * \throws IOException when the server refuses one or is gone */
  void
  call(const std::string& doing, const std::function<void()>& requests);

  /** \throws IOException naming the display, always */
  [[noreturn]] void
  fail(const std::string& reason) const;

private:
  std::string name_;
  _XDisplay* display_ = nullptr;
  bool is_lost_ = false;
};

} // namespace pcl::acmap
