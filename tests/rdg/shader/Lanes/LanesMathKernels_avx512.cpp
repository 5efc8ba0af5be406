// The table of LanesMathKernels.h for sixteen float lanes.
#define DRYDOCK_TEST_LANES 16
#define DRYDOCK_TEST_GETTER GetMathKernelsAvx512
#include "LanesMathKernels.inl"
