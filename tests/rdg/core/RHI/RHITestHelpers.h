// What the RHI's tests share: console variables set for a scope, small textures, kernels that stand in for shaders.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "HAL/IConsoleManager.h"
#include "RHI.h"

namespace Drydock::Tests
{

/** Sets an integer console variable and puts it back. */
class FScopedCVar
{
public:
	FScopedCVar(const TCHAR* Name, int32 Value)
		: Variable(IConsoleManager::Get().FindConsoleVariable(Name))
	{
		check(Variable);
		Before = Variable->GetInt();
		Variable->Set(Value, ECVF_SetByConsole);
	}
	~FScopedCVar() { Variable->Set(Before, ECVF_SetByConsole); }

private:
	IConsoleVariable* Variable;
	int32 Before;
};

inline FRHITextureDesc Make2D(FIntPoint Extent, EPixelFormat Format, uint8 NumMips = 1)
{
	return FRHITextureDesc::Create2D(Extent, Format, FClearValueBinding::Black,
		TexCreate_ShaderResource | TexCreate_RenderTargetable | TexCreate_UAV, NumMips);
}

inline FTextureRHIRef MakeTexture(const FRHITextureDesc& Desc)
{
	return new FRHITexture(Desc, TEXT("Test"));
}

inline FTextureRHIRef MakeTexture(FIntPoint Extent, EPixelFormat Format)
{
	return MakeTexture(Make2D(Extent, Format));
}

/** A shader that is a C++ function. */
inline FBoundShader MakeShader(EShaderStage Stage, FKernelFunction Kernel, FIntVector GroupSize = FIntVector(1, 1, 1))
{
	FShaderReflection Reflection;
	Reflection.Stage = Stage;
	Reflection.GroupSize[0] = GroupSize.X;
	Reflection.GroupSize[1] = GroupSize.Y;
	Reflection.GroupSize[2] = GroupSize.Z;
	Reflection.NumTargets = Stage == EShaderStage::Pixel ? 1 : 0;
	Reflection.NumInterpolants = Stage == EShaderStage::Pixel ? 1 : 0;
	Reflection.StaticSamples = 3;

	FBoundShader Shader;
	Shader.Name = "FTestShader";
	Shader.EntryPoint = "Main";
	Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
	Shader.Kernel = Kernel;
	return Shader;
}

/** Texel of a kernel's view, for 32-bit float storage. */
inline float* GetFloats(const FKernelTexture& View, int32 X, int32 Y, int32 Z = 0)
{
	const FKernelMip& Mip = View.Mips[0];
	const int32 Channels = View.Storage == ETexelStorage::RGBA32_FLOAT ? 4 : 1;
	return reinterpret_cast<float*>(Mip.Data + Z * Mip.SlicePitch + int64(Y) * Mip.RowPitch) + X * Channels;
}

} // namespace Drydock::Tests
