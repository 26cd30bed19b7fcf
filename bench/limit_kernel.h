#pragma once

#include "bearing/solve_many.h"

namespace raceway::limit {

/// Arithmetic of one ball in one step of Newton's method.
struct Operations {
  long roots, divisions, fused;  ///< fused multiply-adds
};

/// Does that much `count` times, each on a whole SIMD register, without waiting for results.
void do_operations(bearing::InstructionSet set, const Operations& each, long count);

void do_sse2(const Operations& each, long count);
void do_avx2(const Operations& each, long count);
void do_avx512(const Operations& each, long count);

}  // namespace raceway::limit
