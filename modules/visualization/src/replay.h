#pragma once

#include "flight.h"
#include "layer_stage.h"

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Flies the eye of a stage along the trajectory of its act. */
class Replay {
public:
  /** \param[in] stage lives as long */
  explicit Replay(LayerStage& stage)
  : stage_(stage)
  {}

  /** \brief Goes on where it stopped; behind the end from the start.
   * \throws BadArgumentException when no pose is finite */
  void
  start();

  void
  stop();

  /** \brief Forgets the way, as another act has another. */
  void
  leave();

  bool
  isRunning() const
  {
    return running_;
  }

  /** \brief Moves the eye on, and stops at the end. */
  void
  advance(double seconds);

  /** \brief Where the marker is, a line without its end; empty before the first start. */
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
