#pragma once

#include "layer_stage.h"

#include <vtkProp.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Distances between what is picked in a window, by the rules of the page: between
 * two points, which snap to corners and edges of planes, or between two planes that are
 * parallel. */
class Measuring {
public:
  enum class Between { Nothing, Points, Planes };

  /** \param[in] stage, map must outlive this object */
  Measuring(LayerStage& stage, const CompactMap& map);

  /** \brief Nothing, points, planes, and nothing again. */
  void
  measureNext();

  Between
  between() const
  {
    return between_;
  }

  /** \param[in] column, row pixel, counted from the lower left */
  void
  pick(double column, double row);

  /** \brief What to do next, or the distance; empty while nothing is measured. */
  std::string
  told() const;

private:
  void
  clear();

  void
  finish();

  void
  draw(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::string& text);

  LayerStage& stage_;
  const CompactMap& map_;
  Between between_ = Between::Nothing;
  std::vector<PickedPlace> picks_;
  std::string result_;
  std::vector<vtkSmartPointer<vtkProp>> drawn_;
};

} // namespace pcl::acmap
