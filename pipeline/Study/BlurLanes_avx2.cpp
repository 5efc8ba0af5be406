// Blurs in lanes for AVX2: 8 lines side by side.
#include "Study/BlurLanes.inl"

template struct Drydock::TBlurLanes<8>;
