#include "score_products.h"

namespace pcl::acmap {

void
raiseScoresBase(const ScoreFactors& factors, std::int32_t* scores)
{
  raiseAll(factors, scores);
}

} // namespace pcl::acmap
