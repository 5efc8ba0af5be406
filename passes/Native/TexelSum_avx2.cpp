// Sums of texels for AVX2: 8 float lanes.
#include "Native/TexelSumLanes.inl"

template struct Drydock::TTexelSumLanes<8>;
