// Blurs in lanes for AVX-512: 16 lines side by side.
#include "Study/BlurLanes.inl"

template struct Drydock::TBlurLanes<16>;
