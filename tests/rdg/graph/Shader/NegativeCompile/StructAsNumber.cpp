// Must not compile: see NegativeCompileTest.cpp.
#include "ShaderParameterStruct.h"

struct FPair
{
	float A;
	float B;
};

BEGIN_SHADER_PARAMETER_STRUCT(FRefused, )
	SHADER_PARAMETER(FPair, Pair)
END_SHADER_PARAMETER_STRUCT()
