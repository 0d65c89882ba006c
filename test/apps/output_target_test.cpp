#include "output_target.h"

#include "exit_code.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>

namespace pcl::acmap {
namespace {

const std::vector<std::string> meshes = {".ply", ".vtk"};

TEST(OutputTarget, AcceptsNewAndOldFilesInAnyCase)
{
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(requireWritable(folder.path("new.ply"), meshes, {}));
  EXPECT_NO_THROW(requireWritable(folder.path("NEW.VTK"), meshes, {}));
  EXPECT_NO_THROW(requireWritable(folder.write("old.ply", "x"), meshes, {}));
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputTarget, RefusesPlacesWhereNothingCanBeWritten)
{
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  std::filesystem::create_directory(folder.path("folder.ply"));
  std::filesystem::create_symlink("/dev/full", folder.path("device.ply"));
  for (const std::string& path : {folder.path("missing/a.ply"),
                                  folder.path("folder.ply"),
                                  folder.path("a.stl"),
                                  folder.path("a"),
                                  folder.path("device.ply"),
                                  file + "/a.ply",
                                  std::string()})
    EXPECT_THROW(requireWritable(path, meshes, {}), OutputFileException) << path;
}

TEST(OutputTarget, RefusesAFolderThatHoldsItsOwnKind)
{
  const test::TemporaryFolder folder;
  folder.write("picture.png", "x");
  const auto is_ours = [](const std::string& name) { return name == "picture.png"; };
  const OutputFolder out(folder.path("."));
  EXPECT_THROW(requireNoneIn(out, is_ours), OutputFileException);
  std::filesystem::rename(folder.path("picture.png"), folder.path("other.png"));
  EXPECT_NO_THROW(requireNoneIn(out, is_ours));
}

TEST(OutputTarget, RefusesToReplaceAFileOfTheRun)
{
  const test::TemporaryFolder folder;
  const std::string input = folder.write("a.ply", "x");
  std::filesystem::create_symlink(input, folder.path("link.ply"));
  EXPECT_THROW(requireWritable(input, meshes, {input}), UsageError);
  EXPECT_THROW(requireWritable(folder.path("./a.ply"), meshes, {input}), UsageError);
  EXPECT_THROW(requireWritable(folder.path("link.ply"), meshes, {input}), UsageError);
  EXPECT_THROW(requireWritable(folder.path("b.ply"), meshes, {folder.path("b.ply")}),
               UsageError);
}

} // namespace
} // namespace pcl::acmap
