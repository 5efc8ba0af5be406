// Source: drydock.
#define DRYDOCK_BENCH_LANES 16
#define DRYDOCK_BENCH_GETTER GetKernelsAvx512
#include "ShaderLanesKernels.inl"
