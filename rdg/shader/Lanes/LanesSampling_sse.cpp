// Sampling and stores for SSE 4.1: 4 float lanes and 2 double lanes; and one lane of each, the model of
// all widths.
#include "LanesSampling.inl"

template struct Drydock::Lanes::TSampling<float, 1>;
template struct Drydock::Lanes::TSampling<double, 1>;
template struct Drydock::Lanes::TSampling<float, 4>;
template struct Drydock::Lanes::TSampling<double, 2>;
