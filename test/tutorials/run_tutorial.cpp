#include "temporary_folder.h"
#include "tutorial_run.h"
#include "virtual_display.h"

#include <exception>
#include <filesystem>
#include <iostream>

// Executes a tutorial like a reader, in a new folder, and compares its pictures with
// the committed ones.

namespace {

using namespace pcl::acmap::test;

/** \brief Creates the inputs of the reader with a script of the test. */
TutorialStep
preparation(const std::string& script)
{
  TutorialStep step;
  step.text = script;
  return step;
}

void
run(const std::string& path, const std::string& before, const std::string& folder)
{
  TutorialPage page = parseTutorial(contentOf(path));
  if (!before.empty())
    page.steps.insert(page.steps.begin(), preparation(before));
  followTutorial(page, folder);
  const std::filesystem::path tutorials = std::filesystem::path(path).parent_path();
  comparePictures(page, folder, tutorials / "../pictures/tutorials");
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2 || argc > 4) {
    std::cerr
        << "usage: run_tutorial PAGE.md [PREPARATION] [FOLDER]\n"
           "PREPARATION is a line of sh that makes what the reader brings, or ''\n"
           "FOLDER, an empty one, is kept: pictures are made that way\n";
    return 2;
  }
  try {
    const VirtualDisplay display("1280x960x24");
    if (!display.exists()) {
      std::cout << "skipped: no X server\n";
      return 0;
    }
    const TemporaryFolder folder;
    run(argv[1], argc > 2 ? argv[2] : "", argc > 3 ? argv[3] : folder.path(""));
  }
  catch (const std::exception& exception) {
    std::cerr << argv[1] << ": " << exception.what() << "\n";
    return 1;
  }
}
