#pragma once

#include <pcl/acquisition/pattern_window.h>

#include <functional>
#include <string>

struct _XDisplay; // Xlib's Display; its header defines macros such as None and Success

namespace pcl::acmap {

/** \brief A connection to an X server that reports errors as exceptions, where Xlib
 * would end the process. */
class XConnection {
public:
  /** \param[in] name of the display; if empty, the environment variable DISPLAY is used
   * \throws IOException when there is no such display */
  explicit XConnection(const std::string& name);

  /** \brief Closes the connection; the server frees the resources of the connection. */
  ~XConnection();

  XConnection(const XConnection&) = delete;
  XConnection&
  operator=(const XConnection&) = delete;

  _XDisplay*
  display() const
  {
    return display_;
  }

  /** \brief Sends requests and waits until the server has processed them.
   * \param[in] doing description of the action, for the message
   * \param[in] requests function that calls Xlib
   * \throws IOException when the server rejects a request or is not available any
   * more */
  void
  call(const std::string& doing, const std::function<void()>& requests);

  /** \brief Always throws. \throws IOException naming the display */
  [[noreturn]] void
  fail(const std::string& reason) const;

private:
  std::string name_;
  _XDisplay* display_ = nullptr;
  bool is_lost_ = false;
};

/** \brief The active monitors in the server's order; if the server cannot list them,
 * the whole screen as one monitor. \throws IOException when the display fails */
std::vector<MonitorPlace>
findMonitors(XConnection& connection);

/** \throws BadArgumentException when there is no such monitor */
MonitorPlace
chooseMonitor(XConnection& connection, std::size_t index);

} // namespace pcl::acmap
