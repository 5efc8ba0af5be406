// Must not compile: see NegativeCompileTest.cpp.
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FRefused, )
	SHADER_PARAMETER(FVector2D, Extent)
END_SHADER_PARAMETER_STRUCT()
