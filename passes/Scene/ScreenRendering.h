// Full-screen draws (FScreenVS, FScreenPassVS) lie in ScreenPass.h. Source: engine file ScreenRendering.h.
#pragma once

#include "ScreenPass.h"
