// Builds the benchmark's shaders for AVX-512.
#define DRYDOCK_BENCH_LANES 16
#define DRYDOCK_BENCH_GETTER GetKernelsAvx512
#include "ShaderLanesKernels.inl"
