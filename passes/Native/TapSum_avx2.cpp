// Sums of taps for AVX2: 8 float lanes.
#include "Native/TapSumLanes.inl"

template struct Drydock::TTapSumLanes<8>;
