// Sampling and stores for SSE 4.1: 4 float lanes and 2 double lanes.
#include "LanesSampling.inl"

template struct Drydock::Lanes::TSampling<float, 4>;
template struct Drydock::Lanes::TSampling<double, 2>;
