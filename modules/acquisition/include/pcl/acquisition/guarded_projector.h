#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/memory.h>

#include <mutex>
#include <utility>

namespace pcl {

/** \brief A projector that is used only while no other thread draws: Xlib is not
 * thread-safe, and a program may have windows beside a \ref PatternWindow.
 * \code
 * std::mutex drawing; // locked by whoever draws
 * const pcl::shared_ptr<pcl::PatternProjector> projector (
 *     new pcl::GuardedProjector (drawing, window));
 * \endcode
 * \ingroup acquisition */
class GuardedProjector : public PatternProjector {
public:
  /** \param[in] drawing outlives this object
   * \param[in] projector not null */
  GuardedProjector(std::mutex& drawing, shared_ptr<PatternProjector> projector)
  : drawing_(drawing)
  , projector_(std::move(projector))
  {}

  void
  show(const RgbImage& image) override
  {
    const std::lock_guard lock(drawing_);
    projector_->show(image);
  }

  void
  showNothing() override
  {
    const std::lock_guard lock(drawing_);
    projector_->showNothing();
  }

private:
  std::mutex& drawing_;
  shared_ptr<PatternProjector> projector_;
};

} // namespace pcl
