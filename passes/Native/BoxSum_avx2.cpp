// Box means for AVX2: 8 float lanes.
#include "Native/BoxSumLanes.inl"

template struct Drydock::TBoxSumLanes<8>;
