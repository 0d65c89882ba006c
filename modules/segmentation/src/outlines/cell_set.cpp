#include "outlines/cell_set.h"

#include <pcl/core/impl/disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::outlines {

CellSet::CellSet(int width, int height)
: width_(width)
, height_(height)
, words_a_row_((static_cast<std::size_t>(width) + 63) / 64)
, words_(words_a_row_ * static_cast<std::size_t>(height))
{}

void
CellSet::addRun(int y, int from, int to)
{
  from = std::max(from, 0);
  to = std::min(to, width_);
  if (y < 0 || y >= height_ || from >= to)
    return;
  Word* const words = row(y);
  const int first = from >> 6, last = (to - 1) >> 6;
  const Word head = ~Word{0} << (from & 63);
  const Word tail = ~Word{0} >> (63 - ((to - 1) & 63));
  if (first == last) {
    words[first] |= head & tail;
    return;
  }
  words[first] |= head;
  std::fill(words + first + 1, words + last, ~Word{0});
  words[last] |= tail;
}

CellSet&
CellSet::operator|=(const CellSet& other)
{
  for (std::size_t i = 0; i < words_.size(); ++i)
    words_[i] |= other.words_[i];
  return *this;
}

CellSet&
CellSet::operator&=(const CellSet& other)
{
  for (std::size_t i = 0; i < words_.size(); ++i)
    words_[i] &= other.words_[i];
  return *this;
}

CellSet&
CellSet::operator-=(const CellSet& other)
{
  for (std::size_t i = 0; i < words_.size(); ++i)
    words_[i] &= ~other.words_[i];
  return *this;
}

void
CellSet::trim()
{
  if ((width_ & 63) == 0)
    return;
  const Word used = ~Word{0} >> (64 - (width_ & 63));
  for (int y = 0; y < height_; ++y)
    row(y)[words_a_row_ - 1] &= used;
}

CellSet
CellSet::complement() const
{
  CellSet result = *this;
  for (Word& word : result.words_)
    word = ~word;
  result.trim();
  return result;
}

namespace {

using Word = CellSet::Word;

/** Adds the cells within \a reach to the left and right; reach < 64. */
CellSet
widened(const CellSet& cells, int reach)
{
  CellSet result = cells;
  const std::size_t size = cells.wordsOfRow();
  for (int y = 0; y < cells.height(); ++y) {
    const Word* const from = cells.row(y);
    Word* const to = result.row(y);
    for (std::size_t i = 0; i < size; ++i) {
      const Word before = i > 0 ? from[i - 1] : 0, here = from[i];
      const Word after = i + 1 < size ? from[i + 1] : 0;
      Word sum = here;
      for (int s = 1; s <= reach; ++s)
        sum |= here << s | before >> (64 - s) | here >> s | after << (64 - s);
      to[i] = sum;
    }
  }
  return result;
}

} // namespace

CellSet
CellSet::dilated(double radius) const
{
  const int reach = static_cast<int>(radius);
  CellSet result(width_, height_), wide;
  int wide_reach = -1;
  for (int dy = reach; dy >= 0; --dy) { // widths ascend, and some occur twice
    const int half = static_cast<int>(std::sqrt(radius * radius - dy * dy));
    if (half != wide_reach)
      wide = widened(*this, half);
    wide_reach = half;
    for (int y = 0; y < height_; ++y)
      for (const int to : {y - dy, y + dy})
        if (to >= 0 && to < height_)
          for (std::size_t i = 0; i < words_a_row_; ++i)
            result.row(to)[i] |= wide.row(y)[i];
  }
  result.trim();
  return result;
}

namespace {

std::vector<CellRun>
runsOf(const CellSet& cells)
{
  std::vector<CellRun> runs;
  for (int y = 0; y < cells.height(); ++y) {
    const Word* const words = cells.row(y);
    int begin = -1;
    Word before = 0;
    for (std::size_t i = 0; i < cells.wordsOfRow(); ++i) {
      // bits where membership changes with respect to the cell on the left
      Word changes = words[i] ^ (words[i] << 1 | before >> 63);
      before = words[i];
      while (changes != 0) {
        const int x = static_cast<int>(64 * i) + __builtin_ctzll(changes);
        changes &= changes - 1;
        if (begin < 0)
          begin = x;
        else {
          runs.push_back({y, begin, x});
          begin = -1;
        }
      }
    }
    if (begin >= 0)
      runs.push_back({y, begin, cells.width()});
  }
  return runs;
}

} // namespace

std::vector<std::vector<CellRun>>
partsOf(const CellSet& cells, bool is_diagonal)
{
  const std::vector<CellRun> runs = runsOf(cells);
  DisjointSets<std::size_t> unions(runs.size());
  const int slack = is_diagonal ? 1 : 0;
  for (std::size_t below = 0, i = 0; i < runs.size(); ++i) {
    while (runs[below].y + 1 < runs[i].y ||
           (runs[below].y + 1 == runs[i].y && runs[below].to + slack <= runs[i].from))
      ++below;
    for (std::size_t k = below;
         runs[k].y + 1 == runs[i].y && runs[k].from < runs[i].to + slack;
         ++k)
      unions.unite(k, i);
  }
  std::vector<std::vector<CellRun>> parts;
  std::vector<std::size_t> numbers(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t first = unions.find(i);
    if (first == i) {
      numbers[i] = parts.size();
      parts.emplace_back();
    }
    parts[numbers[first]].push_back(runs[i]);
  }
  return parts;
}

std::int64_t
sizeOf(const std::vector<CellRun>& part)
{
  std::int64_t size = 0;
  for (const CellRun& run : part)
    size += run.to - run.from;
  return size;
}

namespace {

/** A walk along a boundary, from corner to corner, with the members on its left. */
class BoundaryWalk {
public:
  BoundaryWalk(const CellSet& cells, int x, int y)
  : cells_(cells)
  , x_(x)
  , y_(y)
  {}

  /** Goes one cell further.
   * \return true if it went along the lower side of a member */
  bool
  step()
  {
    const bool is_lower = direction_ == 0;
    x_ += steps[direction_][0];
    y_ += steps[direction_][1];
    if (!isAhead(left))
      direction_ = (direction_ + 1) % 4;
    else if (isAhead(right))
      direction_ = (direction_ + 3) % 4;
    return is_lower;
  }

  int
  x() const
  {
    return x_;
  }

  int
  y() const
  {
    return y_;
  }

  /** Does the next step go along the lower side of this cell? */
  bool
  isBelow(int x, int y) const
  {
    return x_ == x && y_ == y && direction_ == 0;
  }

private:
  using Offsets = std::array<std::array<int, 2>, 4>;
  static constexpr Offsets steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // the cells ahead, relative to the corner, for each direction
  static constexpr Offsets left{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  static constexpr Offsets right{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};

  bool
  isAhead(const Offsets& offsets) const
  {
    return cells_.has(x_ + offsets[direction_][0], y_ + offsets[direction_][1]);
  }

  const CellSet& cells_;
  int x_, y_;
  std::size_t direction_ = 0;
};

} // namespace

std::vector<CellLoop>
boundariesOf(const CellSet& cells)
{
  CellSet starts = cells; // members above a cell that is none
  for (int y = cells.height() - 1; y > 0; --y)
    for (std::size_t i = 0; i < cells.wordsOfRow(); ++i)
      starts.row(y)[i] &= ~cells.row(y - 1)[i];
  std::vector<CellLoop> loops;
  for (int y = 0; y < cells.height(); ++y)
    for (std::size_t i = 0; i < cells.wordsOfRow(); ++i)
      while (starts.row(y)[i] != 0) {
        const int x = static_cast<int>(64 * i) + __builtin_ctzll(starts.row(y)[i]);
        BoundaryWalk walk(cells, x, y);
        CellLoop loop;
        do {
          loop.emplace_back(walk.x(), walk.y());
          const auto [from_x, from_y] = loop.back();
          if (walk.step())
            starts.remove(from_x, from_y);
        } while (!walk.isBelow(x, y));
        loops.push_back(std::move(loop));
      }
  return loops;
}

} // namespace pcl::acmap::outlines
