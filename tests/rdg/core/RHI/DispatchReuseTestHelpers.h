// Kernels that count what they compute, and the dispatches and draws of the tests of reuse.
#pragma once

#include <atomic>
#include <cstring>
#include <functional>

#include "DispatchReuse.h"
#include "PipelineStateCache.h"
#include "RHITestHelpers.h"

namespace Drydock::Tests
{

inline std::atomic<int32> GNumTexels{0}; // that kernels have computed

inline float ReadFloat(const FKernelTexture& View, int32 X, int32 Y)
{
	const FKernelMip& Mip = View.Mips[0];
	return *GetFloats(View, X % Mip.SizeX, Y % Mip.SizeY);
}

/** The sum of all inputs and the constant. */
inline float Sum(const FKernelArgs& Args, const FKernelTexture* Input, int32 X, int32 Y)
{
	float Constant;
	std::memcpy(&Constant, Args.ConstantBuffers[0], sizeof(Constant));
	++GNumTexels;
	return Constant + float(X) + (Input ? ReadFloat(*Input, X, Y) : 0.0f);
}

/** Stores to all texels. */
inline void Store(const FKernelArgs& Args, const FKernelTile& Tile)
{
	const FKernelTexture& Out = Args.RWTextures[0];
	for (int32 Y = Tile.MinY; Y < std::min(Tile.MaxY, Out.Mips[0].SizeY); ++Y)
	{
		for (int32 X = Tile.MinX; X < std::min(Tile.MaxX, Out.Mips[0].SizeX); ++X)
		{
			*GetFloats(Out, X, Y) = Sum(Args, Args.Textures, X, Y);
		}
	}
	if (Args.Counters)
	{
		Args.Counters->Loads += 1;
	}
}

/** Adds to every second texel, in place. */
inline void AddToSome(const FKernelArgs& Args, const FKernelTile& Tile)
{
	const FKernelTexture& Out = Args.RWTextures[0];
	for (int32 Y = Tile.MinY; Y < std::min(Tile.MaxY, Out.Mips[0].SizeY); ++Y)
	{
		for (int32 X = Tile.MinX; X < std::min(Tile.MaxX, Out.Mips[0].SizeX); X += 2)
		{
			*GetFloats(Out, X, Y) += Sum(Args, nullptr, X, Y);
		}
	}
}

/** Counts in a buffer. */
inline void Count(const FKernelArgs& Args, const FKernelTile&)
{
	++GNumTexels;
	++*reinterpret_cast<uint32*>(Args.RWBuffers[0].Data);
}

/** Draws to target 0; leaves out every third row where the constant is negative, as a shader that discards. */
inline void DrawSum(const FKernelArgs& Args, const FKernelTile& Tile)
{
	float Constant;
	std::memcpy(&Constant, Args.ConstantBuffers[0], sizeof(Constant));
	for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
	{
		for (int32 X = Tile.MinX; X < Tile.MaxX && (Constant >= 0 || Y % 3 != 0); ++X)
		{
			*GetFloats(Args.Targets[0].Texture, X, Y) =
				Sum(Args, Args.Textures, X, Y) + float(Args.Interpolants[0].Base[0]);
		}
	}
}

/** The resources that a pass binds. */
struct FPass
{
	float Constant = 1.0f;
	FRHITexture* Input = nullptr;
	std::string Key = "sum";
	FKernelSampler Sampler = {};
	FIntRect Rect = FIntRect(0, 0, 40, 24); // draws
	bool bBlend = false;
	bool bDiscards = false;
	FVector2f Interpolant = FVector2f(0, 0);
};

class DispatchReuse : public testing::Test
{
protected:
	DispatchReuse() { GNumTexels = 0; }

	static FBoundShader Bind(const FPass& Pass, EShaderStage Stage, FKernelFunction Kernel)
	{
		FBoundShader Shader = MakeShader(Stage, Kernel, FIntVector(8, 8, 1));
		FShaderReflection Reflection = Shader.GetReflection();
		Reflection.StaticSamples = -1;
		Reflection.bUsesDiscard = Pass.bDiscards;
		Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		Shader.Key = Pass.Key.empty() ? "" : Pass.Key + (Kernel == &AddToSome ? " in place" : "");
		Shader.ConstantData.push_back(std::vector<uint8>(sizeof(float)));
		std::memcpy(Shader.ConstantData[0].data(), &Pass.Constant, sizeof(float));
		Shader.ConstantBuffers.push_back(Shader.ConstantData[0].data());
		Shader.Samplers.push_back(Pass.Sampler);
		if (Pass.Input)
		{
			Shader.Textures.push_back(Pass.Input->GetKernelView());
			Shader.TextureOwners.push_back(Pass.Input);
		}
		return Shader;
	}

	void Dispatch(const FPass& Pass, FRHITexture& Out, FKernelFunction Kernel = &Store, int32 Mip = 0)
	{
		FBoundShader Shader = Bind(Pass, EShaderStage::Compute, Kernel);
		Shader.RWTextures.push_back(Out.GetKernelView(Mip, 1));
		Shader.RWTextureOwners.push_back(&Out);
		RHICmdList.SetBoundComputeShader(std::move(Shader));
		RHICmdList.DispatchComputeShader(5, 3, 1);
	}

	void Draw(const FPass& Pass, FRHITexture& Out)
	{
		RHICmdList.BeginRenderPass(FRHIRenderPassInfo(&Out, ERenderTargetActions::Load_Store), TEXT("Test"));
		FGraphicsPipelineStateInitializer Initializer;
		RHICmdList.ApplyCachedRenderTargets(Initializer);
		Initializer.BlendState =
			Pass.bBlend ? TStaticBlendState<CW_RGBA, BO_Add, BF_One, BF_One>::GetRHI() : TStaticBlendState<>::GetRHI();
		SetGraphicsPipelineState(RHICmdList, Initializer, 0);
		RHICmdList.SetBoundPixelShader(Bind(Pass, EShaderStage::Pixel, &DrawSum));
		const FKernelInterpolant In = {{Pass.Interpolant.X, 0, 0, 0}, {}, {}};
		RHICmdList.SetInterpolants(MakeArrayView(&In, 1));
		RHICmdList.SetScissorRect(
			true, uint32(Pass.Rect.Min.X), uint32(Pass.Rect.Min.Y), uint32(Pass.Rect.Max.X), uint32(Pass.Rect.Max.Y));
		RHICmdList.DrawPrimitive(0, 1, 1);
		RHICmdList.EndRenderPass();
	}

	/** Whether a frame of these actions computes something. */
	bool Runs(const std::function<void()>& Frame)
	{
		Cache.BeginFrame();
		const FScopedReuse Scope(&Cache);
		const int32 Before = GNumTexels;
		Frame();
		return GNumTexels != Before;
	}

	static std::vector<float> Read(FRHITexture& Texture, int32 Mip = 0)
	{
		std::vector<float> Values;
		const FIntVector Size = Texture.GetMipDimensions(uint8(Mip));
		for (int32 Index = 0; Index < Size.X * Size.Y; ++Index)
		{
			Values.push_back(Texture.ReadTexel(Index % Size.X, Index / Size.X, Mip).R);
		}
		return Values;
	}

	const FTextureRHIRef In = MakeTexture(FIntPoint(40, 24), PF_R32_FLOAT);
	const FTextureRHIRef Out = MakeTexture(FIntPoint(40, 24), PF_R32_FLOAT);
	FReuseCache Cache;
	FRHICommandListImmediate RHICmdList;
};

} // namespace Drydock::Tests
