#pragma once

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Values of a measure over a setting; NaN where there is none. */
struct Curve {
  std::string name;
  std::vector<double> x, y;
};

/** \brief A diagram of curves in one pair of axes. */
struct CurvePanel {
  std::string y_title;
  std::vector<Curve> curves;
};

/** \brief Draws panels beside and below each other, two in a row, as PNG; needs an X
 * server.
 * \param[in] x_title of the setting, the same for all
 * \param[in] is_logarithmic the axis of the setting; its values are then positive
 * \throws std::runtime_error if the file cannot be written */
void
drawCurves(const std::string& path,
           const std::string& x_title,
           bool is_logarithmic,
           const std::vector<CurvePanel>& panels);

} // namespace pcl::acmap::bench
