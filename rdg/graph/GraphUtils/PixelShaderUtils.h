// Full-screen pixel-shader passes. Source: engine PixelShaderUtils.h.
#pragma once

#include "CommonRenderResources.h"
#include "ScreenPass.h"

struct DRYDOCK_API FPixelShaderUtils
{
	/** Inside a raster lambda: draws the triangle of GScreenRectangleVertexBuffer that covers the viewport. */
	static void DrawFullscreenTriangle(FRHICommandList& RHICmdList, uint32 InstanceCount = 1)
	{
		RHICmdList.SetStreamSource(0, GScreenRectangleVertexBuffer.VertexBufferRHI, 0);
		RHICmdList.DrawIndexedPrimitive(GScreenRectangleIndexBuffer.IndexBufferRHI, 0, 0, 3, 6, 1, InstanceCount);
	}
	/** The same by the rectangle's two triangles. */
	static void DrawFullscreenQuad(FRHICommandList& RHICmdList, uint32 InstanceCount = 1)
	{
		RHICmdList.SetStreamSource(0, GScreenRectangleVertexBuffer.VertexBufferRHI, 0);
		RHICmdList.DrawIndexedPrimitive(GScreenRectangleIndexBuffer.IndexBufferRHI, 0, 0, 4, 0, 2, InstanceCount);
	}

	/** Inside a raster lambda: fills the states of a full-screen draw, no blending and no depth test. */
	static void InitFullscreenPipelineState(FRHICommandList& RHICmdList, const FGlobalShaderMap*,
		const TShaderRef<FShader>& PixelShader, FGraphicsPipelineStateInitializer& GraphicsPSOInit)
	{
		RHICmdList.ApplyCachedRenderTargets(GraphicsPSOInit);
		GraphicsPSOInit.BlendState = TStaticBlendState<>::GetRHI();
		GraphicsPSOInit.RasterizerState = TStaticRasterizerState<>::GetRHI();
		GraphicsPSOInit.DepthStencilState = TStaticDepthStencilState<false, CF_Always>::GetRHI();
		GraphicsPSOInit.BoundShaderState.VertexDeclarationRHI = GFilterVertexDeclaration.VertexDeclarationRHI;
		GraphicsPSOInit.BoundShaderState.PixelShaderRHI = PixelShader.GetPixelShader();
		GraphicsPSOInit.PrimitiveType = PT_TriangleList;
	}

	/** Inside a raster lambda: states, parameters and draw of a full-screen pass. */
	template<typename TShaderClass>
	static void DrawFullscreenPixelShader(FRHICommandList& RHICmdList, const FGlobalShaderMap*,
		const TShaderRef<TShaderClass>& PixelShader, const typename TShaderClass::FParameters& Parameters,
		const FIntRect& Viewport, FRHIBlendState* BlendState = nullptr, FRHIRasterizerState* = nullptr,
		FRHIDepthStencilState* DepthStencilState = nullptr, uint32 StencilRef = 0)
	{
		FScreenPassPipelineState State(TShaderRef<FShader>(), PixelShader);
		State.BlendState = BlendState ? BlendState : State.BlendState;
		State.DepthStencilState = DepthStencilState ? DepthStencilState : State.DepthStencilState;
		State.StencilRef = static_cast<uint8>(StencilRef);
		SetScreenPassPipelineState(RHICmdList, State);
		RHICmdList.SetViewport(static_cast<float>(Viewport.Min.X), static_cast<float>(Viewport.Min.Y), 0.0f,
			static_cast<float>(Viewport.Max.X), static_cast<float>(Viewport.Max.Y), 1.0f);
		SetShaderParameters(RHICmdList, PixelShader, PixelShader.GetPixelShader(), Parameters);
		DrawFullscreenTriangle(RHICmdList);
	}

	/** Adds a raster pass that runs the pixel shader over Viewport of its render targets. The shader receives
	 * SV_POSITION only. Members of Parameters that it does not read are dropped before the pass is added. */
	template<typename TShaderClass>
	static FRDGPassRef AddFullscreenPass(FRDGBuilder& GraphBuilder, const FGlobalShaderMap*, FRDGEventName&& PassName,
		const TShaderRef<TShaderClass>& PixelShader, typename TShaderClass::FParameters* Parameters,
		const FIntRect& Viewport, FRHIBlendState* BlendState = nullptr, FRHIRasterizerState* = nullptr,
		FRHIDepthStencilState* DepthStencilState = nullptr, uint32 StencilRef = 0,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		Drydock::CheckPassArguments(
			"FPixelShaderUtils::AddFullscreenPass", PassName, TShaderRef<FShader>(PixelShader), Parameters, Location);
		ClearUnusedGraphResources(PixelShader, Parameters);
		FScreenPassPipelineState State(TShaderRef<FShader>(), PixelShader);
		State.BlendState = BlendState ? BlendState : State.BlendState;
		State.DepthStencilState = DepthStencilState ? DepthStencilState : State.DepthStencilState;
		State.StencilRef = static_cast<uint8>(StencilRef);
		const FScreenPassTextureViewport ScreenViewport(Viewport);
		return Drydock::AddScreenPass(GraphBuilder, MoveTemp(PassName), ScreenViewport, ScreenViewport, State,
			TShaderClass::FParameters::FTypeInfo::GetStructMetadata(), Parameters, Location);
	}
};
