// Sums of taps for AVX-512: 16 float lanes.
#include "Native/TapSumLanes.inl"

template struct Drydock::TTapSumLanes<16>;
