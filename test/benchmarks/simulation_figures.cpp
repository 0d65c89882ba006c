#include "bench.h"
#include "light/rig_simulation.h"
#include "paper_patterns.h"
#include "picture_sheet.h"
#include "processes.h"
#include "random_streams.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/simulation/standard_scenes.h>

#include <functional>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t seed = 1;
constexpr double max_seconds = 1.0; // CPU, per observation

/** Shots as in the figures of the paper, scaled to a third. Above, Fig. 2, first row: the
 * reference image with the projector off, then under three patterns. Below, the left and
 * the top camera under the first pattern; and Fig. 3, left column: the reference image
 * with the projector off at two places of the corridor. */
void
saveShotPicture(const std::string& path, const RigSimulation& simulation)
{
  constexpr std::size_t place = 8, other_places[] = {21, 60}, off = 0;
  constexpr int columns = 4, smaller = 3;
  const auto reference =
      [&](const LitViews& views, std::size_t view, std::size_t shot) {
        return simulation.shoot(views, view, shot, seed)->image(RigCamera::Reference);
      };
  const LitViews here = simulation.cast(place);
  PictureSheet sheet(columns, 2, here[0].width, here[0].height, smaller);
  for (int column = 0; column < columns; ++column)
    sheet.put(column, 0, reference(here, place, static_cast<std::size_t>(column)));
  const auto lit = simulation.shoot(here, place, 1, seed);
  sheet.put(0, 1, lit->image(RigCamera::Horizontal));
  sheet.put(1, 1, lit->image(RigCamera::Vertical));
  int column = 2;
  for (const std::size_t other : other_places)
    sheet.put(column++, 1, reference(simulation.cast(other), other, off));
  sheet.save(path);
}

RigSimulation
simulationOf(const std::string& name)
{
  SimulatedScene scene = standardScene(name);
  RigRays cameras = raysOf(scene.rig);
  return RigSimulation(std::move(scene), drawPatterns(), {}, std::move(cameras));
}

void
printTimes(const std::string& name)
{
  constexpr std::size_t rounds = 5;
  const RigSimulation simulation = simulationOf(name);
  std::vector<double> cast, shade, noise, truth, all;
  withThreads(1, [&] {
    for (std::size_t i = 0; i < 4 * rounds; i += 4) {
      LitViews views;
      cast.push_back(measureThread([&] { views = simulation.cast(i); }));
      shade.push_back(measureThread([&] {
        for (std::size_t shot = 0; shot < simulation.shotsOfObservation(); ++shot)
          simulation.shoot(views, i, shot, seed);
      }));
      const TrinocularRig& rig = simulation.scene().rig;
      std::vector<float> row(3 * static_cast<std::size_t>(rig.width));
      const std::size_t rows = views.size() * static_cast<std::size_t>(rig.height) *
                               simulation.shotsOfObservation();
      noise.push_back(measureThread([&] {
        for (std::size_t k = 0; k < rows; ++k)
          fillNormal(k, row.data(), row.size());
      }));
      truth.push_back(measureThread([&] { truthOf(simulation.scene(), i); }));
      all.push_back(cast.back() + shade.back());
    }
  });
  Row() << name << figure(median(cast), 3) << figure(median(shade), 3)
        << figure(median(noise), 3) << atMost(median(all), max_seconds, 3)
        << figure(median(truth), 3);
}

const Section times("time", [] {
  printHead("scene | casting 3 views, s | 11 shots of them, s | of it noise, s | an "
            "observation, s | truth, s");
  for (const char* const name : {"corridor", "office"})
    printTimes(name);
});

/** Simulates every shot of the corridor without storing it. */
const Section session("session", [] {
  printHead("observations | frames | CPU, s | an observation, s | memory beside scene "
            "and patterns, MiB");
  SimulatedRigGrabber grabber(standardScene("corridor"), drawPatterns());
  std::size_t frames = 0;
  const std::function<TrinocularGrabber::FrameCallback> count =
      [&](const TrinocularFrame::ConstPtr&) { ++frames; };
  grabber.registerCallback(count);
  const PeakMemory memory;
  const double seconds = measureCost([&] {
                           grabber.start();
                           grabber.wait();
                         }).cpu;
  const std::size_t observations = grabber.getNumberOfObservations();
  constexpr double mebibyte = 1 << 20;
  Row() << observations << frames << figure(seconds, 1)
        << atMost(seconds / static_cast<double>(observations), max_seconds, 3)
        << figure(static_cast<double>(memory.bytes()) / mebibyte, 0);
});

const Section picture(
    "picture",
    [] {
      saveShotPicture("simulated_shots.png", simulationOf("corridor"));
      const RgbImage pattern = RandomLinePattern().generate(0);
      PictureSheet sheet(1, 1, pattern.width, pattern.height, 2);
      sheet.put(0, 0, {pattern.width, pattern.height, 3, pattern.values});
      sheet.save("line_pattern.png");
    },
    SectionUse::WhenNamed);

} // namespace
} // namespace pcl::acmap::bench
