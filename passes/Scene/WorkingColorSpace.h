// The colour space that scenes are lit in, as shaders see it (WorkingColorSpace.X): linear Rec.709, as the engine's
// default. Source: engine struct FWorkingColorSpaceShaderParameters.
#pragma once

#include "RenderResource.h"
#include "ShaderParameterMacros.h"
#include "UniformBuffer.h"

/** Matrices act on column vectors: mul(WorkingColorSpace.ToAP1, Color). XYZ is under D65. */
BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FWorkingColorSpaceShaderParameters, DRYDOCK_API)
	SHADER_PARAMETER(FMatrix44f, ToXYZ)
	SHADER_PARAMETER(FMatrix44f, FromXYZ)
	SHADER_PARAMETER(FMatrix44f, ToAP1)
	SHADER_PARAMETER(FMatrix44f, FromAP1)
	SHADER_PARAMETER(FMatrix44f, ToAP0)
	SHADER_PARAMETER(uint32, bIsSRGB)
END_GLOBAL_SHADER_PARAMETER_STRUCT()

/** The working colour space's uniform buffer, made on first use. */
class DRYDOCK_API FDefaultWorkingColorSpaceUniformBuffer
{
public:
	const TUniformBufferRef<FWorkingColorSpaceShaderParameters>& GetUniformBufferRef() const;
	FRHIUniformBuffer* GetUniformBufferRHI() const { return GetUniformBufferRef().GetReference(); }
};

extern DRYDOCK_API FDefaultWorkingColorSpaceUniformBuffer GDefaultWorkingColorSpaceUniformBuffer;
