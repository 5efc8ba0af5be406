// The bloom setup for SSE 4.1: 4 float lanes.
#include "Native/BloomSetupLanes.inl"

template struct Drydock::TBloomSetupLanes<4>;
