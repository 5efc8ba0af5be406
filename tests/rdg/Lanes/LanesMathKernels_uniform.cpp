// Source: drydock.
#define DRYDOCK_TEST_LANES 1
#define DRYDOCK_TEST_GETTER GetMathKernelsUniform
#include "LanesMathKernels.inl"
