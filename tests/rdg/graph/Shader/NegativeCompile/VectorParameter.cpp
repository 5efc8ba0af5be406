// Must not compile: see NegativeCompileTest.cpp.
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FRefused, )
	SHADER_PARAMETER(FVector, Position)
END_SHADER_PARAMETER_STRUCT()
