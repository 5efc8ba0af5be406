// The bloom setup for AVX-512: 16 float lanes.
#include "Native/BloomSetupLanes.inl"

template struct Drydock::TBloomSetupLanes<16>;
