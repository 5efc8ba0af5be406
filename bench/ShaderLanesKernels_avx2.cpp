// Builds the benchmark's shaders for AVX2.
#define DRYDOCK_BENCH_LANES 8
#define DRYDOCK_BENCH_GETTER GetKernelsAvx2
#include "ShaderLanesKernels.inl"
