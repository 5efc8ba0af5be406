// States named by their template arguments and made once. Note the engine's defaults: a sampler is point and clamp
// (while FSamplerStateInitializerRHI wraps), a depth-stencil state tests and writes. Source: engine RHIStaticStates.h.
#pragma once

#include "RHIStates.h"

namespace Drydock
{

/** Makes TState's resource on first use and keeps it. */
template<typename TState, typename TRef, typename TResource>
class TStaticState
{
public:
	static TResource* GetRHI()
	{
		static const TRef Resource = TState::CreateRHI();
		return Resource.GetReference();
	}
};

} // namespace Drydock

template<ESamplerFilter Filter = SF_Point, ESamplerAddressMode AddressU = AM_Clamp,
	ESamplerAddressMode AddressV = AM_Clamp, ESamplerAddressMode AddressW = AM_Clamp, int32 MipBias = 0,
	int32 MaxAnisotropy = 1, uint32 BorderColor = 0, ESamplerCompareFunction SamplerComparisonFunction = SCF_Never>
class TStaticSamplerState
	: public Drydock::TStaticState<TStaticSamplerState<Filter, AddressU, AddressV, AddressW, MipBias, MaxAnisotropy,
									   BorderColor, SamplerComparisonFunction>,
		  FSamplerStateRHIRef, FRHISamplerState>
{
public:
	static FSamplerStateRHIRef CreateRHI()
	{
		return RHICreateSamplerState(FSamplerStateInitializerRHI(Filter, AddressU, AddressV, AddressW, float(MipBias),
			MaxAnisotropy, 0.0f, 1000.0f, BorderColor, SamplerComparisonFunction));
	}
};

template<ERasterizerFillMode FillMode = FM_Solid, ERasterizerCullMode CullMode = CM_None, bool bEnableLineAA = false,
	bool bEnableMSAA = true, ERasterizerDepthClipMode DepthClipMode = ERasterizerDepthClipMode::DepthClip>
class TStaticRasterizerState
	: public Drydock::TStaticState<
		  TStaticRasterizerState<FillMode, CullMode, bEnableLineAA, bEnableMSAA, DepthClipMode>, FRasterizerStateRHIRef,
		  FRHIRasterizerState>
{
public:
	static FRasterizerStateRHIRef CreateRHI()
	{
		FRasterizerStateInitializerRHI Initializer;
		Initializer.FillMode = FillMode;
		Initializer.CullMode = CullMode;
		Initializer.DepthClipMode = DepthClipMode;
		Initializer.bAllowMSAA = bEnableMSAA;
		Initializer.bEnableLineAA = bEnableLineAA;
		return RHICreateRasterizerState(Initializer);
	}
};

/** The static state of modes that are known only when it runs. */
template<bool bEnableMSAA>
FRHIRasterizerState* GetStaticRasterizerState(ERasterizerFillMode FillMode, ERasterizerCullMode CullMode)
{
	const auto Choose = [CullMode]<ERasterizerFillMode Fill>() -> FRHIRasterizerState*
	{
		return CullMode == CM_CW    ? TStaticRasterizerState<Fill, CM_CW, false, bEnableMSAA>::GetRHI()
			   : CullMode == CM_CCW ? TStaticRasterizerState<Fill, CM_CCW, false, bEnableMSAA>::GetRHI()
									: TStaticRasterizerState<Fill, CM_None, false, bEnableMSAA>::GetRHI();
	};
	return FillMode == FM_Wireframe ? Choose.template operator()<FM_Wireframe>()
		   : FillMode == FM_Point   ? Choose.template operator()<FM_Point>()
									: Choose.template operator()<FM_Solid>();
}

template<bool bEnableDepthWrite = true, ECompareFunction DepthTest = CF_DepthNearOrEqual,
	bool bEnableFrontFaceStencil = false, ECompareFunction FrontFaceStencilTest = CF_Always,
	EStencilOp FrontFaceStencilFailStencilOp = SO_Keep, EStencilOp FrontFaceDepthFailStencilOp = SO_Keep,
	EStencilOp FrontFacePassStencilOp = SO_Keep, bool bEnableBackFaceStencil = false,
	ECompareFunction BackFaceStencilTest = CF_Always, EStencilOp BackFaceStencilFailStencilOp = SO_Keep,
	EStencilOp BackFaceDepthFailStencilOp = SO_Keep, EStencilOp BackFacePassStencilOp = SO_Keep,
	uint8 StencilReadMask = 0xff, uint8 StencilWriteMask = 0xff>
class TStaticDepthStencilState
	: public Drydock::TStaticState<
		  TStaticDepthStencilState<bEnableDepthWrite, DepthTest, bEnableFrontFaceStencil, FrontFaceStencilTest,
			  FrontFaceStencilFailStencilOp, FrontFaceDepthFailStencilOp, FrontFacePassStencilOp,
			  bEnableBackFaceStencil, BackFaceStencilTest, BackFaceStencilFailStencilOp, BackFaceDepthFailStencilOp,
			  BackFacePassStencilOp, StencilReadMask, StencilWriteMask>,
		  FDepthStencilStateRHIRef, FRHIDepthStencilState>
{
public:
	static FDepthStencilStateRHIRef CreateRHI()
	{
		return RHICreateDepthStencilState(FDepthStencilStateInitializerRHI{bEnableDepthWrite, DepthTest,
			bEnableFrontFaceStencil, FrontFaceStencilTest, FrontFaceStencilFailStencilOp, FrontFaceDepthFailStencilOp,
			FrontFacePassStencilOp, bEnableBackFaceStencil, BackFaceStencilTest, BackFaceStencilFailStencilOp,
			BackFaceDepthFailStencilOp, BackFacePassStencilOp, StencilReadMask, StencilWriteMask});
	}
};

// The engine gives each of eight targets seven arguments; here they are spelled by two macros.
#define DRYDOCK_BLEND_TARGET(N) \
	EColorWriteMask RT##N##ColorWriteMask = CW_RGBA, EBlendOperation RT##N##ColorBlendOp = BO_Add, \
					EBlendFactor RT##N##ColorSrcBlend = BF_One, EBlendFactor RT##N##ColorDestBlend = BF_Zero, \
					EBlendOperation RT##N##AlphaBlendOp = BO_Add, EBlendFactor RT##N##AlphaSrcBlend = BF_One, \
					EBlendFactor RT##N##AlphaDestBlend = BF_Zero

#define DRYDOCK_BLEND_ARGUMENTS(N) \
	RT##N##ColorWriteMask, RT##N##ColorBlendOp, RT##N##ColorSrcBlend, RT##N##ColorDestBlend, RT##N##AlphaBlendOp, \
		RT##N##AlphaSrcBlend, RT##N##AlphaDestBlend

#define DRYDOCK_BLEND_INITIALIZER(N) \
	FBlendStateInitializerRHI::FRenderTarget \
	{ \
		RT##N##ColorBlendOp, RT##N##ColorSrcBlend, RT##N##ColorDestBlend, RT##N##AlphaBlendOp, RT##N##AlphaSrcBlend, \
			RT##N##AlphaDestBlend, RT##N##ColorWriteMask \
	}

template<DRYDOCK_BLEND_TARGET(0), DRYDOCK_BLEND_TARGET(1), DRYDOCK_BLEND_TARGET(2), DRYDOCK_BLEND_TARGET(3),
	DRYDOCK_BLEND_TARGET(4), DRYDOCK_BLEND_TARGET(5), DRYDOCK_BLEND_TARGET(6), DRYDOCK_BLEND_TARGET(7),
	bool bUseAlphaToCoverage = false>
class TStaticBlendState
	: public Drydock::TStaticState<
		  TStaticBlendState<DRYDOCK_BLEND_ARGUMENTS(0), DRYDOCK_BLEND_ARGUMENTS(1), DRYDOCK_BLEND_ARGUMENTS(2),
			  DRYDOCK_BLEND_ARGUMENTS(3), DRYDOCK_BLEND_ARGUMENTS(4), DRYDOCK_BLEND_ARGUMENTS(5),
			  DRYDOCK_BLEND_ARGUMENTS(6), DRYDOCK_BLEND_ARGUMENTS(7), bUseAlphaToCoverage>,
		  FBlendStateRHIRef, FRHIBlendState>
{
public:
	static FBlendStateRHIRef CreateRHI()
	{
		FBlendStateInitializerRHI Initializer{{DRYDOCK_BLEND_INITIALIZER(0), DRYDOCK_BLEND_INITIALIZER(1),
			DRYDOCK_BLEND_INITIALIZER(2), DRYDOCK_BLEND_INITIALIZER(3), DRYDOCK_BLEND_INITIALIZER(4),
			DRYDOCK_BLEND_INITIALIZER(5), DRYDOCK_BLEND_INITIALIZER(6), DRYDOCK_BLEND_INITIALIZER(7)}};
		for (int32 Target = 1; Target < MaxSimultaneousRenderTargets; ++Target)
		{
			const FBlendStateInitializerRHI::FRenderTarget& State = Initializer.RenderTargets[Target];
			Initializer.bUseIndependentRenderTargetBlendStates |= State.IsBlending() || State.ColorWriteMask != CW_RGBA;
		}
		Initializer.bUseAlphaToCoverage = bUseAlphaToCoverage;
		return RHICreateBlendState(Initializer);
	}
};

#undef DRYDOCK_BLEND_TARGET
#undef DRYDOCK_BLEND_ARGUMENTS
#undef DRYDOCK_BLEND_INITIALIZER

template<EColorWriteMask RT0 = CW_RGBA, EColorWriteMask RT1 = CW_RGBA, EColorWriteMask RT2 = CW_RGBA,
	EColorWriteMask RT3 = CW_RGBA, EColorWriteMask RT4 = CW_RGBA, EColorWriteMask RT5 = CW_RGBA,
	EColorWriteMask RT6 = CW_RGBA, EColorWriteMask RT7 = CW_RGBA>
class TStaticBlendStateWriteMask
	: public Drydock::TStaticState<TStaticBlendStateWriteMask<RT0, RT1, RT2, RT3, RT4, RT5, RT6, RT7>,
		  FBlendStateRHIRef, FRHIBlendState>
{
public:
	static FBlendStateRHIRef CreateRHI()
	{
		constexpr EColorWriteMask Masks[] = {RT0, RT1, RT2, RT3, RT4, RT5, RT6, RT7};
		FBlendStateInitializerRHI Initializer;
		Initializer.bUseIndependentRenderTargetBlendStates = true;
		for (int32 Target = 0; Target < MaxSimultaneousRenderTargets; ++Target)
		{
			Initializer.RenderTargets[Target].ColorWriteMask = Masks[Target];
		}
		return RHICreateBlendState(Initializer);
	}
};
