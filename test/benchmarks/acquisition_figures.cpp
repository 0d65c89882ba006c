#include "frame_ways.h"
#include "markdown_row.h"
#include "sections.h"
#include "session/session_folder.h"
#include "temporary_folder.h"
#include "timing.h"
#include "units.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <functional>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr char usage[] =
    "Usage: acmap_bench_acquisition_figures [patterns] [session] [disk]\n"
    "Prints, as Markdown tables, how line patterns come out, and "
    "what it takes to record\n"
    "frames of a simulated rig and to read them.\n";

void
printPatterns(const std::string& name,
              const std::function<void(RandomLinePattern&)>& change)
{
  constexpr std::uint32_t patterns = 1000;
  RandomLinePattern lines;
  change(lines);
  std::size_t redrawn = 0, none_good = 0;
  int max_redraws = 0;
  double coverage = 0;
  std::vector<double> seconds;
  for (std::uint32_t i = 0; i < patterns; ++i) {
    seconds.push_back(measureThread([&] { lines.generate(i); }));
    const RandomLinePatternReport& report = lines.getReport();
    redrawn += report.redraws > 0 ? 1 : 0;
    none_good += report.remarks.empty() ? 0 : 1;
    max_redraws = std::max(max_redraws, report.redraws);
    coverage += report.coverage / patterns;
  }
  MarkdownRow()
      .text(name)
      .count(redrawn)
      .count(static_cast<std::size_t>(max_redraws))
      .count(none_good)
      .number(coverage, 3)
      .number(milli * median(seconds), 1)
      .print();
}

/** The shots of two distant observations. */
std::vector<TrinocularFrame::Ptr>
film(const std::string& scene)
{
  constexpr std::uint32_t patterns = 10; // as in the paper
  RandomLinePattern lines;
  std::vector<RgbImage> images;
  for (std::uint32_t i = 0; i < patterns; ++i)
    images.push_back(lines.generate(i));
  const SimulatedRigGrabber grabber(standardScene(scene), images);
  std::vector<TrinocularFrame::Ptr> frames;
  for (const std::size_t observation : {4U, 11U})
    for (const TrinocularFrame::Ptr& frame : grabber.observe(observation))
      frames.push_back(frame);
  return frames;
}

/** Simulates a grey camera: one channel with its full noise. */
void
keepGreen(CameraImage& image)
{
  CameraImage green{image.width, image.height, 1, {}};
  for (std::size_t i = 1; i < image.values.size(); i += 3)
    green.values.push_back(image.values[i]);
  image = green;
}

/** Size and CPU seconds per frame of a method to store frames. */
struct WayFigures {
  std::string name;
  double bytes = 0;
  std::vector<double> writes;
  std::vector<double> reads;
};

void
measure(FrameWay& way,
        const std::vector<TrinocularFrame::Ptr>& frames,
        WayFigures& figures)
{
  figures.name = way.name();
  for (const TrinocularFrame::Ptr& frame : frames)
    figures.writes.push_back(measureThread([&] { way.write(*frame); }));
  way.finish();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::array<CameraImage, 3> images;
    figures.reads.push_back(measureThread([&] { images = way.read(i); }));
    if (!(images == frames[i]->images))
      throw std::runtime_error(way.name() + " reads other images than it wrote");
  }
  figures.bytes = static_cast<double>(way.bytes()) / static_cast<double>(frames.size());
}

std::vector<WayFigures>
measureWays(const std::vector<TrinocularFrame::Ptr>& frames)
{
  constexpr std::size_t rounds = 3;
  const CameraImage& image = frames.front()->image(RigCamera::Reference);
  TrinocularRig rig;
  rig.width = image.width;
  rig.height = image.height;
  std::vector<WayFigures> figures(3);
  for (std::size_t round = 0; round < rounds; ++round) {
    const test::TemporaryFolder folder;
    const auto ways = waysToKeepFrames(folder.path(""), rig);
    for (std::size_t i = 0; i < ways.size(); ++i)
      measure(*ways[i], frames, figures[i]);
  }
  return figures;
}

void
printWays(const std::string& name, const std::vector<TrinocularFrame::Ptr>& frames)
{
  constexpr double kibi = 1024;
  const std::vector<WayFigures> all = measureWays(frames);
  const double plain_write = median(all.front().writes);
  const double plain_read = median(all.front().reads);
  for (const WayFigures& way : all) {
    const double write = median(way.writes);
    const double read = median(way.reads);
    MarkdownRow()
        .text(name)
        .text(way.name)
        .number(way.bytes / kibi, 0)
        .number(way.bytes / all.front().bytes, 2)
        .number(milli * write, 1)
        .text(timesOf(write, plain_write))
        .number(milli * read, 1)
        .text(timesOf(read, plain_read))
        .print();
  }
}

/** Wall time of synchronizing each recorded frame to disk. */
void
printDisk(const std::string& name, const std::vector<TrinocularFrame::Ptr>& frames)
{
  constexpr std::size_t rounds = 5;
  constexpr double maximum = 0.9; // quantile over all frames
  std::vector<double> waits;
  for (std::size_t round = 0; round < rounds; ++round) {
    const test::TemporaryFolder folder;
    for (const TrinocularFrame::Ptr& frame : frames) {
      const std::string path = folder.path(std::to_string(frame->number) + ".acf");
      saveTrinocularFrame(path, *frame);
      waits.push_back(measureCost([&] { syncToDisk(path); }).wall);
    }
  }
  MarkdownRow()
      .text(name)
      .number(milli * median(waits), 1)
      .number(milli * quantile(waits, maximum), 1)
      .print();
}

template <typename Print>
void
printScene(const std::string& scene, const Print& print)
{
  const std::vector<TrinocularFrame::Ptr> frames = film(scene);
  print(scene + ", colour", frames);
  for (const TrinocularFrame::Ptr& frame : frames)
    for (CameraImage& image : frame->images)
      keepGreen(image);
  print(scene + ", grey", frames);
}

void
printAllPatterns()
{
  printHead({"1000 patterns",
             "drawn again",
             "redraws of one, at most",
             "none good",
             "coverage",
             "a pattern, ms"});
  constexpr double min_angle = 0.2618; // 15 degrees
  printPatterns("as they are", [](RandomLinePattern&) {});
  printPatterns("grey", [](RandomLinePattern& lines) { lines.setColored(false); });
  printPatterns("minimum angle 15°",
                [](RandomLinePattern& lines) { lines.setMinimumAngle(min_angle); });
  printPatterns("60 lines",
                [](RandomLinePattern& lines) { lines.setNumberOfLines(60); });
}

} // namespace
} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Sections sections;
  if (const auto exit_code =
          Sections::read(argc, argv, {"patterns", "session", "disk"}, usage, sections))
    return *exit_code;
  if (sections.isWanted("patterns"))
    printAllPatterns();
  if (sections.isWanted("session")) {
    printHead({"frames",
               "kept as",
               "KiB a frame",
               "of the values",
               "write, CPU ms",
               "of plain",
               "read, CPU ms",
               "of plain"});
    for (const char* const scene : {"corridor", "office"})
      printScene(scene, printWays);
  }
  if (sections.isWanted("disk")) {
    printHead({"frames", "waiting for the disk, ms", "nine in ten within, ms"});
    printScene("corridor", printDisk);
  }
  return 0;
}
