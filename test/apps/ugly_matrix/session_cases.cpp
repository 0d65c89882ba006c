#include "input_cases.h"
#include "small_world.h"
#include "spoilt_file.h"

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* rig = "shots/rig.yaml";

} // namespace

std::map<std::string, UglyOutcome>
sessionOutcomes()
{
  std::map<std::string, UglyOutcome> outcomes = {
      {"`shots/session.yaml` is not there", {0, "was not finished"}},
      {one_frame, {4, "shots: no pixel has a place"}},
      {millimetre_rig, {2, "the rig's baseline is 100 m"}},
      {odd_folder, {0, ""}}};
  const UglyOutcome lost = {0, "under pattern 0 is missing, after frame 4"};
  outcomes[doubled_frame] = lost;
  for (const Ugliness kind : {Ugliness::Missing,
                              Ugliness::Empty,
                              Ugliness::Truncated,
                              Ugliness::Garbage,
                              Ugliness::Device,
                              Ugliness::Folder})
    outcomes[std::string("`shots/frame_000005.acf` ") + stateOf(kind)] = lost;
  return outcomes;
}

std::vector<UglyCase>
sessionCases(const CommandFor& command,
             const std::map<std::string, UglyOutcome>& outcomes,
             const CaseList::Prepare& others)
{
  const auto good = [others](const TemporaryFolder& folder) {
    others(folder);
    give(folder, hallSession(), "shots");
  };
  CaseList list(good, command("shots"), outcomes);
  list.addRun(Ugliness::Missing, "no such session", "none", command("none"));
  list.addFile("shots/frame_000005.acf");
  list.addFile(rig);
  list.addFile("shots/session.yaml");
  const auto change =
      [&](Ugliness kind, const char* what, const char* from, const char* to) {
        list.add(kind, what, rig, [=](const auto& folder) {
          replaceIn(folder.path(rig), from, to);
        });
      };
  change(Ugliness::NanOnly, nan_rig, "focal_length: 130", "focal_length: .nan");
  list.add(Ugliness::OnePoint, one_frame, "shots", [](const auto& folder) {
    for (int frame = 1; frame < 8; ++frame)
      fs::remove(folder.path("shots/frame_00000" + std::to_string(frame) + ".acf"));
  });
  list.add(
      Ugliness::Doubled, doubled_frame, "frame_000005.acf", [](const auto& folder) {
        fs::copy(folder.path("shots/frame_000004.acf"),
                 folder.path("shots/frame_000005.acf"),
                 fs::copy_options::overwrite_existing);
      });
  change(Ugliness::WrongFields, strange_rig, "focal_length", "focal_lenght");
  change(Ugliness::Huge, vast_rig, "focal_length: 130", "focal_length: 1e30");
  list.add(Ugliness::Millimetres, millimetre_rig, rig, [](const auto& folder) {
    for (const char* baseline :
         {"baseline_horizontal: -0.1", "baseline_vertical: -0.1"})
      replaceIn(
          folder.path(rig),
          baseline,
          std::string(baseline).replace(std::string(baseline).find("0.1"), 3, "100"));
  });
  list.addRun(
      Ugliness::Names,
      odd_folder,
      odd_folder,
      command(odd_folder),
      [](const auto& folder) { give(folder, folder.path("shots"), odd_folder); });
  list.addRun(Ugliness::Device, "`/dev/zero`", "/dev/zero", command("/dev/zero"));
  list.addRun(Ugliness::Folder,
              "a file for the session",
              "none",
              command("none"),
              [](const auto& folder) { folder.write("none", "x"); });
  return list.cases();
}

} // namespace pcl::acmap::test
