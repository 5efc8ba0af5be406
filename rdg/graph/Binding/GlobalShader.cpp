// Holds the one map of global shaders, and walks their classes.
#include "GlobalShader.h"

FGlobalShaderMap* GetGlobalShaderMap(ERHIFeatureLevel::Type)
{
	static FGlobalShaderMap Map;
	return &Map;
}

FGlobalShaderMap* GetGlobalShaderMap(EShaderPlatform)
{
	return GetGlobalShaderMap(GMaxRHIFeatureLevel);
}

namespace Drydock
{

void ForEachGlobalShader(TFunctionRef<void(const FGlobalShaderType&)> Function)
{
	ForEachShaderType(
		[&Function](const FShaderType& Type)
		{
			if (const auto* GlobalType = dynamic_cast<const FGlobalShaderType*>(&Type))
			{
				Function(*GlobalType);
			}
		});
}

} // namespace Drydock
