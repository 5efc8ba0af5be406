// The tonemapper for SSE 4.1: 4 float lanes.
#include "Native/TonemapLanes.inl"

template struct Drydock::TTonemapLanes<4>;
