#include "revisits/revisit_proposals.h"

#include <pcl/core/progress.h>

#include <opencv2/core.hpp>
#include <opencv2/flann.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

using Votes = std::map<std::pair<std::size_t, std::size_t>, double>;

/** Seeds OpenCV's random numbers for a block, and restores them afterwards: the trees
 * of the index must be the same in every run. */
class SeededRandom {
public:
  SeededRandom()
  : before_(cv::theRNG())
  {
    cv::theRNG() = cv::RNG(1);
  }

  SeededRandom(const SeededRandom&) = delete;
  SeededRandom&
  operator=(const SeededRandom&) = delete;

  ~SeededRandom()
  {
    cv::theRNG() = before_;
  }

private:
  cv::RNG before_;
};

std::size_t
separation(std::size_t a, std::size_t b)
{
  return a > b ? a - b : b - a;
}

/** Votes of all keypoints, for pairs of an earlier and a later view. */
Votes
votesOf(const std::vector<ViewKeypoints>& views, std::size_t min_separation)
{
  constexpr int checks = 512;
  constexpr int max_distance = 60; // bits of 256
  cv::Mat all;
  std::vector<std::size_t> view_of;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!views[i].keypoints.empty()) {
      all.push_back(views[i].descriptors);
      view_of.insert(view_of.end(), views[i].keypoints.size(), i);
    }
  Votes votes;
  if (all.empty())
    return votes;
  const int neighbours = std::min(64, all.rows);
  const SeededRandom seeded;
  cv::flann::GenericIndex<cvflann::Hamming<unsigned char>> index(
      all, cvflann::HierarchicalClusteringIndexParams());
  cv::Mat found(all.rows, neighbours, CV_32S), distances(all.rows, neighbours, CV_32S);
  constexpr int between_polls = 256;
  for (int first = 0; first < all.rows; first += between_polls) {
    pollRun();
    const cv::Range rows(first, std::min(first + between_polls, all.rows));
    cv::Mat found_there = found.rowRange(rows),
            distances_there = distances.rowRange(rows);
    index.knnSearch(all.rowRange(rows),
                    found_there,
                    distances_there,
                    neighbours,
                    cvflann::SearchParams(checks));
  }
  std::vector<std::size_t> alike;
  for (int row = 0; row < all.rows; ++row) {
    const std::size_t view = view_of[static_cast<std::size_t>(row)];
    alike.clear();
    for (int k = 0; k < neighbours; ++k) {
      const int other_row = found.at<int>(row, k);
      if (other_row < 0 || distances.at<int>(row, k) > max_distance)
        continue;
      const std::size_t other = view_of[static_cast<std::size_t>(other_row)];
      if (separation(view, other) >= min_separation)
        alike.push_back(other);
    }
    std::sort(alike.begin(), alike.end());
    alike.erase(std::unique(alike.begin(), alike.end()), alike.end());
    const double weight =
        std::log(static_cast<double>(views.size()) / static_cast<double>(alike.size()));
    for (const std::size_t other : alike)
      votes[std::minmax(view, other)] += weight;
  }
  return votes;
}

} // namespace

std::vector<ProposedRevisit>
proposeRevisits(const std::vector<ViewKeypoints>& views, std::size_t min_separation)
{
  constexpr std::size_t proposals_per_view = 4;
  std::vector<std::vector<std::pair<double, std::size_t>>> liked(views.size());
  for (const auto& [pair, votes] : votesOf(views, min_separation)) {
    liked[pair.first].emplace_back(-votes, pair.second);
    liked[pair.second].emplace_back(-votes, pair.first);
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs; // later, earlier
  for (std::size_t view = 0; view < views.size(); ++view) {
    auto& others = liked[view];
    std::sort(others.begin(), others.end());
    for (std::size_t i = 0; i < std::min(others.size(), proposals_per_view); ++i)
      pairs.emplace_back(std::max(view, others[i].second),
                         std::min(view, others[i].second));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<ProposedRevisit> proposals;
  for (const auto& [later, earlier] : pairs)
    proposals.push_back({earlier, later});
  return proposals;
}

} // namespace pcl::acmap
