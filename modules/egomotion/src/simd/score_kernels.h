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

/** \brief Finds the pairs of a row and a column whose sum of products is at least a
 * minimum. Most of the time of a matching is spent here; all variants for different
 * processors give the same bytes.
 * \param[out] found score_rows by column_blocks, row by row: one bit per column of a
 * block, the first one is the lowest bit */
using FindPairs = void (*)(const ScoreFactors& factors,
                           std::int32_t minimum,
                           std::uint8_t* found);

/** \brief Lengths of samples are multiples of this. */
constexpr std::size_t score_samples = 16;

/** \brief The sum of the products of two patches of \a length samples. */
using ProductOf = std::int32_t (*)(const std::int16_t* a,
                                   const std::int16_t* b,
                                   std::size_t length);

void
findPairsBase(const ScoreFactors& factors, std::int32_t minimum, std::uint8_t* found);

void
findPairsAvx2(const ScoreFactors& factors, std::int32_t minimum, std::uint8_t* found);

std::int32_t
productOfBase(const std::int16_t* a, const std::int16_t* b, std::size_t length);

std::int32_t
productOfAvx2(const std::int16_t* a, const std::int16_t* b, std::size_t length);

/** \brief The variants for this processor. */
FindPairs
findPairs();

ProductOf
productOf();

} // namespace pcl::acmap
