// There are no materials: what code takes from it are the global shaders. Source: engine file MaterialShader.h.
#pragma once

#include "GlobalShader.h"
