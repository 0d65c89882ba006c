#include "egomotion_runs.h"
#include "egomotion_tables.h"
#include "markdown_row.h"
#include "units.h"

#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

void
printRun(const EgomotionRun& run, const EgomotionSequence& sequence)
{
  constexpr double percent = 100;
  const bool is_judged = run.name == "acmap";
  const double max_percent = is_judged ? 1 : no_reach;
  const double max_degrees = is_judged ? 0.15 : no_reach;
  MarkdownRow()
      .text(sequence.name)
      .text(run.name)
      .count(run.all.pairs)
      .count(run.failures)
      .count(run.wrong)
      .atMost(percent * run.estimated.translation_per_metre, max_percent, 2)
      .number(percent * run.estimated.translation_per_metre_median, 2)
      .number(run.estimated.rotation_median / degree, 3)
      .atMost(run.estimated.rotation_rms / degree, max_degrees, 3)
      .number(run.estimated.rotation_worst / degree, 2)
      .number(percent * run.all.translation_per_metre, 2)
      .number(run.all.rotation_rms / degree, 3)
      .number(run.chain.aligned, 3)
      .number(run.seconds, 3)
      .print();
}

} // namespace

void
printEgomotionSimulated()
{
  const std::vector<EgomotionMethod> by_look = {
      oursMethod(true), oursMethod(false), orbMethod(), orbMethod({4000, 2, 0.9, 2})};
  const std::vector<EgomotionMethod> by_shape = {
      gicpMethod(0.5), gicpMethod(2), ndtMethod(0.5), ndtMethod(1)};
  printHead({"session",
             "method",
             "pairs",
             "failures",
             "wrong",
             "error a metre, %",
             "median",
             "heading a pair, degrees, median",
             "rms",
             "worst",
             "failures as no motion: error a metre, %",
             "heading, rms",
             "ATE of the chain, m",
             "CPU a pair, s"});
  for (const char* scene : {"corridor_drive", "l_corridor_drive"})
    for (const double grain : {2.0, 6.0, 12.0}) {
      const EgomotionSequence sequence = driveThrough(scene, grain);
      for (const EgomotionMethod& method : by_look)
        printRun(runChain(method, sequence), sequence);
      if (grain > 2) // the shape is the same for all
        continue;
      for (const EgomotionMethod& method : by_shape)
        printRun(runChain(method, sequence), sequence);
    }
}

} // namespace pcl::acmap::bench
