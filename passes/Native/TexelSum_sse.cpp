// Sums of texels for SSE 4.1: 4 float lanes.
#include "Native/TexelSumLanes.inl"

template struct Drydock::TTexelSumLanes<4>;
