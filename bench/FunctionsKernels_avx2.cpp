// Builds the functions for AVX2.
#define DRYDOCK_BENCH_LANES 8
#define DRYDOCK_BENCH_GETTER GetFunctionsAvx2
#include "FunctionsKernels.inl"
