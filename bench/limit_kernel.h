#pragma once

#include "bearing/solve_many.h"

namespace raceway::limit {

/// Numbers of arithmetic operations for one ball in one step of Newton's method.
struct Operations {
  long roots, divisions, fused;  ///< fused multiply-adds
};

/// Executes the operations `each` on whole SIMD registers, `count` times. Operations overlap, so
/// the throughput and not the latency limits the speed.
void do_operations(bearing::InstructionSet set, const Operations& each, long count);

void do_sse2(const Operations& each, long count);
void do_avx2(const Operations& each, long count);
void do_avx512(const Operations& each, long count);

}  // namespace raceway::limit
