// Screen passes: textures with the rectangle that counts, what shaders need to know of it, and the helpers that draw
// over it. Source: engine ScreenPass.h. A little past 500 lines: plugins include these names by this one header.
#pragma once

#include "CoreMinimal.h"
#include "GlobalShader.h"
#include "Misc/EngineApi.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RendererInterface.h"
#include "ScreenTransform.h"
#include "ShaderParameterStruct.h"

class FSceneView;
class FViewInfo; // the renderer's, which the engine's plugins know by this declaration; SceneRendering.h
struct FScreenPassTextureSlice;

/** A texture and the rectangle of it, in texels, that holds the picture. */
struct DRYDOCK_API FScreenPassTexture
{
	FScreenPassTexture() = default;
	explicit FScreenPassTexture(FRDGTextureRef InTexture);
	FScreenPassTexture(FRDGTextureRef InTexture, FIntRect InViewRect)
		: Texture(InTexture)
		, ViewRect(InViewRect)
	{
	}
	/** The slice's texture; the slice must be the whole texture. */
	explicit FScreenPassTexture(const FScreenPassTextureSlice& Slice);

	/** The slice as a texture of its own: copied when it is one layer of an array, else as it is. */
	DRYDOCK_API_CopyFromSlice static FScreenPassTexture CopyFromSlice(
		FRDGBuilder& GraphBuilder, const FScreenPassTextureSlice& Slice);
	/** The same, drawn into OverrideOutput over its rectangle and returned as that, if it is valid. */
	DRYDOCK_API_CopyFromSliceOverride static FScreenPassTexture CopyFromSlice(
		FRDGBuilder& GraphBuilder, const FScreenPassTextureSlice& Slice, FScreenPassTexture OverrideOutput);

	bool IsValid() const { return Texture != nullptr && ViewRect.Width() > 0 && ViewRect.Height() > 0; }

	/** For the engine's texture viewer, which drydock does not have: a dump shows the whole texture. */
	void UpdateVisualizeTextureExtent() const {}

	bool operator==(const FScreenPassTexture&) const = default;

	FRDGTextureRef Texture = nullptr;
	FIntRect ViewRect;
};

/** A view of a texture (one layer of an array, or all of a plain one) and its rectangle. */
struct DRYDOCK_API FScreenPassTextureSlice
{
	FScreenPassTextureSlice() = default;
	FScreenPassTextureSlice(FRDGTextureSRVRef InTextureSRV, FIntRect InViewRect)
		: TextureSRV(InTextureSRV)
		, ViewRect(InViewRect)
	{
	}

	static FScreenPassTextureSlice CreateFromScreenPassTexture(
		FRDGBuilder& GraphBuilder, const FScreenPassTexture& ScreenTexture);

	bool IsValid() const { return TextureSRV != nullptr && ViewRect.Width() > 0 && ViewRect.Height() > 0; }

	bool operator==(const FScreenPassTextureSlice&) const = default;

	FRDGTextureSRVRef TextureSRV = nullptr;
	FIntRect ViewRect;
};

namespace Drydock
{

/** FScreenPassTexture::CopyFromSlice for headers of drydock, which compile for any version. */
DRYDOCK_API FScreenPassTexture CopyFromSlice(FRDGBuilder& GraphBuilder, const FScreenPassTextureSlice& Slice);

/** A picture that code gets or gives: a texture as up to engine 5.3, and a slice (view and rect) as from 5.4. It
 * converts from either and to either. */
struct FScreenPassInput : public FScreenPassTexture
{
	FScreenPassInput() = default;
	FScreenPassInput(const FScreenPassTexture& InTexture)
		: FScreenPassTexture(InTexture)
	{
	}
	FScreenPassInput(const FScreenPassTextureSlice& Slice)
		: FScreenPassTexture(Slice.TextureSRV ? Slice.TextureSRV->Desc.Texture : nullptr, Slice.ViewRect)
		, TextureSRV(Slice.TextureSRV)
	{
	}
	FScreenPassInput(const FScreenPassTexture& InTexture, FRDGTextureSRVRef InTextureSRV)
		: FScreenPassTexture(InTexture)
		, TextureSRV(InTextureSRV)
	{
	}

	operator FScreenPassTextureSlice() const
	{
		checkf(TextureSRV != nullptr || Texture == nullptr,
			TEXT("This input was set without a graph builder: read it as a FScreenPassTexture"));
		return FScreenPassTextureSlice(TextureSRV, ViewRect);
	}

	FRDGTextureSRVRef TextureSRV = nullptr;
};

} // namespace Drydock

/** A texture to draw to, and what happens to its contents first. */
struct DRYDOCK_API FScreenPassRenderTarget : public FScreenPassTexture
{
	FScreenPassRenderTarget() = default;
	FScreenPassRenderTarget(FRDGTextureRef InTexture, ERenderTargetLoadAction InLoadAction)
		: FScreenPassTexture(InTexture)
		, LoadAction(InLoadAction)
	{
	}
	FScreenPassRenderTarget(FRDGTextureRef InTexture, FIntRect InViewRect, ERenderTargetLoadAction InLoadAction)
		: FScreenPassTexture(InTexture, InViewRect)
		, LoadAction(InLoadAction)
	{
	}
	FScreenPassRenderTarget(FScreenPassTexture InTexture, ERenderTargetLoadAction InLoadAction)
		: FScreenPassTexture(InTexture)
		, LoadAction(InLoadAction)
	{
	}

	/** A new target of the input's extent, format and rectangle. */
	static FScreenPassRenderTarget CreateFromInput(FRDGBuilder& GraphBuilder, FScreenPassTexture Input,
		ERenderTargetLoadAction OutputLoadAction, const TCHAR* OutputName);

	/** The family's output as one view draws to it: loaded when another view was first, cleared when the view's
	 * rectangle does not cover it, else left as it is. */
	static FScreenPassRenderTarget CreateViewFamilyOutput(
		FRDGTextureRef ViewFamilyTexture, FIntRect ViewRect, bool bIsFirstView);

	/** The engine's form. View is a FViewInfo, which this storey does not know. */
	template<typename ViewType>
	static FScreenPassRenderTarget CreateViewFamilyOutput(FRDGTextureRef ViewFamilyTexture, const ViewType& View)
	{
		return CreateViewFamilyOutput(
			ViewFamilyTexture, View.UnscaledViewRect, View.GetOverwriteLoadAction() != ERenderTargetLoadAction::ELoad);
	}

	FRenderTargetBinding GetRenderTargetBinding() const { return FRenderTargetBinding(Texture, LoadAction); }

	bool operator==(const FScreenPassRenderTarget&) const = default;

	ERenderTargetLoadAction LoadAction = ERenderTargetLoadAction::ENoAction;
};

/** Extent of a texture and the rectangle that counts, without the texture. */
struct DRYDOCK_API FScreenPassTextureViewport
{
	FScreenPassTextureViewport() = default;
	explicit FScreenPassTextureViewport(FIntRect InRect)
		: Extent(InRect.Max)
		, Rect(InRect)
	{
	}
	explicit FScreenPassTextureViewport(FIntPoint InExtent)
		: Extent(InExtent)
		, Rect(FIntPoint::ZeroValue, InExtent)
	{
	}
	FScreenPassTextureViewport(FIntPoint InExtent, FIntRect InRect)
		: Extent(InExtent)
		, Rect(InRect)
	{
	}
	FScreenPassTextureViewport(FRDGTextureRef InTexture, FIntRect InRect);
	explicit FScreenPassTextureViewport(FRDGTextureRef InTexture);
	explicit FScreenPassTextureViewport(const FScreenPassTexture& InTexture);
	explicit FScreenPassTextureViewport(const FScreenPassTextureSlice& InSlice);

	bool IsEmpty() const { return Extent.X <= 0 || Extent.Y <= 0 || Rect.Width() <= 0 || Rect.Height() <= 0; }
	/** The rectangle is all of the texture. */
	bool IsFullscreen() const { return Rect.Min == FIntPoint::ZeroValue && Rect.Max == Extent; }

	/** Size of the rectangle in shares of the extent. */
	FVector2D GetRectToExtentRatio() const
	{
		return FVector2D(static_cast<double>(static_cast<float>(Rect.Width()) / static_cast<float>(Extent.X)),
			static_cast<double>(static_cast<float>(Rect.Height()) / static_cast<float>(Extent.Y)));
	}

	bool operator==(const FScreenPassTextureViewport&) const = default;

	FIntPoint Extent = FIntPoint(0, 0);
	FIntRect Rect;
};

/** Extent rounded up; Rect.Min rounded towards zero, Rect.Max up; at least one texel. */
DRYDOCK_API FIntPoint GetDownscaledExtent(FIntPoint Extent, FIntPoint Divisor);
DRYDOCK_API FIntRect GetDownscaledRect(FIntRect Rect, FIntPoint Divisor);
DRYDOCK_API FScreenPassTextureViewport GetDownscaledViewport(FScreenPassTextureViewport Viewport, FIntPoint Divisor);

/** Everything a shader asks of a viewport; `SCREEN_PASS_TEXTURE_VIEWPORT(Name)` declares it in HLSL. All zero when the
 *  viewport is empty. Sizes in texels, UV relative to the extent. */
BEGIN_SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, DRYDOCK_API)
	SHADER_PARAMETER(FVector2f, Extent)
	SHADER_PARAMETER(FVector2f, ExtentInverse)
	SHADER_PARAMETER(FVector2f, ScreenPosToViewportScale)
	SHADER_PARAMETER(FVector2f, ScreenPosToViewportBias)
	SHADER_PARAMETER(FIntPoint, ViewportMin)
	SHADER_PARAMETER(FIntPoint, ViewportMax)
	SHADER_PARAMETER(FVector2f, ViewportSize)
	SHADER_PARAMETER(FVector2f, ViewportSizeInverse)
	SHADER_PARAMETER(FVector2f, UVViewportMin)
	SHADER_PARAMETER(FVector2f, UVViewportMax)
	SHADER_PARAMETER(FVector2f, UVViewportSize)
	SHADER_PARAMETER(FVector2f, UVViewportSizeInverse)
	SHADER_PARAMETER(FVector2f, UVViewportBilinearMin)
	SHADER_PARAMETER(FVector2f, UVViewportBilinearMax)
END_SHADER_PARAMETER_STRUCT()

DRYDOCK_API FScreenPassTextureViewportParameters GetScreenPassTextureViewportParameters(
	const FScreenPassTextureViewport& InViewport);

/** A texture, its viewport and the sampler to read it with: `Name_Texture`, `Name_Sampler`, `Name_Extent`, ... in HLSL.
 */
BEGIN_SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, DRYDOCK_API)
	SHADER_PARAMETER_STRUCT_INCLUDE(FScreenPassTextureViewportParameters, Viewport)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Texture)
	SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FScreenPassTextureSliceInput, DRYDOCK_API)
	SHADER_PARAMETER_STRUCT_INCLUDE(FScreenPassTextureViewportParameters, Viewport)
	SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D, Texture)
	SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
END_SHADER_PARAMETER_STRUCT()

DRYDOCK_API FScreenPassTextureInput GetScreenPassTextureInput(
	FScreenPassTexture TexturePair, FRHISamplerState* Sampler);
DRYDOCK_API FScreenPassTextureSliceInput GetScreenPassTextureInput(
	FScreenPassTextureSlice TextureSlice, FRHISamplerState* Sampler);

/** UV of one viewport to UV of another: UV * Scale + Bias. */
BEGIN_SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportTransform, DRYDOCK_API)
	SHADER_PARAMETER(FVector2f, Scale)
	SHADER_PARAMETER(FVector2f, Bias)
END_SHADER_PARAMETER_STRUCT()

DRYDOCK_API FScreenPassTextureViewportTransform GetScreenPassTextureViewportTransform(const FVector2f& SourceOffset,
	const FVector2f& SourceExtent, const FVector2f& DestinationOffset, const FVector2f& DestinationExtent);
DRYDOCK_API FScreenPassTextureViewportTransform GetScreenPassTextureViewportTransform(
	const FScreenPassTextureViewportParameters& Source, const FScreenPassTextureViewportParameters& Destination);

/** The parameter type for a screen pass's view: a CPU needs nothing of it, so anything view-like converts to it. */
struct FScreenPassViewInfo
{
	FScreenPassViewInfo() = default;
	FScreenPassViewInfo(ERHIFeatureLevel::Type InFeatureLevel)
		: FeatureLevel(InFeatureLevel)
	{
	}
	FScreenPassViewInfo(const FSceneView&) {}

	const ERHIFeatureLevel::Type FeatureLevel = GMaxRHIFeatureLevel;
	bool bIsStereo = false;
};

enum class EScreenPassDrawFlags : uint8
{
	None,
	AllowHMDHiddenAreaMask = 0x1,
};
ENUM_CLASS_FLAGS(EScreenPassDrawFlags)

/** The values that the engine's DrawRectangle gives Common.ush's DrawRectangle: the rectangle in pixels of the
 * viewport, and the UV rectangle in texels, each as scale (x, y) and bias (z, w) of the unit square. */
BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FDrawRectangleParameters, DRYDOCK_API)
	SHADER_PARAMETER(FVector4f, PosScaleBias)
	SHADER_PARAMETER(FVector4f, UVScaleBias)
	SHADER_PARAMETER(FVector4f, InvTargetSizeAndTextureSize)
END_GLOBAL_SHADER_PARAMETER_STRUCT()

/** The engine's vertex shader of screen passes: passes on UV and screen position in TEXCOORD0. Draws know what it gives
 * without running it. */
class DRYDOCK_API FScreenPassVS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FScreenPassVS);
	SHADER_USE_PARAMETER_STRUCT(FScreenPassVS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
	END_SHADER_PARAMETER_STRUCT()
};

using FScreenVS = FScreenPassVS;

namespace Drydock
{

template<>
inline constexpr bool TIsScreenRectangle<FScreenPassVS> = true;

} // namespace Drydock

/** Copies a rectangle texel by texel (point sampling where sizes differ). */
class DRYDOCK_API FCopyRectPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FCopyRectPS);
	SHADER_USE_PARAMETER_STRUCT(FCopyRectPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

/** Shaders and states of a screen pass. Null states are the engine's defaults: opaque, no depth. */
struct FScreenPassPipelineState
{
	using FDefaultBlendState = TStaticBlendState<>;
	using FDefaultDepthStencilState = TStaticDepthStencilState<false, CF_Always>;

	FScreenPassPipelineState() = default;
	template<typename TVertexShader, typename TPixelShader>
	FScreenPassPipelineState(const TShaderRef<TVertexShader>& InVertexShader,
		const TShaderRef<TPixelShader>& InPixelShader, FRHIBlendState* InBlendState = FDefaultBlendState::GetRHI(),
		FRHIDepthStencilState* InDepthStencilState = FDefaultDepthStencilState::GetRHI(), uint8 InStencilRef = 0)
		: VertexShader(InVertexShader)
		, PixelShader(InPixelShader)
		, BlendState(InBlendState)
		, DepthStencilState(InDepthStencilState)
		, StencilRef(InStencilRef)
	{
	}

	/** A check where a shader is missing. */
	void Validate() const { check(VertexShader.IsValid() && PixelShader.IsValid()); }

	TShaderRef<FShader> VertexShader;
	TShaderRef<FShader> PixelShader;
	FRHIBlendState* BlendState = nullptr;
	FRHIDepthStencilState* DepthStencilState = nullptr;
	uint8 StencilRef = 0;
};

/** Inside a raster lambda: states of the draws that follow. */
DRYDOCK_API void SetScreenPassPipelineState(
	FRHICommandList& RHICmdList, const FScreenPassPipelineState& ScreenPassDraw);

namespace Drydock
{

/** Inside a raster lambda: draws OutputViewport by the state's vertex shader, or without one so that TEXCOORD0 is (u,
 * v, screen x, screen y); u, v run over the input's rectangle relative to its extent. */
DRYDOCK_API void DrawScreenPassRectangle(FRHICommandList& RHICmdList, const FScreenPassTextureViewport& OutputViewport,
	const FScreenPassTextureViewport& InputViewport);

/** Adds the raster pass of AddDrawScreenPass: Parameters are those of the state's pixel shader. */
DRYDOCK_API FRDGPassRef AddScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const FScreenPassPipelineState& PipelineState, const FShaderParametersMetadata* ParametersMetadata,
	const void* Parameters, const Drydock::FSourceLocation& Location);

} // namespace Drydock

/** Inside a raster lambda: draws a rectangle of the viewport with UVs of a rectangle of the texture. The rectangle
 * covers X..X+SizeX of a target of TargetSize; the UV rectangle is U..U+SizeU of a texture of TextureSize. A vertex
 * shader of a plugin's own is run, with FDrawRectangleParameters, and places the rectangle in the viewport. */
DRYDOCK_API void DrawRectangle(FRHICommandList& RHICmdList, float X, float Y, float SizeX, float SizeY, float U,
	float V, float SizeU, float SizeV, FIntPoint TargetSize, FIntPoint TextureSize,
	const TShaderRef<FShader>& VertexShader = {}, EDrawRectangleFlags = EDRF_Default);

/** Inside a raster lambda: a whole screen pass; SetupFunction(RHICmdList) binds parameters after the states are set. */
template<typename TSetupFunction>
void DrawScreenPass(FRHICommandList& RHICmdList, const FScreenPassViewInfo&,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const FScreenPassPipelineState& PipelineState, EScreenPassDrawFlags, TSetupFunction SetupFunction)
{
	SetScreenPassPipelineState(RHICmdList, PipelineState);
	SetupFunction(RHICmdList);
	Drydock::DrawScreenPassRectangle(RHICmdList, OutputViewport, InputViewport);
}

template<typename TSetupFunction>
void DrawScreenPass(FRHICommandList& RHICmdList, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const FScreenPassPipelineState& PipelineState, TSetupFunction SetupFunction)
{
	DrawScreenPass(
		RHICmdList, ViewInfo, OutputViewport, InputViewport, PipelineState, EScreenPassDrawFlags::None, SetupFunction);
}

/** Draws the pixel shader over OutputViewport's rectangle; it finds the UV of InputViewport in TEXCOORD0. Members of
 * PixelShaderParameters that the shader does not read are dropped before the pass is added. */
template<typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo&,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const FScreenPassPipelineState& PipelineState, const TShaderRef<TPixelShader>& PixelShader,
	typename TPixelShader::FParameters* PixelShaderParameters, EScreenPassDrawFlags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	Drydock::CheckPassArguments(
		"AddDrawScreenPass", PassName, TShaderRef<FShader>(PixelShader), PixelShaderParameters, Location);
	ClearUnusedGraphResources(PixelShader, PixelShaderParameters);
	return Drydock::AddScreenPass(GraphBuilder, MoveTemp(PassName), OutputViewport, InputViewport, PipelineState,
		TPixelShader::FParameters::FTypeInfo::GetStructMetadata(), PixelShaderParameters, Location);
}

template<typename TVertexShader, typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const TShaderRef<TVertexShader>& VertexShader, const TShaderRef<TPixelShader>& PixelShader,
	FRHIBlendState* BlendState, FRHIDepthStencilState* DepthStencilState,
	typename TPixelShader::FParameters* PixelShaderParameters, EScreenPassDrawFlags Flags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport,
		FScreenPassPipelineState(VertexShader, PixelShader, BlendState, DepthStencilState), PixelShader,
		PixelShaderParameters, Flags, Location);
}

template<typename TVertexShader, typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const TShaderRef<TVertexShader>& VertexShader, const TShaderRef<TPixelShader>& PixelShader,
	FRHIBlendState* BlendState, typename TPixelShader::FParameters* PixelShaderParameters,
	EScreenPassDrawFlags Flags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport,
		FScreenPassPipelineState(VertexShader, PixelShader, BlendState), PixelShader, PixelShaderParameters, Flags,
		Location);
}

template<typename TVertexShader, typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const TShaderRef<TVertexShader>& VertexShader, const TShaderRef<TPixelShader>& PixelShader,
	typename TPixelShader::FParameters* PixelShaderParameters, EScreenPassDrawFlags Flags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport,
		FScreenPassPipelineState(VertexShader, PixelShader), PixelShader, PixelShaderParameters, Flags, Location);
}

template<typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const TShaderRef<TPixelShader>& PixelShader, FRHIBlendState* BlendState, FRHIDepthStencilState* DepthStencilState,
	typename TPixelShader::FParameters* PixelShaderParameters, EScreenPassDrawFlags Flags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport,
		FScreenPassPipelineState(TShaderRef<FShader>(), PixelShader, BlendState, DepthStencilState), PixelShader,
		PixelShaderParameters, Flags, Location);
}

template<typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const TShaderRef<TPixelShader>& PixelShader, FRHIBlendState* BlendState,
	typename TPixelShader::FParameters* PixelShaderParameters, EScreenPassDrawFlags Flags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport,
		FScreenPassPipelineState(TShaderRef<FShader>(), PixelShader, BlendState), PixelShader, PixelShaderParameters,
		Flags, Location);
}

template<typename TPixelShader>
FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const TShaderRef<TPixelShader>& PixelShader, typename TPixelShader::FParameters* PixelShaderParameters,
	EScreenPassDrawFlags Flags = EScreenPassDrawFlags::None,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport,
		FScreenPassPipelineState(TShaderRef<FShader>(), PixelShader), PixelShader, PixelShaderParameters, Flags,
		Location);
}

/** The same with the binding left to the caller: SetupFunction(FRHICommandList&) runs in the pass, after the states are
 * set. PassParameters hold the render targets. */
template<typename TPassParameters, typename TSetupFunction>
requires std::is_invocable_v<TSetupFunction&, FRHICommandList&> FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder,
	FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo, const FScreenPassTextureViewport& OutputViewport,
	const FScreenPassTextureViewport& InputViewport, const FScreenPassPipelineState& PipelineState,
	TPassParameters* PassParameters, EScreenPassDrawFlags Flags, TSetupFunction SetupFunction,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	Drydock::CheckPassArguments("AddDrawScreenPass", PassName, PipelineState.PixelShader, PassParameters, Location);
	FRDGPassRef Pass = GraphBuilder.AddPass(
		MoveTemp(PassName), PassParameters, ERDGPassFlags::Raster,
		[ViewInfo, OutputViewport, InputViewport, PipelineState, Flags, SetupFunction](FRHICommandList& RHICmdList)
		{ DrawScreenPass(RHICmdList, ViewInfo, OutputViewport, InputViewport, PipelineState, Flags, SetupFunction); },
		Location);
	Drydock::AnnotatePass(Pass, PipelineState.PixelShader, PipelineState.VertexShader);
	Pass->SetArea(OutputViewport.Rect.Size());
	return Pass;
}

template<typename TPassParameters, typename TSetupFunction>
requires std::is_invocable_v<TSetupFunction&, FRHICommandList&> FRDGPassRef AddDrawScreenPass(FRDGBuilder& GraphBuilder,
	FRDGEventName&& PassName, const FScreenPassViewInfo& ViewInfo, const FScreenPassTextureViewport& OutputViewport,
	const FScreenPassTextureViewport& InputViewport, const FScreenPassPipelineState& PipelineState,
	TPassParameters* PassParameters, TSetupFunction SetupFunction,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return AddDrawScreenPass(GraphBuilder, MoveTemp(PassName), ViewInfo, OutputViewport, InputViewport, PipelineState,
		PassParameters, EScreenPassDrawFlags::None, SetupFunction, Location);
}

/** Copies a region: as memory where the formats agree, else through FCopyRectPS. Size 0: from the positions to the
 * edges. */
DRYDOCK_API void AddDrawTexturePass(FRDGBuilder& GraphBuilder, const FScreenPassViewInfo& ViewInfo,
	FRDGTextureRef InputTexture, FRDGTextureRef OutputTexture, FIntPoint InputPosition = FIntPoint::ZeroValue,
	FIntPoint OutputPosition = FIntPoint::ZeroValue, FIntPoint Size = FIntPoint::ZeroValue);

/** Copies the input's rectangle to the output's, by memory where sizes and formats agree, else drawn with point
 * sampling. */
DRYDOCK_API void AddDrawTexturePass(FRDGBuilder& GraphBuilder, const FScreenPassViewInfo& ViewInfo,
	FScreenPassTexture Input, FScreenPassRenderTarget Output);
