// The bloom setup for AVX2: 8 float lanes.
#include "Native/BloomSetupLanes.inl"

template struct Drydock::TBloomSetupLanes<8>;
