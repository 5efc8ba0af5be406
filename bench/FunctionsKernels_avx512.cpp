// Builds the functions for AVX-512.
#define DRYDOCK_BENCH_LANES 16
#define DRYDOCK_BENCH_GETTER GetFunctionsAvx512
#include "FunctionsKernels.inl"
