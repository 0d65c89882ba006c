#include "egomotion_runs.h"
#include "egomotion_tables.h"
#include "markdown_row.h"
#include "units.h"

#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t frames_a_file = 10;

void
printRun(const EgomotionRun& run, std::size_t step)
{
  constexpr double centi = 100;
  MarkdownRow()
      .count(frames_a_file * step)
      .text(run.name)
      .count(run.all.pairs)
      .count(run.failures)
      .count(run.wrong)
      .number(centi * run.estimated.translation_median, 2)
      .number(centi * run.estimated.translation_rms, 2)
      .number(run.estimated.rotation_median / degree, 3)
      .number(run.estimated.rotation_rms / degree, 3)
      .number(centi * run.all.translation_rms, 2)
      .number(run.all.rotation_rms / degree, 3)
      .number(run.chain.aligned, 3)
      .number(run.seconds, 3)
      .print();
}

} // namespace

void
printEgomotionKitchen()
{
  const auto kitchen = loadKitchen();
  if (!kitchen)
    return;
  const std::vector<EgomotionMethod> methods = {oursMethod(true),
                                                oursMethod(false),
                                                gicpMethod(0.5),
                                                gicpMethod(0.15, 10),
                                                ndtMethod(0.5),
                                                ndtMethod(1),
                                                orbMethod(),
                                                orbMethod({4000, 7, 0.9, 4})};
  printHead({"frames apart",
             "method",
             "pairs",
             "failures",
             "wrong",
             "translation, median, cm",
             "rms",
             "rotation, median, degrees",
             "rms",
             "failures as no motion: translation, rms, cm",
             "rotation, rms, degrees",
             "ATE of the chain, m",
             "CPU a pair, s"});
  for (const std::size_t step : {1, 2, 3, 10, 20, 30})
    for (const EgomotionMethod& method : methods)
      printRun(step == 1 ? runChain(method, *kitchen)
                         : runApart(method, *kitchen, step),
               step);
}

} // namespace pcl::acmap::bench
