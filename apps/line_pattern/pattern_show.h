#pragma once

#include "pattern_options.h"

#include <pcl/acquisition/pattern_window.h>

#include <optional>

namespace pcl::acmap {

/** \brief Shows patterns one after another, if the user requested it. */
class PatternShow {
public:
  /** \brief Opens a black window; warns when patterns have to be scaled.
   * \throws BadArgumentException, IOException when there is no such monitor */
  PatternShow(Tool& tool,
              const PatternOptions& options,
              const RandomLinePattern& generator);

  /** \brief Shows a pattern for the time that the user set.
   * \throws CancelledException when the user interrupted it */
  void
  show(const RgbImage& pattern);

  /** \brief Adds a line to the summary and a part to the report. */
  void
  tell() const;

private:
  Tool& tool_;
  double hold_;
  std::optional<PatternWindow> window_;
};

} // namespace pcl::acmap
