#include "bench.h"
#include "egomotion_runs.h"
#include "rectification_runs.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <utility>

namespace pcl::acmap::bench {
namespace {

void
printRun(const EgomotionRun& run, const EgomotionSequence& sequence)
{
  const bool is_judged = run.name == "acmap";
  const double max_percent = is_judged ? 1 : no_reach;
  const double max_degrees = is_judged ? 0.15 : no_reach;
  Row() << sequence.name << run.name << run.all.pairs << run.failures << run.wrong
        << atMost(centi * run.estimated.translation_per_metre, max_percent, 2)
        << figure(centi * run.estimated.translation_per_metre_median, 2)
        << figure(run.estimated.rotation_median / degree, 3)
        << atMost(run.estimated.rotation_rms / degree, max_degrees, 3)
        << figure(run.estimated.rotation_worst / degree, 2)
        << figure(centi * run.all.translation_per_metre, 2)
        << figure(run.all.rotation_rms / degree, 3) << figure(run.chain.aligned, 3)
        << figure(run.seconds, 3);
}

const Section simulated_section("simulated", [] {
  const std::vector<EgomotionMethod> by_look = {
      oursMethod(true), oursMethod(false), orbMethod(), orbMethod({4000, 2, 0.9, 2})};
  const std::vector<EgomotionMethod> by_shape = {
      gicpMethod(0.5), gicpMethod(2), ndtMethod(0.5), ndtMethod(1)};
  printHead("session | method | pairs | failures | wrong | error a metre, % | median | "
            "heading a pair, degrees, median | rms | worst | failures as no motion: "
            "error a metre, % | heading, rms | ATE of the chain, m | CPU a pair, s");
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
});

constexpr std::size_t frames_a_file = 10;

void
printRun(const EgomotionRun& run, std::size_t step)
{
  Row() << frames_a_file * step << run.name << run.all.pairs << run.failures
        << run.wrong << figure(centi * run.estimated.translation_median, 2)
        << figure(centi * run.estimated.translation_rms, 2)
        << figure(run.estimated.rotation_median / degree, 3)
        << figure(run.estimated.rotation_rms / degree, 3)
        << figure(centi * run.all.translation_rms, 2)
        << figure(run.all.rotation_rms / degree, 3) << figure(run.chain.aligned, 3)
        << figure(run.seconds, 3);
}

const Section kitchen_section("kitchen", [] {
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
  printHead(
      "frames apart | method | pairs | failures | wrong | translation, median, cm | "
      "rms | rotation, median, degrees | rms | failures as no motion: translation, "
      "rms, cm | rotation, rms, degrees | ATE of the chain, m | CPU a pair, s");
  for (const std::size_t step : {1, 2, 3, 10, 20, 30})
    for (const EgomotionMethod& method : methods)
      printRun(step == 1 ? runChain(method, *kitchen)
                         : runApart(method, *kitchen, step),
               step);
});

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
  for (std::size_t stage = 0; stage < stages.size(); ++stage)
    stages[stage].second =
        median(valuesOf(runs, [&](const auto& run) { return run[stage].second; }));
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
  Row() << sequence << name << atMost(milli * seconds, reach, 1);
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

const Section time_section("time", [] {
  printHead("one pair of 640 × 480 pixels, loaded, one thread | method | CPU, ms");
  timePair(driveThrough("corridor_drive", {}, 2));
  if (const auto kitchen = loadKitchen())
    timePair(*kitchen);
});

RectificationMap
mapOf(const EgomotionSequence& sequence)
{
  RectificationMap map;
  map.name = sequence.name;
  for (std::size_t i = 0; i < sequence.clouds.size(); ++i) {
    const EgomotionCloud& seen = *sequence.clouds[i];
    map.addView({&seen.front().x, sizeof(PointXYZRGBSigma), seen.size()},
                SensorView(Eigen::Vector3f::Zero()),
                planarPartOf(sequence.truth[i]));
  }
  return map;
}

void
printRun(const EgomotionRun& chain, const RectificationRun& run)
{
  Row() << run.name << chain.name << chain.failures << figure(run.before.unaligned, 3)
        << figure(run.before.aligned, 3) << figure(run.after.unaligned, 3)
        << figure(run.after.aligned, 3) << nameOf(run.report.outcome)
        << figure(chain.seconds * static_cast<double>(chain.all.pairs), 1)
        << figure(run.seconds, 1);
}

const Section rectification_section("rectification", [] {
  printHead("session, 3D by our own stereo | egomotion | pairs without a motion | "
            "egomotion: ATE, m | aligned | rectified: ATE, m | aligned | outcome | "
            "egomotion, CPU s | rectification, CPU s");
  for (const char* scene : {"corridor_drive", "l_corridor_drive"}) {
    const EgomotionSequence sequence = driveThrough(scene);
    const RectificationMap map = mapOf(sequence);
    for (const bool refines : {true, false}) {
      const EgomotionRun chain = runChain(oursMethod(refines), sequence);
      printRun(chain, rectifyMap(map, planarPartsOf(chain.poses)));
    }
  }
});

} // namespace
} // namespace pcl::acmap::bench
