// Sampling and stores for AVX-512: 16 float lanes and 8 double lanes.
#include "LanesSampling.inl"

template struct Drydock::Lanes::TSampling<float, 16>;
template struct Drydock::Lanes::TSampling<double, 8>;
