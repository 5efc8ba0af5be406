// Full-screen draws (DrawRectangle, FScreenVS) lie in ScreenPass.h. Source: engine file
// PostProcess/SceneFilterRendering.h.
#pragma once

#include "ScreenPass.h"
