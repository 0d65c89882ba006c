#pragma once

#include "flight.h"
#include "layer_stage.h"

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Moves the camera of a stage along the trajectory of its current act. */
class Replay {
public:
  /** \param[in] stage must outlive this object */
  explicit Replay(LayerStage& stage)
  : stage_(stage)
  {}

  /** \brief Continues where the flight was stopped, or restarts it after its end.
   * \throws BadArgumentException when no pose is finite */
  void
  start();

  void
  stop();

  /** \brief Discards the flight, because another act has another trajectory. */
  void
  leave();

  bool
  isRunning() const
  {
    return running_;
  }

  /** \brief Moves the camera, and stops at the end. */
  void
  advance(double seconds);

  /** \brief Current pose as one line without line break; empty before the first
   * start. */
  std::string
  describe() const;

private:
  LayerStage& stage_;
  std::optional<Flight> flight_;
  double time_ = 0;
  bool running_ = false;
  vtkSmartPointer<vtkActor> marker_;
};

} // namespace pcl::acmap
