#include "rgbd/stamp_matching.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace pcl::acmap {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

struct Stamp {
  double time;
  bool is_second;    ///< list of the stamp
  std::size_t index; ///< index in that list
  std::size_t before;
  std::size_t after;
  bool is_free;
};

/** \brief All stamps of both lists, sorted. The closest pair of unmatched ones is
 * always adjacent: a stamp between them would be closer to one of the two. */
class Matching {
public:
  Matching(const std::vector<double>& first,
           const std::vector<double>& second,
           double gap)
  : gap_(gap)
  {
    for (std::size_t i = 0; i < first.size(); ++i)
      row_.push_back({first[i], false, i, none, none, true});
    for (std::size_t i = 0; i < second.size(); ++i)
      row_.push_back({second[i], true, i, none, none, true});
    std::stable_sort(row_.begin(), row_.end(), [](const Stamp& a, const Stamp& b) {
      return a.time < b.time;
    });
    for (std::size_t i = 0; i < row_.size(); ++i) {
      row_[i].before = i == 0 ? none : i - 1;
      row_[i].after = i + 1 == row_.size() ? none : i + 1;
    }
    for (std::size_t i = 0; i < row_.size(); ++i)
      propose(i, row_[i].after);
  }

  std::vector<std::pair<std::size_t, std::size_t>>
  run()
  {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    while (!proposals_.empty()) {
      const auto [distance, left, right] = proposals_.top();
      proposals_.pop();
      if (!row_[left].is_free || !row_[right].is_free)
        continue;
      const bool swapped = row_[left].is_second;
      pairs.emplace_back(row_[swapped ? right : left].index,
                         row_[swapped ? left : right].index);
      takeOut(left, right);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

private:
  using Proposal = std::tuple<double, std::size_t, std::size_t>;

  void
  propose(std::size_t left, std::size_t right)
  {
    if (left == none || right == none || row_[left].is_second == row_[right].is_second)
      return;
    const double distance = row_[right].time - row_[left].time;
    if (distance <= gap_)
      proposals_.emplace(distance, left, right);
  }

  void
  takeOut(std::size_t left, std::size_t right)
  {
    row_[left].is_free = row_[right].is_free = false;
    const std::size_t before = row_[left].before;
    const std::size_t after = row_[right].after;
    if (before != none)
      row_[before].after = after;
    if (after != none)
      row_[after].before = before;
    propose(before, after);
  }

  double gap_;
  std::vector<Stamp> row_;
  std::priority_queue<Proposal, std::vector<Proposal>, std::greater<>> proposals_;
};

} // namespace

std::vector<std::pair<std::size_t, std::size_t>>
matchStamps(const std::vector<double>& first,
            const std::vector<double>& second,
            double gap)
{
  return Matching(first, second, gap).run();
}

} // namespace pcl::acmap
