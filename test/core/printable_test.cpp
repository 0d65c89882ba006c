#include <pcl/core/printable_text.h>

#include <gtest/gtest.h>

namespace pcl::acmap {
namespace {

TEST(Printable, LettersOfAllLanguagesPass)
{
  for (const char* text : {"", "wall 1.pcd", "Größe.pcd", "測量.pcd", "10³⁰ 🏠"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WhatWouldUpsetATerminalIsMasked)
{
  EXPECT_EQ(printable("a\x1b[2Jb\n\x7f"), "a?[2Jb??");
  EXPECT_EQ(printable("\xff\xfe"), "??");
  EXPECT_EQ(printable("\xc3"), "?");
  EXPECT_EQ(printable("\xc3("), "?(");
  EXPECT_EQ(printable("\xc0\xaf"), "??");
  EXPECT_EQ(printable("\xc2\x9b"), "??");
}

} // namespace
} // namespace pcl::acmap
