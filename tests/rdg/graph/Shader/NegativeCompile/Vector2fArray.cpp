// Must not compile: see NegativeCompileTest.cpp.
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FRefused, )
	SHADER_PARAMETER_ARRAY(FVector2f, Offsets, [7])
END_SHADER_PARAMETER_STRUCT()
