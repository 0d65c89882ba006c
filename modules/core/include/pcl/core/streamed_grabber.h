#pragma once

#include <pcl/core/stream_thread.h>
#include <pcl/core/trinocular_grabber.h>

#include <string>

namespace pcl::acmap {

/** \brief Base of the grabbers whose shots are steps of a StreamThread: what does
 * not depend on the source of the frames. */
class ACMAP_EXPORT StreamedGrabber : public TrinocularGrabber {
public:
  ~StreamedGrabber() noexcept override;

  void
  stop() override;

  void
  wait() override;

  bool
  isRunning() const override;

  std::exception_ptr
  getError() const override;

  /** \brief The name of the class. */
  std::string
  getName() const override;

protected:
  explicit StreamedGrabber(std::string name);

private:
  /** \brief It ends with the grabber that owns it, before this base. */
  virtual StreamThread&
  stream() const = 0;

  const std::string name_;
};

} // namespace pcl::acmap
