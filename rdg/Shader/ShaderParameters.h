// The engine's older parameter header; everything lies in ShaderParameterMacros.h. Source: engine ShaderParameters.h.
#pragma once

#include "ShaderParameterMacros.h"
