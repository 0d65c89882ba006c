#include "light/rig_simulation.h"
#include "markdown_row.h"
#include "peak_memory.h"
#include "random_streams.h"
#include "sections.h"
#include "shot_picture.h"
#include "timing.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/simulation/standard_scenes.h>

#include <functional>

namespace pcl::acmap::bench {
namespace {

constexpr char usage[] =
    "Usage: acmap_bench_simulation_figures [time] [picture]\n"
    "Prints what simulated shots take, as a Markdown table, and writes pictures of "
    "some\n"
    "of them and of a pattern, simulated_shots.png and line_pattern.png.\n";

constexpr std::uint32_t patterns = 10; // as in the paper
constexpr std::uint64_t seed = 1;
constexpr double max_seconds = 1.0; // CPU, per observation

std::vector<RgbImage>
drawPatterns()
{
  RandomLinePattern lines;
  std::vector<RgbImage> images;
  for (std::uint32_t i = 0; i < patterns; ++i)
    images.push_back(lines.generate(i));
  return images;
}

RigSimulation
simulationOf(const std::string& name)
{
  SimulatedScene scene = standardScene(name);
  RigRays cameras = raysOf(scene.rig);
  return RigSimulation(std::move(scene), drawPatterns(), {}, std::move(cameras));
}

/** CPU seconds of an observation on one thread. */
struct ShotCosts {
  double cast, shade, noise, truth;
};

ShotCosts
measure(const RigSimulation& simulation, std::size_t observation)
{
  ShotCosts costs{};
  LitViews views;
  costs.cast = measureThread([&] { views = simulation.cast(observation); });
  costs.shade = measureThread([&] {
    for (std::size_t shot = 0; shot < simulation.shotsOfObservation(); ++shot)
      simulation.shoot(views, observation, shot, seed);
  });
  const TrinocularRig& rig = simulation.scene().rig;
  std::vector<float> row(3 * static_cast<std::size_t>(rig.width));
  const std::size_t rows = views.size() * static_cast<std::size_t>(rig.height) *
                           simulation.shotsOfObservation();
  costs.noise = measureThread([&] {
    for (std::size_t i = 0; i < rows; ++i)
      fillNormal(i, row.data(), row.size());
  });
  costs.truth = measureThread([&] { truthOf(simulation.scene(), observation); });
  return costs;
}

void
printTimes(const std::string& name)
{
  constexpr std::size_t rounds = 5;
  const RigSimulation simulation = simulationOf(name);
  std::vector<double> cast, shade, noise, truth, all;
  withThreads(1, [&] {
    for (std::size_t i = 0; i < rounds; ++i) {
      const ShotCosts costs = measure(simulation, 4 * i);
      cast.push_back(costs.cast);
      shade.push_back(costs.shade);
      noise.push_back(costs.noise);
      truth.push_back(costs.truth);
      all.push_back(costs.cast + costs.shade);
    }
  });
  MarkdownRow()
      .text(name)
      .number(median(cast), 3)
      .number(median(shade), 3)
      .number(median(noise), 3)
      .atMost(median(all), max_seconds, 3)
      .number(median(truth), 3)
      .print();
}

/** Simulates every shot of the corridor without storing it. */
void
printSession()
{
  SimulatedRigGrabber grabber(standardScene("corridor"), drawPatterns());
  std::size_t frames = 0;
  const std::function<TrinocularGrabber::FrameCallback> count =
      [&](const TrinocularFrame::ConstPtr&) { ++frames; };
  grabber.registerCallback(count);
  const PeakMemory memory;
  const double begin = processSeconds();
  grabber.start();
  grabber.wait();
  const double seconds = processSeconds() - begin;
  const std::size_t observations = grabber.getNumberOfObservations();
  constexpr double mebibyte = 1 << 20;
  MarkdownRow()
      .count(observations)
      .count(frames)
      .number(seconds, 1)
      .atMost(seconds / static_cast<double>(observations), max_seconds, 3)
      .number(static_cast<double>(memory.bytes()) / mebibyte, 0)
      .print();
}

} // namespace
} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Sections sections;
  if (const auto exit_code =
          Sections::read(argc, argv, {"time", "session", "picture"}, usage, sections))
    return *exit_code;
  if (sections.isWanted("time")) {
    printHead({"scene",
               "casting 3 views, s",
               "11 shots of them, s",
               "of it noise, s",
               "an observation, s",
               "truth, s"});
    for (const char* const name : {"corridor", "office"})
      printTimes(name);
  }
  if (sections.isWanted("session")) {
    printHead({"observations",
               "frames",
               "CPU, s",
               "an observation, s",
               "memory beside scene and patterns, MiB"});
    printSession();
  }
  if (sections.isWanted("picture")) {
    saveShotPicture("simulated_shots.png", simulationOf("corridor"));
    savePatternPicture("line_pattern.png", pcl::RandomLinePattern().generate(0));
  }
  return 0;
}
