#include "score_products.h"

namespace pcl::acmap {

void
findPairsBase(const ScoreFactors& factors, std::int32_t minimum, std::uint8_t* found)
{
  findAll(factors, minimum, found);
}

std::int32_t
productOfBase(const std::int16_t* a, const std::int16_t* b, std::size_t length)
{
  return productOfAll(a, b, length);
}

} // namespace pcl::acmap
