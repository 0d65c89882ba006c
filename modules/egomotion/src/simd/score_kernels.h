#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Rows are multiplied four at once, columns eight at once; both are padded. */
constexpr std::size_t score_rows = 4, score_columns = 8;

/** \brief Factors of a product of integer matrices.
 *
 * The samples of a row are stored one after another. Eight columns are stored together
 * and in pairs: the first two samples of the first column, of the second column and so
 * on. */
struct ScoreFactors {
  const std::int16_t* rows;    ///< score_rows rows of 2 * pairs samples
  const std::int16_t* columns; ///< blocks of score_columns * 2 * pairs samples
  std::size_t column_blocks;
  std::size_t pairs;
};

/** \brief The loop that takes most of the time of a matching, in variants for different
 * processors; all variants give the same bytes.
 * \param[in,out] scores of score_rows by all columns, row by row: each is replaced by
 * the sum of products if that is larger */
using RaiseScores = void (*)(const ScoreFactors& factors, std::int32_t* scores);

void
raiseScoresBase(const ScoreFactors& factors, std::int32_t* scores);

void
raiseScoresAvx2(const ScoreFactors& factors, std::int32_t* scores);

/** \brief The variant for this processor. */
RaiseScores
raiseScores();

} // namespace pcl::acmap
