#include "tree_search_kernel.h"

namespace pcl::acmap::dewall {

const TreeSearch tree_search_base{findApexes<false>, findApexes<true>, findInBall};

} // namespace pcl::acmap::dewall
