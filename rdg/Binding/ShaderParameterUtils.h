// SetShaderParameters and its neighbours lie in ShaderParameterStruct.h. Source: engine ShaderParameterUtils.h.
#pragma once

#include "ShaderParameterStruct.h"
