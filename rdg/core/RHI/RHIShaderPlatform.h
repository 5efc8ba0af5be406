// Shader platforms and frequencies. Source: engine RHIShaderPlatform.h, RHIDefinitions.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIFeatureLevel.h"

enum EShaderPlatform : uint16
{
	SP_PCD3D_SM5 = 0,
	SP_METAL = 11,
	SP_VULKAN_SM5 = 20,
	SP_PCD3D_SM6 = 48,
	SP_NumPlatforms = 50,
};

inline constexpr EShaderPlatform GMaxRHIShaderPlatform = SP_PCD3D_SM5;

enum EShaderFrequency : uint8
{
	SF_Vertex = 0,
	SF_Mesh = 1,
	SF_Amplification = 2,
	SF_Pixel = 3,
	SF_Geometry = 4,
	SF_Compute = 5,
	SF_NumFrequencies = 6,
};

inline bool IsFeatureLevelSupported(EShaderPlatform, ERHIFeatureLevel::Type)
{
	return true;
}

inline ERHIFeatureLevel::Type GetMaxSupportedFeatureLevel(EShaderPlatform)
{
	return GMaxRHIFeatureLevel;
}

inline EShaderPlatform GetFeatureLevelShaderPlatform(ERHIFeatureLevel::Type)
{
	return GMaxRHIShaderPlatform;
}

inline bool IsMobilePlatform(EShaderPlatform)
{
	return false;
}

inline bool IsPCPlatform(EShaderPlatform)
{
	return true;
}

inline bool RHISupportsComputeShaders(EShaderPlatform)
{
	return true;
}

/** Draws go to one slice at a time, and there are no geometry shaders. */
inline bool RHISupportsGeometryShaders(EShaderPlatform)
{
	return false;
}
inline bool RHISupportsVertexShaderLayer(EShaderPlatform)
{
	return false;
}
inline bool RHIVolumeTextureRenderingSupportGuaranteed(EShaderPlatform)
{
	return false;
}
inline bool IsMetalMRTPlatform(EShaderPlatform)
{
	return false;
}

/** Asynchronous passes are planned as on a GPU, and run one after another. */
inline constexpr bool GSupportsEfficientAsyncCompute = false;
inline constexpr uint32 GNumExplicitGPUsForRendering = 1;
