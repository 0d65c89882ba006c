#include "score_products.h"

namespace pcl::acmap {

void
raiseScoresAvx2(const ScoreFactors& factors, std::int32_t* scores)
{
  raiseAll(factors, scores);
}

} // namespace pcl::acmap
