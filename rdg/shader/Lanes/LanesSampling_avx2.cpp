// Sampling and stores for AVX2 with F16C: 8 float lanes and 4 double lanes.
#include "LanesSampling.inl"

template struct Drydock::Lanes::TSampling<float, 8>;
template struct Drydock::Lanes::TSampling<double, 4>;
