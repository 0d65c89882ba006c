#include "virtual_display.h"

#include <pcl/exceptions.h>
#include <pcl/visualization/display_connection.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace pcl::acmap::test {
namespace {

TEST(DisplayConnection, SurvivesItsServer)
{
  VirtualDisplay display("640x480x24");
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  std::optional<DisplayConnection> connection(std::in_place);
  EXPECT_TRUE(connection->isOpen());
  const std::string name = std::getenv("DISPLAY");
  display.stop();
  EXPECT_FALSE(connection->isOpen());
  EXPECT_FALSE(connection->isOpen());
  connection.reset(); // a connection of Xlib would end the process
  const char* const other = std::getenv("DISPLAY");
  const std::string before = other ? other : "";
  setenv("DISPLAY", name.c_str(), 1);
  EXPECT_THROW(DisplayConnection(), InitFailedException);
  unsetenv("DISPLAY");
  EXPECT_THROW(DisplayConnection(), InitFailedException);
  if (!before.empty())
    setenv("DISPLAY", before.c_str(), 1);
}

} // namespace
} // namespace pcl::acmap::test
