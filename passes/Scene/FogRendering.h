// The height fog as shaders see it (FogStruct.X). A frame of drydock has no fog: a plugin that calls for it fills the
// struct. Source: engine file FogRendering.h.
#pragma once

#include "ShaderParameterMacros.h"
#include "UniformBuffer.h"

/** Exponential height fog: density ExponentialFogParameters.x at the camera, halved every 1 / y centimetres upwards. */
BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FFogUniformParameters, DRYDOCK_API)
	SHADER_PARAMETER(FVector4f, ExponentialFogParameters)  // x density at the camera, y falloff, w where it begins, cm
	SHADER_PARAMETER(FVector4f, ExponentialFogParameters2) // the second layer: x and y as above
	SHADER_PARAMETER(FVector4f, ExponentialFogColorParameter) // rgb, w least transmittance
	SHADER_PARAMETER(FVector4f, ExponentialFogParameters3)    // z where all of it ends, cm; 0 for nowhere
	SHADER_PARAMETER(
		FVector4f, InscatteringLightDirection) // towards the light; w where its glow begins, cm, below 0 for none
	SHADER_PARAMETER(FVector4f, DirectionalInscatteringColor) // rgb, w the exponent of its glow
END_GLOBAL_SHADER_PARAMETER_STRUCT()
