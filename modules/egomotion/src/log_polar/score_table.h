#pragma once

#include "../simd/score_kernels.h"
#include "patch_places.h"
#include "patch_waves.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace pcl::acmap {

/** \brief Scores are integers, so that sums do not depend on the order: a score is the
 * Pearson coefficient times the square of this. */
constexpr float score_length = 32000;

/** \brief The Pearson coefficient of a score; -1 for \ref no_score. */
inline float
coefficientOf(std::int32_t score)
{
  return std::clamp(
      static_cast<float>(score) / (score_length * score_length), -1.0F, 1.0F);
}

/** \brief Patches of one image and their positions. */
struct PlacedPatches {
  const LogPolarPatches& patches;
  const PatchPlaces& places;
};

/** \brief Scores of all pairs of patches that pass the gate: the maxima over all
 * shifts, computed by rows. A score below \a minimum is either told or \ref no_score:
 * most pairs are excluded by \ref PatchWaves. */
class ScoreTable {
public:
  ScoreTable(const PlacedPatches& rows,
             const PlacedPatches& columns,
             const MatchGate& gate,
             const LogPolarSettings& settings,
             std::int32_t minimum);

  /** \brief Calls use (k, scores of row which[k] with all columns), in any order. */
  template <typename Use>
  void
  forEachRow(const std::vector<std::int32_t>& which, const Use& use) const
  {
    const std::size_t groups = (which.size() + score_rows - 1) / score_rows;
    oneapi::tbb::parallel_for(std::size_t{0}, groups, [&](std::size_t group) {
      const std::size_t begin = group * score_rows;
      const std::size_t count = std::min(score_rows, which.size() - begin);
      const std::vector<std::int32_t> scores = scoresOf(&which[begin], count);
      for (std::size_t i = 0; i < count; ++i)
        use(begin + i, &scores[i * stride()]);
    });
  }

private:
  /** The rings that both patches have in common at a difference in scale. */
  struct Scale {
    int row_begin, column_begin, rings;
    PatchWaves waves;
    std::vector<std::int16_t> columns; ///< samples, one patch after another
    std::vector<std::int16_t>
        numbers; ///< of the columns, in the layout of ScoreFactors
  };

  std::size_t
  stride() const
  {
    return column_blocks_ * score_columns;
  }

  /** Length of the samples of a patch, padded by zeros. */
  std::size_t
  lengthOf(const Scale& scale) const
  {
    const auto samples = static_cast<std::size_t>(scale.rings * settings_.sectors);
    return (samples + score_samples - 1) / score_samples * score_samples;
  }

  /** Converts samples of some rings to integers, rotated by \a turn sectors. */
  void
  takeSamples(const float* patch, int rings, int turn, std::int16_t* samples) const;

  void
  packColumns(Scale& scale) const;

  /** Raises the scores of some rows at one scale and turn. */
  void
  raiseScoresOf(const std::int32_t* rows,
                std::size_t count,
                const Scale& scale,
                int turn,
                std::int32_t* scores) const;

  std::vector<std::int32_t>
  scoresOf(const std::int32_t* rows, std::size_t count) const;

  PlacedPatches rows_, columns_;
  MatchGate gate_;
  LogPolarSettings settings_;
  std::int32_t minimum_;
  std::size_t column_blocks_;
  std::vector<Scale> scales_;
};

} // namespace pcl::acmap
