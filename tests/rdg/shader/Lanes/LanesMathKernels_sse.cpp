// The table of LanesMathKernels.h for four float lanes.
#define DRYDOCK_TEST_LANES 4
#define DRYDOCK_TEST_GETTER GetMathKernelsSse
#include "LanesMathKernels.inl"
