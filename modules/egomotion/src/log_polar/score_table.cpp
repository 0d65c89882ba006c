#include "score_table.h"

#include "normalized_samples.h"

#include <cstdlib>

namespace pcl::acmap {

ScoreTable::ScoreTable(const PlacedPatches& rows,
                       const PlacedPatches& columns,
                       const MatchGate& gate,
                       const LogPolarSettings& settings)
: rows_(rows)
, columns_(columns)
, gate_(gate)
, settings_(settings)
, column_blocks_((columns.patches.pixels.size() + score_columns - 1) / score_columns)
{
  for (int shift = -settings.ring_shifts; shift <= settings.ring_shifts; ++shift) {
    scales_.push_back({std::max(shift, 0),
                       std::max(-shift, 0),
                       settings.rings - std::abs(shift),
                       {}});
    packColumns(scales_.back());
  }
}

void
ScoreTable::takeSamples(const float* patch,
                        int rings,
                        int turn,
                        std::int16_t* samples) const
{
  const auto size = static_cast<std::size_t>(rings * settings_.sectors);
  std::vector<float> part(patch, patch + size);
  if (rings != settings_.rings)
    normalizeSamples(part.data(), size);
  const auto sectors = static_cast<std::size_t>(settings_.sectors);
  const std::size_t skipped =
      static_cast<std::size_t>(turn + settings_.sectors) % sectors;
  for (std::size_t ring = 0; ring < size; ring += sectors) {
    const auto begin = part.begin() + static_cast<std::ptrdiff_t>(ring);
    if (skipped)
      std::rotate(begin,
                  begin + static_cast<std::ptrdiff_t>(skipped),
                  begin + static_cast<std::ptrdiff_t>(sectors));
  }
  for (std::size_t k = 0; k < size; ++k)
    samples[k] = static_cast<std::int16_t>(part[k] * score_length +
                                           (part[k] < 0 ? -0.5F : 0.5F));
}

void
ScoreTable::packColumns(Scale& scale) const
{
  const std::size_t length = 2 * pairsOf(scale);
  scale.columns.resize(column_blocks_ * score_columns * length);
  const std::size_t size = columns_.patches.pixels.size();
  const auto patch_length =
      static_cast<std::size_t>(settings_.rings * settings_.sectors);
  oneapi::tbb::parallel_for(std::size_t{0}, column_blocks_, [&](std::size_t block) {
    std::vector<std::int16_t> samples(length);
    std::int16_t* const to = &scale.columns[block * score_columns * length];
    const std::size_t begin = block * score_columns;
    for (std::size_t j = 0; j < score_columns && begin + j < size; ++j) {
      takeSamples(&columns_.patches.samples[(begin + j) * patch_length] +
                      scale.column_begin * settings_.sectors,
                  scale.rings,
                  0,
                  samples.data());
      for (std::size_t k = 0; k < length; k += 2) {
        to[score_columns * k + 2 * j] = samples[k];
        to[score_columns * k + 2 * j + 1] = samples[k + 1];
      }
    }
  });
}

std::vector<std::int32_t>
ScoreTable::scoresOf(const std::int32_t* rows, std::size_t count) const
{
  std::vector<std::int32_t> scores(score_rows * stride(), no_score);
  const auto patch_length =
      static_cast<std::size_t>(settings_.rings * settings_.sectors);
  for (const Scale& scale : scales_) {
    const std::size_t length = 2 * pairsOf(scale);
    std::vector<std::int16_t> samples(score_rows * length);
    for (int turn = -settings_.sector_shifts; turn <= settings_.sector_shifts; ++turn) {
      for (std::size_t i = 0; i < count; ++i)
        takeSamples(
            &rows_.patches.samples[static_cast<std::size_t>(rows[i]) * patch_length] +
                scale.row_begin * settings_.sectors,
            scale.rings,
            turn,
            &samples[i * length]);
      raiseScores()(
          {samples.data(), scale.columns.data(), column_blocks_, pairsOf(scale)},
          scores.data());
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    applyGate(rows_.places,
              static_cast<std::size_t>(rows[i]),
              columns_.places,
              gate_,
              &scores[i * stride()]);
  return scores;
}

} // namespace pcl::acmap
