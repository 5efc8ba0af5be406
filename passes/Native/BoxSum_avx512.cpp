// Box means for AVX-512: 16 float lanes.
#include "Native/BoxSumLanes.inl"

template struct Drydock::TBoxSumLanes<16>;
