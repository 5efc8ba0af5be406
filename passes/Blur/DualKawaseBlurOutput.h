// Creates the target of a blur's last pass. Internal to the files of the compute blurs.
#pragma once

#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

namespace Drydock
{

/** Extent and format of the input, as a compute shader's output. */
inline FRDGTextureRef CreateBlurTexture(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, FIntPoint Extent, const TCHAR* Name)
{
	FRDGTextureDesc Desc = Input.Texture->Desc;
	Desc.Reset();
	Desc.Extent = Extent;
	Desc.NumMips = 1;
	Desc.Flags = TexCreate_ShaderResource | TexCreate_UAV;
	return GraphBuilder.CreateTexture(Desc, Name);
}

/** A compute shader can write it, and need not clear it first. */
inline bool IsWritableByCompute(const FScreenPassRenderTarget& Output)
{
	return EnumHasAnyFlags(Output.Texture->Desc.Flags, TexCreate_UAV) &&
		   Output.LoadAction != ERenderTargetLoadAction::EClear;
}

/** OverrideOutput where compute can write it, else a new texture with the input's extent and rect. */
inline FScreenPassTexture ChooseBlurOutput(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input,
	const FScreenPassRenderTarget& OverrideOutput, const TCHAR* Name)
{
	if (OverrideOutput.IsValid() && IsWritableByCompute(OverrideOutput))
	{
		return OverrideOutput;
	}
	return FScreenPassTexture(CreateBlurTexture(GraphBuilder, Input, Input.Texture->Desc.Extent, Name), Input.ViewRect);
}

/** Draws the result to OverrideOutput unless it is there. */
inline FScreenPassTexture FinishBlurOutput(FRDGBuilder& GraphBuilder, const FScreenPassViewInfo& View,
	const FScreenPassTexture& Result, const FScreenPassRenderTarget& OverrideOutput)
{
	if (!OverrideOutput.IsValid() || Result.Texture == OverrideOutput.Texture)
	{
		return Result;
	}
	AddDrawTexturePass(GraphBuilder, View, Result, OverrideOutput);
	return OverrideOutput;
}

} // namespace Drydock
