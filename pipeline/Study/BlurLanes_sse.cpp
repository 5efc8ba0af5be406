// Blurs in lanes for SSE 4.1: 4 lines side by side.
#include "Study/BlurLanes.inl"

template struct Drydock::TBlurLanes<4>;
