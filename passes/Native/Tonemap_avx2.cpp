// The tonemapper for AVX2: 8 float lanes.
#include "Native/TonemapLanes.inl"

template struct Drydock::TTonemapLanes<8>;
