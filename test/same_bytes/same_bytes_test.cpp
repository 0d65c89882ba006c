#include "file_keys.h"
#include "fingerprint.h"
#include "repetitions.h"
#include "stage_runs.h"
#include "virtual_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace pcl::acmap::test {

void
PrintTo(const Stage& stage, std::ostream* out)
{
  *out << stage.name;
}

namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAreArray;

/** Rounds of runs: 1, or the value of ACMAP_SAME_BYTES_ROUNDS. */
int
roundsAsked()
{
  const char* asked = std::getenv("ACMAP_SAME_BYTES_ROUNDS");
  return asked ? std::stoi(asked) : 1;
}

/** In CI, one run differs from the first one (two threads) in several ways. */
std::vector<Variant>
variantsOf(const Stage& stage)
{
  const bool is_short = repetitions(1, 2) == 1;
  if (!stage.has_threads)
    return is_short ? std::vector<Variant>{{0, true}}
                    : std::vector<Variant>{{0, false}, {0, true}};
  if (is_short)
    return {{1, false}, {8, true}};
  return {{1, false}, {2, false}, {8, false}, {2, true}};
}

std::vector<std::string>
differingNames(const Files& a, const Files& b)
{
  std::vector<std::string> names;
  for (const auto& [name, content] : a)
    if (const auto other = b.find(name); other == b.end() || other->second != content)
      names.push_back(name);
  for (const auto& [name, content] : b)
    if (a.count(name) == 0)
      names.push_back(name);
  return names;
}

nlohmann::json
stored(const char* path)
{
  std::ifstream file(path);
  return file ? nlohmann::json::parse(file) : nlohmann::json::object();
}

/** \return true if ACMAP_REFRESH_FINGERPRINTS asks to store instead of comparing */
bool
refreshIfAsked(const char* path, const std::string& stage, const nlohmann::json& found)
{
  if (!std::getenv("ACMAP_REFRESH_FINGERPRINTS"))
    return false;
  auto all = stored(path);
  all[stage] = found;
  // one line each, so that changes are visible as changed lines
  std::ofstream file(path);
  const char* before_stage = "{\n";
  for (const auto& [name, summaries] : all.items()) {
    file << before_stage << nlohmann::json(name) << ": {";
    const char* before = "\n  ";
    for (const auto& [key, summary] : summaries.items()) {
      file << before << nlohmann::json(key) << ": " << summary;
      before = ",\n  ";
    }
    file << "\n}";
    before_stage = ",\n";
  }
  file << "\n}\n";
  return true;
}

/** Created once for all tests. */
StageRuns&
runs()
{
  static StageRuns runs;
  return runs;
}

std::vector<Stage>
stagesWithFingerprints()
{
  std::vector<Stage> stages;
  for (const Stage& stage : stageTable())
    if (!stage.needs_display)
      stages.push_back(stage);
  return stages;
}

class SameBytes : public testing::TestWithParam<Stage> {};

TEST_P(SameBytes, WhateverThreadsAndInstructions)
{
  static const VirtualDisplay display;
  if (GetParam().needs_display && !display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  const Files& wanted = runs().firstOf(GetParam());
  EXPECT_GT(wanted.size(), 1U) << "the report, and something it is about";
  const int rounds = roundsAsked();
  for (int round = 0; round < rounds; ++round)
    for (const Variant& variant : variantsOf(GetParam()))
      EXPECT_THAT(differingNames(runs().run(GetParam(), variant), wanted), IsEmpty())
          << variant.threads << " threads" << (variant.is_plain ? ", plain" : "");
}

class StoredNumbers : public testing::TestWithParam<Stage> {};

TEST_P(StoredNumbers, AreThoseOfTheFiles)
{
  const Stage& stage = GetParam();
  runs().firstOf(stage);
  const auto found = fingerprintOf(numbersIn(runs().folderOf(stage)));
  if (refreshIfAsked(ACMAP_FINGERPRINTS, stage.name, found))
    return;
  const auto wanted =
      stored(ACMAP_FINGERPRINTS).value(stage.name, nlohmann::json::object());
  EXPECT_THAT(differencesOf(found, wanted), IsEmpty());
}

/** What programs of others read: no key of a report, a map or a stage may go unnoticed. */
TEST_P(StoredNumbers, HaveTheKeysOfTheFiles)
{
  const Stage& stage = GetParam();
  runs().firstOf(stage);
  const nlohmann::json found = keysIn(runs().folderOf(stage));
  if (refreshIfAsked(ACMAP_KEYS, stage.name, found))
    return;
  const auto changes = nlohmann::json::diff(stored(ACMAP_KEYS)[stage.name], found);
  EXPECT_TRUE(changes.empty()) << changes.dump(1);
}

std::string
stageName(const testing::TestParamInfo<Stage>& info)
{
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Tools, SameBytes, testing::ValuesIn(stageTable()), stageName);
INSTANTIATE_TEST_SUITE_P(Tools,
                         StoredNumbers,
                         testing::ValuesIn(stagesWithFingerprints()),
                         stageName);

TEST(StoredFingerprints, AreOfTheStagesThatThereAre)
{
  std::vector<std::string> wanted;
  for (const Stage& stage : stagesWithFingerprints())
    wanted.push_back(stage.name);
  for (const char* path : {ACMAP_FINGERPRINTS, ACMAP_KEYS}) {
    std::vector<std::string> found;
    const auto all = stored(path);
    for (const auto& item : all.items())
      found.push_back(item.key());
    EXPECT_THAT(found, UnorderedElementsAreArray(wanted)) << path;
  }
}

TEST(Comparable, ReportsWithoutWhatChanges)
{
  const std::string report =
      R"({"seconds": {"read": 1}, "planes": 3, "peak_memory_bytes": 4,
          "command_line": ["a"], "rows": [["seconds", "1.2"], ["points", "5"]]})";
  EXPECT_EQ(nlohmann::json::parse(comparable("report.json", report)),
            nlohmann::json::parse(R"({"planes": 3, "rows": [[], ["points", "5"]]})"));
  EXPECT_EQ(comparable("planes.json", report), report);
}

} // namespace
} // namespace pcl::acmap::test
