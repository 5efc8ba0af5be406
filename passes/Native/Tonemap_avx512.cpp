// The tonemapper for AVX-512: 16 float lanes.
#include "Native/TonemapLanes.inl"

template struct Drydock::TTonemapLanes<16>;
