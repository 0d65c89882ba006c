#include "egomotion_methods.h"
#include "egomotion_tables.h"
#include "markdown_row.h"
#include "timing.h"
#include "units.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <iostream>
#include <utility>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t rounds = 5;

/** CPU seconds of each stage of one motion, on one thread, in order of execution. */
using StageTimes = std::vector<std::pair<std::string, double>>;

/** Uses the progress reports of the stages. \param[in] keeps was the target seen
 * before? */
StageTimes
timeStages(const EgomotionSequence& sequence, bool keeps)
{
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  egomotion.setNumberOfThreads(1);
  egomotion.setMotionModel(sequence.is_planar ? MotionModel::Planar
                                              : MotionModel::Rigid);
  egomotion.setInputSource(sequence.clouds[0]);
  egomotion.setInputTarget(sequence.clouds[0]);
  if (keeps)
    egomotion.compute();
  egomotion.setInputSource(sequence.clouds[1]);
  StageTimes stages;
  double begin = threadSeconds();
  const auto finish = [&](const std::string& stage) {
    const double now = threadSeconds();
    stages.emplace_back(stage, now - begin);
    begin = now;
  };
  const std::vector<std::string> names = {
      "look at the view before", "look at the view now", "match", "fit"};
  egomotion.setProgressCallback([&](double, const std::string&) {
    if (stages.size() < names.size())
      finish(names[stages.size()]);
    return true;
  });
  egomotion.compute();
  finish("refine");
  return stages;
}

StageTimes
medianStages(const std::vector<StageTimes>& runs)
{
  StageTimes stages = runs.front();
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    std::vector<double> seconds;
    for (const StageTimes& run : runs)
      seconds.push_back(run[stage].second);
    stages[stage].second = median(seconds);
  }
  return stages;
}

double
sumOf(const StageTimes& stages)
{
  double seconds = 0;
  for (const auto& [name, part] : stages)
    seconds += part;
  return seconds;
}

void
printTime(const std::string& sequence,
          const std::string& name,
          double seconds,
          double reach = no_reach)
{
  MarkdownRow().text(sequence).text(name).atMost(milli * seconds, reach, 1).print();
}

void
timePair(const EgomotionSequence& sequence)
{
  constexpr double maximum = 120; // ms
  const std::vector<EgomotionMethod> peers = {gicpMethod(0.5),
                                              ndtMethod(1),
                                              ndtMethod(0.5),
                                              orbMethod(),
                                              orbMethod({4000, 2, 0.9, 2})};
  std::vector<StageTimes> first, next;
  std::vector<double> whole;
  std::vector<std::vector<double>> others(peers.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    first.push_back(timeStages(sequence, false));
    next.push_back(timeStages(sequence, true));
    whole.push_back(sumOf(first.back()));
    for (std::size_t i = 0; i < peers.size(); ++i)
      others[i].push_back(measureCost([&] { peers[i].motion(sequence, 1, 0); }).cpu);
  }
  printTime(sequence.name, "acmap, both views", median(whole), maximum);
  for (const auto& [name, seconds] : medianStages(first))
    printTime("", name, seconds);
  printTime(sequence.name, "acmap, the view before is kept", sumOf(medianStages(next)));
  for (std::size_t i = 0; i < peers.size(); ++i)
    printTime(sequence.name, peers[i].name, median(others[i]));
}

} // namespace

void
printEgomotionTimes()
{
  printHead({"one pair of 640 × 480 pixels, loaded, one thread", "method", "CPU, ms"});
  timePair(driveThrough("corridor_drive", {}, 2));
  if (const auto kitchen = loadKitchen())
    timePair(*kitchen);
}

} // namespace pcl::acmap::bench
