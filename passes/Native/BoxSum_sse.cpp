// Box means for SSE 4.1: 4 float lanes.
#include "Native/BoxSumLanes.inl"

template struct Drydock::TBoxSumLanes<4>;
