#include "input_cases.h"
#include "small_world.h"
#include "ugly_tools.h"

#include <pcl/core/image_file.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

constexpr const char* blank_boards = "images without a board";
constexpr const char* one_shot = "one image a camera";
constexpr const char* doubled_image = "an image that is named twice";
constexpr const char* odd_image = "Messung Nr. 1/Brett 測量.png";
constexpr const char* huge_square = "`--square 1e30`";
constexpr const char* millimetre_square = "`--square 30`";

std::vector<std::string>
boardsCommand(const std::string& image, const std::string& square = "0.03")
{
  return {"--reference",
          image,
          "b.png",
          "--horizontal",
          "c.png",
          "d.png",
          "--square",
          square,
          "-o",
          "rig.yaml"};
}

void
writeBlanks(const TemporaryFolder& folder)
{
  const std::vector<std::uint8_t> png =
      encodePng(64, 48, std::vector<std::uint8_t>(64 * 48, 90));
  for (const char* name : {"a.png", "b.png", "c.png", "d.png"})
    folder.write(name, {png.begin(), png.end()});
}

} // namespace

UglyTool
uglyRigCalibration()
{
  CaseList list(writeBlanks,
                boardsCommand("a.png"),
                {{blank_boards, {4, "reference camera has 0 good boards"}},
                 {one_shot, {4, "reference camera has 0 good boards"}},
                 {doubled_image, {2, "b.png"}},
                 {huge_square, {2, "square of the board"}},
                 {millimetre_square, {2, "square of the board"}},
                 {odd_image, {4, "reference camera has 0 good boards"}}});
  list.addFile("a.png");
  list.addRun(Ugliness::Device, "`/dev/zero`", "/dev/zero", boardsCommand("/dev/zero"));
  list.add(Ugliness::NanOnly, blank_boards, "", [](const auto&) {});
  list.addRun(Ugliness::OnePoint,
              one_shot,
              "",
              {"--reference",
               "a.png",
               "--horizontal",
               "c.png",
               "--square",
               "0.03",
               "-o",
               "rig.yaml"});
  list.addRun(Ugliness::Doubled, doubled_image, "", boardsCommand("b.png"));
  list.addSenseless(Ugliness::WrongFields, "images have no fields");
  list.addRun(Ugliness::Huge, huge_square, "", boardsCommand("a.png", "1e30"));
  list.addRun(
      Ugliness::Millimetres, millimetre_square, "", boardsCommand("a.png", "30"));
  list.addRun(
      Ugliness::Names,
      odd_image,
      odd_image,
      boardsCommand(odd_image),
      [](const auto& folder) { give(folder, folder.path("a.png"), odd_image); });
  return {"pcl_rig_calibration", "rig.yaml", false, false, list.cases()};
}

UglyTool
uglyLinePattern()
{
  const auto command = [](const std::string& output) {
    return std::vector<std::string>{output, "--patterns", "1", "--size", "320x240"};
  };
  const std::string nothing_read = "reads nothing";
  const std::string output = "Muster für 測量";
  CaseList list([](const TemporaryFolder&) {},
                command(output),
                {{"the folder of the output is not there", {5, "none/" + output}},
                 {"a file for the folder", {5, "file"}},
                 {"a folder for the picture", {5, "one.png"}},
                 {"`/dev/null` for the folder", {5, "/dev/null"}},
                 {"`--lines` of 10³⁰", {2, "--lines"}},
                 {"an output without a name", {5, "names no folder"}},
                 {"`" + output + "`", {0, ""}}});
  list.addRun(Ugliness::Missing,
              "the folder of the output is not there",
              "",
              command("none/" + output));
  list.addRun(Ugliness::Empty, "an output without a name", "", command(""));
  for (const Ugliness kind : {Ugliness::Truncated,
                              Ugliness::Garbage,
                              Ugliness::NanOnly,
                              Ugliness::OnePoint,
                              Ugliness::Doubled,
                              Ugliness::WrongFields,
                              Ugliness::Millimetres})
    list.addSenseless(kind, nothing_read);
  list.addRun(Ugliness::Huge, "`--lines` of 10³⁰", "", {output, "--lines", "1e30"});
  list.addRun(Ugliness::Names, "`" + output + "`", "", command(output));
  list.addRun(Ugliness::Device, "`/dev/null` for the folder", "", command("/dev/null"));
  list.addRun(Ugliness::Folder,
              "a file for the folder",
              "",
              command("file"),
              [](const auto& folder) { folder.write("file", "mine"); });
  list.addRun(Ugliness::Folder,
              "a folder for the picture",
              "",
              {"one.png", "--size", "320x240"},
              [](const auto& folder) {
                std::filesystem::create_directory(folder.path("one.png"));
              });
  return {"pcl_line_pattern", output, true, false, list.cases()};
}

} // namespace pcl::acmap::test
