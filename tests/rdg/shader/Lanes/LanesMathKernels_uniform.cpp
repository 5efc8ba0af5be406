// The table of LanesMathKernels.h for uniform scalars.
#define DRYDOCK_TEST_LANES 1
#define DRYDOCK_TEST_GETTER GetMathKernelsUniform
#include "LanesMathKernels.inl"
