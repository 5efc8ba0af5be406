// Sums of taps for SSE 4.1: 4 float lanes.
#include "Native/TapSumLanes.inl"

template struct Drydock::TTapSumLanes<4>;
