// Compiles: the control of the refused files beside it.
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FAccepted, )
	SHADER_PARAMETER(float, Threshold)
	SHADER_PARAMETER(FVector2f, Extent)
	SHADER_PARAMETER_ARRAY(FVector4f, Weights, [4])
END_SHADER_PARAMETER_STRUCT()
