#include "score_table.h"

#include "normalized_samples.h"

#include <array>
#include <cstdlib>

namespace pcl::acmap {

ScoreTable::ScoreTable(const PlacedPatches& rows,
                       const PlacedPatches& columns,
                       const MatchGate& gate,
                       const LogPolarSettings& settings,
                       std::int32_t minimum)
: rows_(rows)
, columns_(columns)
, gate_(gate)
, settings_(settings)
, minimum_(minimum)
, column_blocks_((columns.patches.pixels.size() + score_columns - 1) / score_columns)
{
  for (int shift = -settings.ring_shifts; shift <= settings.ring_shifts; ++shift) {
    const int rings = settings.rings - std::abs(shift);
    scales_.push_back({std::max(shift, 0),
                       std::max(-shift, 0),
                       rings,
                       PatchWaves(rings, settings.sectors),
                       {},
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
  const std::size_t length = lengthOf(scale);
  const std::size_t size = columns_.patches.pixels.size();
  scale.columns.resize(stride() * length);
  scale.numbers.resize(stride() * PatchWaves::size);
  const auto patch_length =
      static_cast<std::size_t>(settings_.rings * settings_.sectors);
  oneapi::tbb::parallel_for(std::size_t{0}, size, [&](std::size_t j) {
    std::int16_t* const samples = &scale.columns[j * length];
    takeSamples(&columns_.patches.samples[j * patch_length] +
                    scale.column_begin * settings_.sectors,
                scale.rings,
                0,
                samples);
    std::array<std::int16_t, PatchWaves::size> numbers{};
    scale.waves.numbersOf(samples, numbers.data());
    std::int16_t* const to =
        &scale.numbers[j / score_columns * score_columns * PatchWaves::size];
    for (std::size_t k = 0; k < PatchWaves::size; k += 2) {
      to[score_columns * k + 2 * (j % score_columns)] = numbers[k];
      to[score_columns * k + 2 * (j % score_columns) + 1] = numbers[k + 1];
    }
  });
}

void
ScoreTable::raiseScoresOf(const std::int32_t* rows,
                          std::size_t count,
                          const Scale& scale,
                          int turn,
                          std::int32_t* scores) const
{
  const std::size_t length = lengthOf(scale);
  const auto patch_length =
      static_cast<std::size_t>(settings_.rings * settings_.sectors);
  std::vector<std::int16_t> samples(count * length);
  std::vector<std::int16_t> numbers(score_rows * PatchWaves::size);
  for (std::size_t i = 0; i < count; ++i) {
    takeSamples(
        &rows_.patches.samples[static_cast<std::size_t>(rows[i]) * patch_length] +
            scale.row_begin * settings_.sectors,
        scale.rings,
        turn,
        &samples[i * length]);
    scale.waves.numbersOf(&samples[i * length], &numbers[i * PatchWaves::size]);
  }
  std::vector<std::uint8_t> found(score_rows * column_blocks_);
  findPairs()(
      {numbers.data(), scale.numbers.data(), column_blocks_, PatchWaves::size / 2},
      PatchWaves::boundOf(minimum_),
      found.data());
  const ProductOf product = productOf();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t block = 0; block < column_blocks_; ++block) {
      std::size_t j = block * score_columns;
      for (unsigned bits = found[i * column_blocks_ + block]; bits; bits >>= 1, ++j)
        if (bits & 1) {
          std::int32_t& score = scores[i * stride() + j];
          score = std::max(
              score, product(&samples[i * length], &scale.columns[j * length], length));
        }
    }
}

std::vector<std::int32_t>
ScoreTable::scoresOf(const std::int32_t* rows, std::size_t count) const
{
  std::vector<std::int32_t> scores(count * stride(), no_score);
  for (const Scale& scale : scales_)
    for (int turn = -settings_.sector_shifts; turn <= settings_.sector_shifts; ++turn)
      raiseScoresOf(rows, count, scale, turn, scores.data());
  for (std::size_t i = 0; i < count; ++i)
    applyGate(rows_.places,
              static_cast<std::size_t>(rows[i]),
              columns_.places,
              gate_,
              &scores[i * stride()]);
  return scores;
}

} // namespace pcl::acmap
