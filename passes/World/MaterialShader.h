// The base of shaders that are compiled for a material: there are no materials to compile here, so nothing makes one.
// Source: engine file MaterialShader.h.
#pragma once

#include "GlobalShader.h"

class DRYDOCK_API FMaterialShader : public FGlobalShader
{
public:
	FMaterialShader() = default;
	FMaterialShader(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}
};
