#include "outlines/cell_set.h"
#include "outlines/loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <set>

namespace pcl::acmap::outlines {
namespace {

using Cell = std::pair<int, int>;
using Cells = std::set<Cell>;

CellSet
randomCells(std::mt19937& random, double share)
{
  CellSet cells(1 + static_cast<int>(random() % 150),
                1 + static_cast<int>(random() % 40));
  for (int y = 0; y < cells.height(); ++y)
    for (int x = 0; x < cells.width(); ++x)
      if (random() % 1000 < 1000 * share)
        cells.add(x, y);
  return cells;
}

Cells
membersOf(const CellSet& cells)
{
  Cells members;
  for (int y = 0; y < cells.height(); ++y)
    for (int x = 0; x < cells.width(); ++x)
      if (cells.has(x, y))
        members.insert({x, y});
  return members;
}

/** Is any cell within a radius a member, or all of the grid's? */
bool
anyWithin(const CellSet& cells, int x, int y, double radius, bool wanted)
{
  const int reach = static_cast<int>(radius);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      if (dx * dx + dy * dy <= radius * radius && cells.isInside(x + dx, y + dy) &&
          cells.has(x + dx, y + dy) == wanted)
        return true;
  return false;
}

TEST(CellSet, growsAndShrinksByDiscs)
{
  std::mt19937 random(1);
  for (int run = 0; run < 60; ++run) {
    const CellSet cells = randomCells(random, run % 2 ? 0.1 : 0.9);
    for (const double radius : {1.0, 1.6, 3.0}) {
      const CellSet grown = cells.dilated(radius), shrunk = cells.eroded(radius);
      for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x) {
          ASSERT_EQ(grown.has(x, y), anyWithin(cells, x, y, radius, true));
          ASSERT_EQ(shrunk.has(x, y), !anyWithin(cells, x, y, radius, false));
        }
    }
  }
}

TEST(CellSet, addsRunsInsideOfTheGridOnly)
{
  std::mt19937 random(2);
  for (int run = 0; run < 300; ++run) {
    CellSet cells(1 + static_cast<int>(random() % 200), 3), one_by_one = cells;
    const int from = static_cast<int>(random() % 260) - 30;
    const int to = from + static_cast<int>(random() % 200) - 10;
    for (const int y : {-1, 1, 3})
      cells.addRun(y, from, to);
    for (int x = from; x < to; ++x)
      one_by_one.add(x, 1);
    ASSERT_EQ(membersOf(cells), membersOf(one_by_one));
  }
}

/** The part of a member, found by visiting neighbours. */
Cells
partAround(const CellSet& cells, Cell first, bool is_diagonal)
{
  Cells part{first};
  std::vector<Cell> open{first};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if ((is_diagonal || dx == 0 || dy == 0) && cells.has(x + dx, y + dy) &&
            part.insert({x + dx, y + dy}).second)
          open.emplace_back(x + dx, y + dy);
  }
  return part;
}

TEST(CellSet, partsAreThoseOfNeighbours)
{
  std::mt19937 random(3);
  for (int run = 0; run < 100; ++run) {
    const CellSet cells = randomCells(random, 0.3 + 0.005 * run);
    for (const bool is_diagonal : {false, true}) {
      std::set<Cells> expected, found;
      for (const Cell& cell : membersOf(cells))
        expected.insert(partAround(cells, cell, is_diagonal));
      for (const std::vector<CellRun>& part : partsOf(cells, is_diagonal)) {
        Cells members;
        for (const CellRun& one : part)
          for (int x = one.from; x < one.to; ++x)
            members.insert({x, one.y});
        ASSERT_EQ(static_cast<std::int64_t>(members.size()), sizeOf(part));
        found.insert(members);
      }
      ASSERT_EQ(found, expected);
    }
  }
}

/** Each side between a member and another cell occurs once, with the member on its
 * left, and sides in a loop are connected. */
TEST(CellSet, boundariesAreTheSidesBetweenMembersAndOthers)
{
  std::mt19937 random(4);
  for (int run = 0; run < 100; ++run) {
    const CellSet cells = randomCells(random, 0.05 + 0.009 * run);
    std::set<std::pair<Cell, Cell>> expected, found;
    const auto has = [&](int x, int y) { return cells.has(x, y); };
    for (const auto& [x, y] : membersOf(cells)) {
      if (!has(x, y - 1))
        expected.insert({{x, y}, {x + 1, y}});
      if (!has(x + 1, y))
        expected.insert({{x + 1, y}, {x + 1, y + 1}});
      if (!has(x, y + 1))
        expected.insert({{x + 1, y + 1}, {x, y + 1}});
      if (!has(x - 1, y))
        expected.insert({{x, y + 1}, {x, y}});
    }
    double area = 0;
    for (const CellLoop& loop : boundariesOf(cells)) {
      Loop places;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        ASSERT_TRUE(found.insert({loop[i], loop[(i + 1) % loop.size()]}).second);
        places.emplace_back(loop[i].first, loop[i].second);
      }
      area += signedArea(places);
    }
    ASSERT_EQ(found, expected);
    ASSERT_DOUBLE_EQ(area, static_cast<double>(membersOf(cells).size()));
  }
}

/** A loop does not pass a corner twice: members that share only a corner are apart. */
TEST(CellSet, boundariesOfMembersThatShareACornerAreTwo)
{
  CellSet cells(4, 4);
  cells.add(1, 1);
  cells.add(2, 2);
  EXPECT_EQ(boundariesOf(cells).size(), 2U);
}

} // namespace
} // namespace pcl::acmap::outlines
