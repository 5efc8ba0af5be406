// Sampler, blend, rasterizer and depth-stencil states, and the shaders and vertex layouts a pipeline state names.
// Source: engine RHI.h, RHIResources.h.
#pragma once

#include "RHIDefinitions.h"
#include "RHIResource.h"
#include "ShaderKernel.h"

class FShader;

struct FSamplerStateInitializerRHI
{
	FSamplerStateInitializerRHI(ESamplerFilter InFilter = SF_Point, ESamplerAddressMode InAddressU = AM_Wrap,
		ESamplerAddressMode InAddressV = AM_Wrap, ESamplerAddressMode InAddressW = AM_Wrap, float InMipBias = 0,
		int32 InMaxAnisotropy = 0, float InMinMipLevel = 0, float InMaxMipLevel = 1000, uint32 InBorderColor = 0,
		ESamplerCompareFunction InSamplerComparisonFunction = SCF_Never)
		: Filter(InFilter)
		, AddressU(InAddressU)
		, AddressV(InAddressV)
		, AddressW(InAddressW)
		, MipBias(InMipBias)
		, MinMipLevel(InMinMipLevel)
		, MaxMipLevel(InMaxMipLevel)
		, MaxAnisotropy(InMaxAnisotropy)
		, BorderColor(InBorderColor)
		, SamplerComparisonFunction(InSamplerComparisonFunction)
	{
	}

	ESamplerFilter Filter;
	ESamplerAddressMode AddressU;
	ESamplerAddressMode AddressV;
	ESamplerAddressMode AddressW;
	float MipBias;
	float MinMipLevel; // levels, with the bias, are clamped to this range
	float MaxMipLevel;
	int32 MaxAnisotropy;                               // kept, not used: levels are those of isotropic filters
	uint32 BorderColor;                                // 0xAARRGGBB, as FColor::DWColor
	ESamplerCompareFunction SamplerComparisonFunction; // of SampleCmp and GatherCmp; SCF_Never: a sampler of colours
};

class DRYDOCK_API FRHISamplerState final : public FRHIResource
{
public:
	explicit FRHISamplerState(const FSamplerStateInitializerRHI& InInitializer)
		: Initializer(InInitializer)
	{
	}

	const FSamplerStateInitializerRHI& GetInitializer() const { return Initializer; }

	/** The sampler as a shader sees it, with r.Drydock.SampleBits as it is now. Anisotropic filters become point and
	 * trilinear. */
	Drydock::FKernelSampler GetKernelSampler() const;

private:
	FSamplerStateInitializerRHI Initializer;
};

struct FBlendStateInitializerRHI
{
	struct FRenderTarget
	{
		EBlendOperation ColorBlendOp = BO_Add;
		EBlendFactor ColorSrcBlend = BF_One;
		EBlendFactor ColorDestBlend = BF_Zero;
		EBlendOperation AlphaBlendOp = BO_Add;
		EBlendFactor AlphaSrcBlend = BF_One;
		EBlendFactor AlphaDestBlend = BF_Zero;
		EColorWriteMask ColorWriteMask = CW_RGBA;

		/** The target's old value matters beyond the write mask. */
		bool IsBlending() const
		{
			const bool bColorReplaced = ColorBlendOp == BO_Add && ColorSrcBlend == BF_One && ColorDestBlend == BF_Zero;
			const bool bAlphaReplaced = AlphaBlendOp == BO_Add && AlphaSrcBlend == BF_One && AlphaDestBlend == BF_Zero;
			return !bColorReplaced || !bAlphaReplaced;
		}
	};

	FRenderTarget RenderTargets[MaxSimultaneousRenderTargets];
	bool bUseIndependentRenderTargetBlendStates = false; // false: target 0's state serves all
	bool bUseAlphaToCoverage = false;
};

class DRYDOCK_API FRHIBlendState final : public FRHIResource
{
public:
	explicit FRHIBlendState(const FBlendStateInitializerRHI& InInitializer)
		: Initializer(InInitializer)
	{
	}

	const FBlendStateInitializerRHI& GetInitializer() const { return Initializer; }
	const FBlendStateInitializerRHI::FRenderTarget& GetTarget(int32 Index) const
	{
		return Initializer.RenderTargets[Initializer.bUseIndependentRenderTargetBlendStates ? Index : 0];
	}

private:
	FBlendStateInitializerRHI Initializer;
};

struct FRasterizerStateInitializerRHI
{
	ERasterizerFillMode FillMode = FM_Solid;
	ERasterizerCullMode CullMode = CM_None;
	float DepthBias = 0;
	float SlopeScaleDepthBias = 0;
	ERasterizerDepthClipMode DepthClipMode = ERasterizerDepthClipMode::DepthClip;
	bool bAllowMSAA = false;
	bool bEnableLineAA = false;
};

/** Draws are rectangles that face the camera, whatever this state is. */
class DRYDOCK_API FRHIRasterizerState final : public FRHIResource
{
public:
	explicit FRHIRasterizerState(const FRasterizerStateInitializerRHI& InInitializer)
		: Initializer(InInitializer)
	{
	}
	const FRasterizerStateInitializerRHI& GetInitializer() const { return Initializer; }

private:
	FRasterizerStateInitializerRHI Initializer;
};

struct FDepthStencilStateInitializerRHI
{
	bool bEnableDepthWrite = true;
	ECompareFunction DepthTest = CF_LessEqual;
	bool bEnableFrontFaceStencil = false;
	ECompareFunction FrontFaceStencilTest = CF_Always;
	EStencilOp FrontFaceStencilFailStencilOp = SO_Keep;
	EStencilOp FrontFaceDepthFailStencilOp = SO_Keep;
	EStencilOp FrontFacePassStencilOp = SO_Keep;
	bool bEnableBackFaceStencil = false;
	ECompareFunction BackFaceStencilTest = CF_Always;
	EStencilOp BackFaceStencilFailStencilOp = SO_Keep;
	EStencilOp BackFaceDepthFailStencilOp = SO_Keep;
	EStencilOp BackFacePassStencilOp = SO_Keep;
	uint8 StencilReadMask = 0xff;
	uint8 StencilWriteMask = 0xff;
};

class DRYDOCK_API FRHIDepthStencilState final : public FRHIResource
{
public:
	explicit FRHIDepthStencilState(const FDepthStencilStateInitializerRHI& InInitializer)
		: Initializer(InInitializer)
	{
	}
	const FDepthStencilStateInitializerRHI& GetInitializer() const { return Initializer; }

	/** The state could reject or write something where a depth-stencil target is bound. bMayWrite: depth may be
	 * written. */
	bool IsTesting(bool bMayWrite = false) const
	{
		return Initializer.DepthTest != CF_Always || (Initializer.bEnableDepthWrite && !bMayWrite) ||
			   Initializer.bEnableFrontFaceStencil || Initializer.bEnableBackFaceStencil;
	}

private:
	FDepthStencilStateInitializerRHI Initializer;
};

using FSamplerStateRHIRef = TRefCountPtr<FRHISamplerState>;
using FBlendStateRHIRef = TRefCountPtr<FRHIBlendState>;
using FRasterizerStateRHIRef = TRefCountPtr<FRHIRasterizerState>;
using FDepthStencilStateRHIRef = TRefCountPtr<FRHIDepthStencilState>;
using FSamplerStateRHIParamRef = FRHISamplerState*;

DRYDOCK_API FSamplerStateRHIRef RHICreateSamplerState(const FSamplerStateInitializerRHI& Initializer);
DRYDOCK_API FBlendStateRHIRef RHICreateBlendState(const FBlendStateInitializerRHI& Initializer);
DRYDOCK_API FRasterizerStateRHIRef RHICreateRasterizerState(const FRasterizerStateInitializerRHI& Initializer);
DRYDOCK_API FDepthStencilStateRHIRef RHICreateDepthStencilState(const FDepthStencilStateInitializerRHI& Initializer);

enum EVertexElementType
{
	VET_None,
	VET_Float1,
	VET_Float2,
	VET_Float3,
	VET_Float4,
	VET_PackedNormal,
	VET_UByte4,
	VET_UByte4N,
	VET_Color,
	VET_Short2,
	VET_Short4,
	VET_Short2N,
	VET_Half2,
	VET_Half4,
	VET_UInt,
};

/** One vertex attribute: where it lies in the buffer of its stream, and as which ATTRIBUTEn a vertex shader reads it.
 */
struct FVertexElement
{
	FVertexElement() = default;
	FVertexElement(uint8 InStreamIndex, uint8 InOffset, EVertexElementType InType, uint8 InAttributeIndex,
		uint16 InStride, bool bInUseInstanceIndex = false)
		: StreamIndex(InStreamIndex)
		, Offset(InOffset)
		, Type(InType)
		, AttributeIndex(InAttributeIndex)
		, Stride(InStride)
		, bUseInstanceIndex(bInUseInstanceIndex)
	{
	}

	uint8 StreamIndex = 0;
	uint8 Offset = 0;
	EVertexElementType Type = VET_None;
	uint8 AttributeIndex = 0;
	uint16 Stride = 0;
	bool bUseInstanceIndex = false;
};

constexpr int32 MaxVertexElementCount = 17;
using FVertexDeclarationElementList = TArray<FVertexElement, TInlineAllocator<MaxVertexElementCount>>;

class DRYDOCK_API FRHIVertexDeclaration final : public FRHIResource
{
public:
	explicit FRHIVertexDeclaration(const FVertexDeclarationElementList& InElements)
		: Elements(InElements)
	{
	}
	const FVertexDeclarationElementList& GetElements() const { return Elements; }

private:
	FVertexDeclarationElementList Elements;
};

using FVertexDeclarationRHIRef = TRefCountPtr<FRHIVertexDeclaration>;

DRYDOCK_API FVertexDeclarationRHIRef RHICreateVertexDeclaration(const FVertexDeclarationElementList& Elements);

/** Names a shader to a pipeline state. The code that runs is the Drydock::FBoundShader that SetShaderParameters makes
 * of it. */
class DRYDOCK_API FRHIShader : public FRHIResource
{
public:
	explicit FRHIShader(EShaderFrequency InFrequency, FShader* InPermutation = nullptr)
		: Frequency(InFrequency)
		, Permutation(InPermutation)
	{
	}
	EShaderFrequency GetFrequency() const { return Frequency; }
	/** The shader whose handle this is. */
	FShader* GetPermutation() const { return Permutation; }

private:
	EShaderFrequency Frequency;
	FShader* Permutation;
};

class DRYDOCK_API FRHIGraphicsShader : public FRHIShader
{
public:
	using FRHIShader::FRHIShader;
};

class DRYDOCK_API FRHIVertexShader : public FRHIGraphicsShader
{
public:
	/** ShaderToRun: null for the engine's rectangle of screen passes, which draws know without running it. */
	explicit FRHIVertexShader(FShader* InShaderToRun = nullptr)
		: FRHIGraphicsShader(SF_Vertex, InShaderToRun)
		, ShaderToRun(InShaderToRun)
	{
	}
	FShader* GetShaderToRun() const { return ShaderToRun; }

private:
	FShader* ShaderToRun;
};

class DRYDOCK_API FRHIPixelShader : public FRHIGraphicsShader
{
public:
	explicit FRHIPixelShader(FShader* InPermutation = nullptr)
		: FRHIGraphicsShader(SF_Pixel, InPermutation)
	{
	}
};

class DRYDOCK_API FRHIGeometryShader : public FRHIGraphicsShader
{
public:
	FRHIGeometryShader()
		: FRHIGraphicsShader(SF_Geometry)
	{
	}
};

class DRYDOCK_API FRHIComputeShader : public FRHIShader
{
public:
	explicit FRHIComputeShader(FShader* InPermutation = nullptr)
		: FRHIShader(SF_Compute, InPermutation)
	{
	}
};

using FVertexShaderRHIRef = TRefCountPtr<FRHIVertexShader>;
using FPixelShaderRHIRef = TRefCountPtr<FRHIPixelShader>;
using FComputeShaderRHIRef = TRefCountPtr<FRHIComputeShader>;

struct FBoundShaderStateInput
{
	FRHIVertexDeclaration* VertexDeclarationRHI = nullptr;
	FRHIVertexShader* VertexShaderRHI = nullptr;
	FRHIPixelShader* PixelShaderRHI = nullptr;
	FRHIGeometryShader* GeometryShaderRHI = nullptr;
};

/** Everything SetGraphicsPipelineState sets. Null states mean the static default: replace, no test. */
struct FGraphicsPipelineStateInitializer
{
	FBoundShaderStateInput BoundShaderState;
	FRHIBlendState* BlendState = nullptr;
	FRHIRasterizerState* RasterizerState = nullptr;
	FRHIDepthStencilState* DepthStencilState = nullptr;
	EPrimitiveType PrimitiveType = PT_TriangleList;
	uint32 RenderTargetsEnabled = 0; // filled by ApplyCachedRenderTargets
	EPixelFormat RenderTargetFormats[MaxSimultaneousRenderTargets] = {};
	EPixelFormat DepthStencilTargetFormat = PF_Unknown;
	uint16 NumSamples = 1;
};
