// The table of LanesMathKernels.h for eight float lanes.
#define DRYDOCK_TEST_LANES 8
#define DRYDOCK_TEST_GETTER GetMathKernelsAvx2
#include "LanesMathKernels.inl"
