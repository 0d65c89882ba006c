#include "bench.h"
#include "paper_patterns.h"
#include "session/session_folder.h"
#include "temporary_folder.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/image_file.h>
#include <pcl/core/output_file.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

using Images = std::array<CameraImage, 3>;
using Frames = std::vector<TrinocularFrame::Ptr>;
using Bytes = std::vector<std::uint8_t>;

/** A method to store frames. */
struct FrameWay {
  std::string name, folder;
  std::function<void(const TrinocularFrame&)> write;
  std::function<void()> finish; ///< called after all frames have been written
  std::function<Images(std::size_t number)> read; ///< in the order of writing
};

FrameWay
sessionWay(const std::string& folder, const TrinocularRig& rig)
{
  const auto recorder = std::make_shared<TrinocularRecorder>(folder, rig);
  const auto grabber = std::make_shared<std::unique_ptr<TrinocularFileGrabber>>();
  return {"session",
          folder,
          [=](const TrinocularFrame& frame) { recorder->record(frame); },
          [=] {
            recorder->finish();
            *grabber = std::make_unique<TrinocularFileGrabber>(folder);
          },
          [=](std::size_t i) { return std::move((*grabber)->frame(i)->images); }};
}

/** Stores the image of each camera in a file.
 * \param[in] load reads the values of an image, which has the correct size */
FrameWay
imageWay(const std::string& name,
         const std::string& folder,
         const std::function<Bytes(const CameraImage&)>& encode,
         const std::function<Bytes(const std::string&, const CameraImage&)>& load)
{
  std::filesystem::create_directory(folder);
  const auto shape = std::make_shared<Images>();
  const auto pathOf = [=](std::uint64_t frame, std::size_t camera) {
    return folder + "/" + std::to_string(frame) + "_" + std::to_string(camera);
  };
  const auto frames = std::make_shared<std::uint64_t>(0);
  return {name,
          folder,
          [=](const TrinocularFrame& frame) {
            for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
              OutputFile file(pathOf(*frames, camera));
              const Bytes bytes = encode(frame.images[camera]);
              file.write(bytes.data(), bytes.size());
              file.commit();
            }
            *shape = frame.images;
            for (CameraImage& image : *shape)
              image.values.clear();
            ++*frames;
          },
          [] {},
          [=](std::size_t i) {
            Images images = *shape;
            for (std::size_t camera = 0; camera < images.size(); ++camera)
              images[camera].values = load(pathOf(i, camera), images[camera]);
            return images;
          }};
}

Bytes
loadPlain(const std::string& path, const CameraImage& image)
{
  Bytes values(static_cast<std::size_t>(image.channels * image.width * image.height));
  std::ifstream(path, std::ios::binary)
      .read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size()));
  return values;
}

Bytes
encodeAsPng(const CameraImage& image)
{
  return image.channels == 1
             ? encodePng(image.width, image.height, image.values)
             : encodePng(RgbImage{image.width, image.height, image.values});
}

Bytes
loadFromPng(const std::string& path, const CameraImage& image)
{
  if (image.channels == 3)
    return loadRgbImage(path).values;
  const GrayImage16 gray = loadGrayImage16(path);
  return {gray.values.begin(), gray.values.end()};
}

std::vector<FrameWay>
waysToKeepFrames(const std::string& folder, const TrinocularRig& rig)
{
  const auto valuesOfImage = [](const CameraImage& image) { return image.values; };
  return {imageWay("plain files", folder + "/plain", valuesOfImage, loadPlain),
          sessionWay(folder + "/session", rig),
          imageWay("PNG", folder + "/png", encodeAsPng, loadFromPng)};
}

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
  Row() << name << redrawn << max_redraws << none_good << figure(coverage, 3)
        << figure(milli * median(seconds), 1);
}

/** The shots of two distant observations. */
Frames
film(const std::string& scene)
{
  const SimulatedRigGrabber grabber(standardScene(scene), drawPatterns());
  Frames frames;
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
  std::vector<double> writes, reads;
};

void
measure(const FrameWay& way, const Frames& frames, WayFigures& figures)
{
  figures.name = way.name;
  for (const TrinocularFrame::Ptr& frame : frames)
    figures.writes.push_back(measureThread([&] { way.write(*frame); }));
  way.finish();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Images images;
    figures.reads.push_back(measureThread([&] { images = way.read(i); }));
    if (!(images == frames[i]->images))
      throw std::runtime_error(way.name + " reads other images than it wrote");
  }
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(way.folder))
    bytes += entry.file_size();
  figures.bytes = static_cast<double>(bytes) / static_cast<double>(frames.size());
}

void
printWays(const std::string& name, const Frames& frames)
{
  constexpr double kibi = 1024;
  constexpr std::size_t rounds = 3;
  const CameraImage& image = frames.front()->image(RigCamera::Reference);
  TrinocularRig rig;
  rig.width = image.width;
  rig.height = image.height;
  std::vector<WayFigures> all(3);
  for (std::size_t round = 0; round < rounds; ++round) {
    const test::TemporaryFolder folder;
    const std::vector<FrameWay> ways = waysToKeepFrames(folder.path(""), rig);
    for (std::size_t i = 0; i < ways.size(); ++i)
      measure(ways[i], frames, all[i]);
  }
  const WayFigures& plain = all.front();
  for (const WayFigures& way : all) {
    const double write = median(way.writes), read = median(way.reads);
    Row() << name << way.name << figure(way.bytes / kibi, 0)
          << figure(way.bytes / plain.bytes, 2) << figure(milli * write, 1)
          << timesOf(write, median(plain.writes)) << figure(milli * read, 1)
          << timesOf(read, median(plain.reads));
  }
}

/** Wall time of synchronizing each recorded frame to disk. */
void
printDisk(const std::string& name, const Frames& frames)
{
  constexpr std::size_t rounds = 5;
  std::vector<double> waits;
  for (std::size_t round = 0; round < rounds; ++round) {
    const test::TemporaryFolder folder;
    for (const TrinocularFrame::Ptr& frame : frames) {
      const std::string path = folder.path(std::to_string(frame->number) + ".acf");
      saveTrinocularFrame(path, *frame);
      waits.push_back(measureCost([&] { syncToDisk(path); }).wall);
    }
  }
  Row() << name << figure(milli * median(waits), 1)
        << figure(milli * quantile(waits, 0.9), 1);
}

template <typename Print>
void
printScene(const std::string& scene, const Print& print)
{
  const Frames frames = film(scene);
  print(scene + ", colour", frames);
  for (const TrinocularFrame::Ptr& frame : frames)
    for (CameraImage& image : frame->images)
      keepGreen(image);
  print(scene + ", grey", frames);
}

const Section patterns("patterns", [] {
  printHead("1000 patterns | drawn again | redraws of one, at most | none good | "
            "coverage | a pattern, ms");
  printPatterns("as they are", [](RandomLinePattern&) {});
  printPatterns("grey", [](RandomLinePattern& lines) { lines.setColored(false); });
  printPatterns("minimum angle 15°",
                [](RandomLinePattern& lines) { lines.setMinimumAngle(0.2618); });
  printPatterns("60 lines",
                [](RandomLinePattern& lines) { lines.setNumberOfLines(60); });
});

const Section session("session", [] {
  printHead("frames | kept as | KiB a frame | of the values | write, CPU ms | of "
            "plain | read, CPU ms | of plain");
  for (const char* const scene : {"corridor", "office"})
    printScene(scene, printWays);
});

const Section disk("disk", [] {
  printHead("frames | waiting for the disk, ms | nine in ten within, ms");
  printScene("corridor", printDisk);
});

} // namespace
} // namespace pcl::acmap::bench
