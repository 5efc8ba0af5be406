// Must not compile: see NegativeCompileTest.cpp.
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FRefused, )
	SHADER_PARAMETER(double, Threshold)
END_SHADER_PARAMETER_STRUCT()
