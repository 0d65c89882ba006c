#include "every_tool.h"
#include "repetitions.h"
#include "small_disk.h"

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/** \brief Runs every tool with each of its outputs in a bad folder, and the others in a
 * good one. */
class OutputPlace : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!SmallDisk::isAllowed())
      GTEST_SKIP() << "this user may mount no disk, not even in a world of its own";
    for (const char* const name : {"bad", "good"})
      fs::create_directory(folder_.path(name));
  }

  /** \brief Runs a tool with one output in the bad folder. */
  ToolRun
  run(const ToolRow& row, const std::string& bad) const
  {
    return runRow(row, [&](const std::string& output) {
      return folder_.path((output == bad ? "bad/" : "good/") + output);
    });
  }

  /** \brief Creates an existing output, if it is a file. */
  void
  writeOld(const std::string& output) const
  {
    if (fs::path(output).has_extension())
      folder_.write("bad/" + output, "old");
  }

  void
  expectOld(const std::string& output) const
  {
    if (fs::path(output).has_extension())
      EXPECT_EQ(contentOf(folder_.path("bad/" + output)), "old");
    else
      EXPECT_FALSE(fs::exists(folder_.path("bad/" + output)));
    EXPECT_THAT(hiddenBelow(folder_.path("")), IsEmpty());
  }

  void
  expectRefused(const ToolRun& run, const std::string& bad) const
  {
    test::expectRefused(run, 5, folder_.path("bad/" + bad));
  }

  /** \brief Empties the good folder. */
  void
  clear() const
  {
    fs::remove_all(folder_.path("good"));
    fs::create_directory(folder_.path("good"));
  }

  TemporaryFolder folder_;
};

TEST_F(OutputPlace, ThatIsReadOnlyIsRefusedBeforeAnyWork)
{
  for (const ToolRow& row : everyTool())
    for (const std::string& output :
         canRun(row) ? outputsOf(row) : std::vector<std::string>()) {
      SCOPED_TRACE(row.tool + " " + output);
      const SmallDisk disk(folder_.path("bad"), 1 << 16);
      writeOld(output);
      disk.makeReadOnly();
      expectRefused(run(row, output), output);
      expectOld(output);
      EXPECT_TRUE(fs::is_empty(folder_.path("good")));
      clear();
    }
}

TEST_F(OutputPlace, ThatIsFullKeepsWhatWasThere)
{
  for (const ToolRow& row : everyTool())
    for (const std::string& output :
         canRun(row) ? outputsOf(row) : std::vector<std::string>()) {
      SCOPED_TRACE(row.tool + " " + output);
      const SmallDisk disk(folder_.path("bad"), 1 << 16);
      writeOld(output);
      disk.fill(0);
      expectRefused(run(row, output), output);
      expectOld(output);
      clear();
    }
}

/** In CI, only the first output of each tool, which is its main result, has a disk that
 * becomes full. */
TEST_F(OutputPlace, ThatIsFullBeforeLongLeavesAllOrNothing)
{
  for (const ToolRow& row : everyTool())
    for (const std::string& output :
         isWorthwhile(row) ? outputsOf(row) : std::vector<std::string>()) {
      if (output != outputsOf(row).front() && repetitions(1, 2) == 1)
        continue;
      SCOPED_TRACE(row.tool + " " + output);
      const SmallDisk disk(folder_.path("bad"), 1 << 16);
      writeOld(output);
      disk.fill(5);
      const ToolRun full = run(row, output);
      if (full.exit_code == 0)
        EXPECT_THAT(hiddenBelow(folder_.path("")), IsEmpty());
      else
        expectRefused(full, output);
      if (full.exit_code != 0 && row.keeps.empty())
        expectOld(output);
      clear();
    }
}

/** \brief Puts all outputs into one folder. */
auto
allIn(const TemporaryFolder& folder)
{
  return [&folder](const std::string& output) { return folder.path(output); };
}

TEST(StandardOutput, ThatIsFullIsAFaultOfItsOwn)
{
  RunSettings full;
  full.out_file = "/dev/full";
  for (const ToolRow& row : everyTool()) {
    if (!canRun(row))
      continue;
    SCOPED_TRACE(row.tool);
    const TemporaryFolder folder;
    const ToolRun run = runRow(row, allIn(folder), full);
    EXPECT_EQ(run.exit_code, 5);
    EXPECT_THAT(run.err, HasSubstr(row.tool + ": standard output: "));
    for (const std::string& output : outputsOf(row))
      EXPECT_TRUE(fs::exists(folder.path(output))) << output;
    EXPECT_THAT(hiddenBelow(folder.path("")), IsEmpty());
    for (const char* const option : {"--help", "--version"})
      EXPECT_EQ(runTool(ACMAP_TOOLS "/" + row.tool, {option}, full).exit_code, 5);
  }
}

TEST(StandardOutput, WhoseReaderIsGoneEndsTheToolOnceItsFilesAreInPlace)
{
  RunSettings settings;
  settings.reader_is_gone = true;
  for (const ToolRow& row : everyTool()) {
    if (!isWorthwhile(row))
      continue;
    SCOPED_TRACE(row.tool);
    const TemporaryFolder folder;
    EXPECT_EQ(runRow(row, allIn(folder), settings).signal, SIGPIPE);
    for (const std::string& output : outputsOf(row))
      EXPECT_TRUE(fs::exists(folder.path(output))) << output;
    EXPECT_THAT(hiddenBelow(folder.path("")), IsEmpty());
  }
}

} // namespace
} // namespace pcl::acmap::test
