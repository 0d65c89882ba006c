#include "disparity_errors.h"
#include "markdown_row.h"
#include "paper_patterns.h"
#include "stereo_tables.h"

#include <pcl/acquisition/pattern_selection.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/disparity_fusion.h>

#include <algorithm>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t views_of_scene = 3, all_patterns = 10;

/** Observations of some views, as patterns and errors. */
struct PatternFigures {
  DisparityErrors errors;
  std::size_t patterns = 0;
};

/** Lit pixels that a neighbour sees, within the search range. */
PixelMask
matchablePixels(const SimulatedTruth& truth)
{
  constexpr int neighbours =
      SimulatedTruth::in_horizontal | SimulatedTruth::in_vertical;
  constexpr float last = 63.0F; // px
  PixelMask mask = pixelsWithTruth(truth.horizontal);
  for (std::size_t i = 0; i < mask.size(); ++i)
    if ((truth.visible[i] & neighbours) == 0 ||
        (truth.visible[i] & SimulatedTruth::in_light) == 0 ||
        !(truth.horizontal.values[i] <= last))
      mask[i] = 0;
  return mask;
}

/** Matches the shots until the fusion wants no more, or the given number is reached. */
void
observeView(const SimulatedRigGrabber& grabber,
            std::size_t view,
            std::size_t patterns,
            bool early,
            const SimulatedTruth& truth,
            PatternFigures& figures)
{
  DisparityFusion fusion;
  fusion.setInputRig(grabber.getRig());
  std::size_t shown = 0;
  for (const TrinocularFrame::Ptr& frame : grabber.observe(view)) {
    fusion.addShot(frame);
    shown += frame->pattern != TrinocularFrame::no_pattern;
    if (shown == patterns || (early && shown > 0 && !fusion.wantsAnotherShot()))
      break;
  }
  MatchedDisparity fused;
  fusion.fuse(fused);
  figures.errors.add(fused.disparity, truth.horizontal, matchablePixels(truth));
  figures.patterns += shown;
}

/** Views of a scene under one sequence of patterns. */
class PatternViews {
public:
  PatternViews(const SimulatedScene& scene, const std::vector<RgbImage>& patterns)
  : grabber_(scene, patterns)
  {
    const std::size_t count = std::min(views_of_scene, scene.views.size());
    for (std::size_t i = 0; i < count; ++i) {
      views_.push_back(i * scene.views.size() / count);
      truths_.push_back(truthOf(scene, views_.back()));
    }
  }

  PatternFigures
  observe(std::size_t patterns, bool early) const
  {
    PatternFigures figures;
    for (std::size_t i = 0; i < views_.size(); ++i)
      observeView(grabber_, views_[i], patterns, early, truths_[i], figures);
    return figures;
  }

  /** The fewest patterns that leave no more pixels bad. */
  PatternFigures
  observeUntil(double bad) const
  {
    std::size_t patterns = 3;
    PatternFigures figures = observe(patterns, false);
    while (figures.errors.bad() > bad && patterns < all_patterns)
      figures = observe(++patterns, false);
    return figures;
  }

  double
  perObservation(const PatternFigures& figures) const
  {
    return static_cast<double>(figures.patterns) / static_cast<double>(views_.size());
  }

private:
  SimulatedRigGrabber grabber_;
  std::vector<std::size_t> views_;
  std::vector<SimulatedTruth> truths_;
};

void
printPatternScene(const std::string& name, const std::string& use)
{
  const SimulatedScene scene = standardScene(name);
  RandomLinePattern lines;
  const PatternViews random(scene, drawPatterns());
  const PatternViews selected(scene,
                              PatternSelection().selectFrom(lines, all_patterns));
  const auto print = [&](const std::string& way, const PatternFigures& figures) {
    MarkdownRow()
        .text(name + use)
        .text(way)
        .number(random.perObservation(figures), 1)
        .number(figures.errors.bad(), 3)
        .number(figures.errors.wrong(), 3)
        .number(figures.errors.medianError(), 4)
        .print();
  };
  const PatternFigures ten = random.observe(all_patterns, false);
  print("ten random", ten);
  print("random, early stop", random.observe(all_patterns, true));
  print("selected, early stop", selected.observe(all_patterns, true));
  print("selected, as few as leave no more bad",
        selected.observeUntil(ten.errors.bad()));
}

} // namespace

void
printPatternNumbers()
{
  printHead({"scene",
             "patterns",
             "per observation",
             "bad > 1 px or missing, %",
             "of it wrong, %",
             "median error, px"});
  printPatternScene("corridor", " (tuned)");
  for (const char* scene : {"office", "room"})
    printPatternScene(scene, "");
}

} // namespace pcl::acmap::bench
