#pragma once

#include "stage_log.h"

#include <functional>
#include <memory>

namespace pcl::acmap {

class DisplayConnection;

/** \brief The pictures of a run whose results are files: drawn with VTK in a process of
 * their own once the results are on the disk. An X server that is missing or goes away
 * ends the process that uses it, so it costs the pictures and a warning only. */
class PicturesApart {
public:
  /** \brief Connects to the X server if pictures are wanted, and warns if there is
   * none. */
  PicturesApart(bool are_wanted, StageLog& log);

  ~PicturesApart();

  /** \brief Can pictures be drawn? */
  bool
  canBeDrawn() const
  {
    return display_ != nullptr;
  }

  /** \brief Draws. Warns if that process fails before all is drawn.
   * \param[in] draw writes pictures; what it changes in memory is lost
   * \return false after a warning
   * \throws InterruptedPartway after an interruption
   * \throws OutputFileException of draw */
  bool
  draw(const std::function<void()>& draw, StageLog& log) const;

private:
  std::unique_ptr<DisplayConnection> display_;
};

} // namespace pcl::acmap
