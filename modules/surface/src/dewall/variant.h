// The kernel is compiled once for each variant, in a namespace of its own: `dewall`, and
// `dewall_avx2` for processors with AVX2 (dewall_avx2.cpp).
#pragma once

#ifndef ACMAP_DEWALL
#define ACMAP_DEWALL dewall
#endif
