#include "byte_costs_kernel.h"
#include "byte_paths_kernel.h"
#include "image_rows_kernel.h"
#include "pair_costs_kernel.h"
#include "pair_paths_kernel.h"
#include "sub_pixel_kernel.h"

namespace pcl::acmap {

const PairKernels pair_kernels_avx2{addProducts,
                                    correlateWindows,
                                    countBits,
                                    follow,
                                    findWinners,
                                    sumProducts,
                                    sumLevels,
                                    sumQuarters,
                                    sumFive,
                                    correlateAround};

const ByteKernels byte_kernels_avx2{encode, correlate, followBytes, findByteWinners};

const ImageKernels image_kernels_avx2{toGrey, blurAlong, blurAcross, toFloats};

} // namespace pcl::acmap
