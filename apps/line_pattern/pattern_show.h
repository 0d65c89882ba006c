#pragma once

#include "pattern_options.h"

#include <pcl/acquisition/pattern_window.h>

#include <optional>

namespace pcl::acmap {

/** \brief Shows patterns one after another where the user asked for it. */
class PatternShow {
public:
  /** \brief Opens the window, black; warns when patterns have to be scaled.
   * \throws BadArgumentException, IOException when there is no such monitor */
  PatternShow(Tool& tool,
              const PatternOptions& options,
              const RandomLinePattern& generator);

  /** \brief Shows a pattern for the time the user asked for.
   * \throws CancelledException when the user interrupted it */
  void
  show(const RgbImage& pattern);

  /** \brief A line of the summary and a part of the report. */
  void
  tell() const;

private:
  Tool& tool_;
  double hold_;
  std::optional<PatternWindow> window_;
};

} // namespace pcl::acmap
