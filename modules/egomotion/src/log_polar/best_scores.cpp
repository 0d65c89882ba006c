#include "best_scores.h"

#include <algorithm>

namespace pcl::acmap {

BestScore
bestOf(const std::int32_t* scores, std::size_t size)
{
  std::int32_t best = no_score;
  for (std::size_t j = 0; j < size; ++j)
    best = std::max(best, scores[j]);
  if (best == no_score)
    return {};
  return {static_cast<std::int32_t>(std::find(scores, scores + size, best) - scores),
          best};
}

std::int32_t
bestElsewhere(const std::int32_t* scores,
              const PatchPlaces& places,
              std::size_t from,
              float distance)
{
  std::int32_t best = no_score;
  const float u = places.u[from], v = places.v[from], near = distance * distance;
  for (std::size_t j = 0; j < places.u.size(); ++j) {
    const float right = places.u[j] - u, down = places.v[j] - v;
    const std::int32_t score =
        right * right + down * down > near ? scores[j] : no_score;
    best = std::max(best, score);
  }
  return best;
}

void
ColumnBests::add(std::int32_t row, const std::int32_t* scores)
{
  // If scores are equal, the lower row is kept, independently of the order.
  for (std::size_t j = 0; j < scores_.size(); ++j) {
    const int better = scores[j] > scores_[j];
    const int sooner = int(scores[j] == scores_[j]) & int(row < rows_[j]);
    rows_[j] = (better | sooner) != 0 ? row : rows_[j];
    scores_[j] = better != 0 ? scores[j] : scores_[j];
  }
}

void
ColumnBests::add(const ColumnBests& others)
{
  for (std::size_t j = 0; j < scores_.size(); ++j)
    if (others.scores_[j] > scores_[j] ||
        (others.scores_[j] == scores_[j] && others.rows_[j] < rows_[j])) {
      scores_[j] = others.scores_[j];
      rows_[j] = others.rows_[j];
    }
}

} // namespace pcl::acmap
