// Sums of texels for AVX-512: 16 float lanes.
#include "Native/TexelSumLanes.inl"

template struct Drydock::TTexelSumLanes<16>;
