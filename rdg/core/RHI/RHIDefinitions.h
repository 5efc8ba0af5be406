// Enumerations of the RHI. Source: engine RHIDefinitions.h.
#pragma once

#include "CoreMinimal.h"
#include "PixelFormat.h"
#include "RHIAccess.h"
#include "RHIFeatureLevel.h"
#include "RHIPipeline.h"
#include "RHIShaderPlatform.h"

constexpr int32 MaxSimultaneousRenderTargets = 8;
constexpr int32 GMaxTextureMipCount = 15;

/** Extents beyond this are a usage error. 2^14 texels each way, as D3D12. */
constexpr int32 GMaxTextureDimensions = 16384;

/** Groups of a dispatch in each direction, as D3D has it. */
inline const FIntVector GRHIMaxDispatchThreadGroupsPerDimension = FIntVector(65535, 65535, 65535);

enum class ETextureDimension : uint8
{
	Texture2D,
	Texture2DArray,
	Texture3D,
	TextureCube,
	TextureCubeArray,
};

enum class ETextureCreateFlags : uint64
{
	None = 0,
	RenderTargetable = 1ull << 0,
	ResolveTargetable = 1ull << 1,
	DepthStencilTargetable = 1ull << 2,
	ShaderResource = 1ull << 3,
	SRGB = 1ull << 4, // 8-bit four-channel formats only; ignored by others, as in D3D
	CPUWritable = 1ull << 5,
	NoTiling = 1ull << 6,
	VideoDecode = 1ull << 7,
	Dynamic = 1ull << 8,
	InputAttachmentRead = 1ull << 9,
	Foveation = 1ull << 10,
	Tiling3D = 1ull << 11,
	Memoryless = 1ull << 12,
	GenerateMipCapable = 1ull << 13,
	FastVRAMPartialAlloc = 1ull << 14,
	DisableSRVCreation = 1ull << 15,
	DisableDCC = 1ull << 16,
	UAV = 1ull << 17,
	Presentable = 1ull << 18,
	CPUReadback = 1ull << 19,
	OfflineProcessed = 1ull << 20,
	FastVRAM = 1ull << 21,
	HideInVisualizeTexture = 1ull << 22,
	Virtual = 1ull << 23,
	TargetArraySlicesIndependently = 1ull << 24,
	Shared = 1ull << 25,
	NoFastClear = 1ull << 26,
	DepthStencilResolveTarget = 1ull << 27,
	Streamable = 1ull << 28,
	NoFastClearFinalize = 1ull << 29,
	Atomic64Compatible = 1ull << 30,
	ReduceMemoryWithTilingMode = 1ull << 31,
	AtomicCompatible = 1ull << 33,
	External = 1ull << 34,
	MultiGPUGraphIgnore = 1ull << 35,
};
ENUM_CLASS_FLAGS(ETextureCreateFlags)

#define TexCreate_None ETextureCreateFlags::None
#define TexCreate_RenderTargetable ETextureCreateFlags::RenderTargetable
#define TexCreate_ResolveTargetable ETextureCreateFlags::ResolveTargetable
#define TexCreate_DepthStencilTargetable ETextureCreateFlags::DepthStencilTargetable
#define TexCreate_ShaderResource ETextureCreateFlags::ShaderResource
#define TexCreate_SRGB ETextureCreateFlags::SRGB
#define TexCreate_CPUWritable ETextureCreateFlags::CPUWritable
#define TexCreate_NoTiling ETextureCreateFlags::NoTiling
#define TexCreate_Dynamic ETextureCreateFlags::Dynamic
#define TexCreate_InputAttachmentRead ETextureCreateFlags::InputAttachmentRead
#define TexCreate_3DTiling ETextureCreateFlags::Tiling3D
#define TexCreate_Memoryless ETextureCreateFlags::Memoryless
#define TexCreate_GenerateMipCapable ETextureCreateFlags::GenerateMipCapable
#define TexCreate_DisableDCC ETextureCreateFlags::DisableDCC
#define TexCreate_UAV ETextureCreateFlags::UAV
#define TexCreate_Presentable ETextureCreateFlags::Presentable
#define TexCreate_CPUReadback ETextureCreateFlags::CPUReadback
#define TexCreate_FastVRAM ETextureCreateFlags::FastVRAM
#define TexCreate_HideInVisualizeTexture ETextureCreateFlags::HideInVisualizeTexture
#define TexCreate_TargetArraySlicesIndependently ETextureCreateFlags::TargetArraySlicesIndependently
#define TexCreate_Shared ETextureCreateFlags::Shared
#define TexCreate_NoFastClear ETextureCreateFlags::NoFastClear
#define TexCreate_DepthStencilResolveTarget ETextureCreateFlags::DepthStencilResolveTarget
#define TexCreate_NoFastClearFinalize ETextureCreateFlags::NoFastClearFinalize
#define TexCreate_Atomic64Compatible ETextureCreateFlags::Atomic64Compatible
#define TexCreate_AtomicCompatible ETextureCreateFlags::AtomicCompatible

enum class EBufferUsageFlags : uint32
{
	None = 0,
	Static = 1 << 0,
	Dynamic = 1 << 1,
	Volatile = 1 << 2,
	UnorderedAccess = 1 << 3,
	ByteAddressBuffer = 1 << 4,
	SourceCopy = 1 << 5,
	StreamOutput = 1 << 6,
	DrawIndirect = 1 << 7,
	ShaderResource = 1 << 8,
	KeepCPUAccessible = 1 << 9,
	FastVRAM = 1 << 10,
	Shared = 1 << 12,
	AccelerationStructure = 1 << 13,
	VertexBuffer = 1 << 14,
	IndexBuffer = 1 << 15,
	StructuredBuffer = 1 << 16,
	MultiGPUAllocate = 1 << 17,
	MultiGPUGraphIgnore = 1 << 18,
	NullResource = 1 << 20,
	UniformBuffer = 1 << 21,
	AnyDynamic = Dynamic | Volatile,
};
ENUM_CLASS_FLAGS(EBufferUsageFlags)

#define BUF_None EBufferUsageFlags::None
#define BUF_Static EBufferUsageFlags::Static
#define BUF_Dynamic EBufferUsageFlags::Dynamic
#define BUF_Volatile EBufferUsageFlags::Volatile
#define BUF_UnorderedAccess EBufferUsageFlags::UnorderedAccess
#define BUF_ByteAddressBuffer EBufferUsageFlags::ByteAddressBuffer
#define BUF_SourceCopy EBufferUsageFlags::SourceCopy
#define BUF_DrawIndirect EBufferUsageFlags::DrawIndirect
#define BUF_ShaderResource EBufferUsageFlags::ShaderResource
#define BUF_KeepCPUAccessible EBufferUsageFlags::KeepCPUAccessible
#define BUF_FastVRAM EBufferUsageFlags::FastVRAM
#define BUF_VertexBuffer EBufferUsageFlags::VertexBuffer
#define BUF_IndexBuffer EBufferUsageFlags::IndexBuffer
#define BUF_StructuredBuffer EBufferUsageFlags::StructuredBuffer

enum class EClearBinding : uint8
{
	ENoneBound,
	EColorBound,
	EDepthStencilBound,
};

enum class ERenderTargetLoadAction : uint8
{
	ENoAction, // contents undefined
	ELoad,
	EClear, // to the texture's clear value
	Num,
	NumBits = 2,
};

enum class ERenderTargetStoreAction : uint8
{
	ENoAction,
	EStore,
	EMultisampleResolve,
	Num,
	NumBits = 2,
};

enum ESamplerFilter
{
	SF_Point,
	SF_Bilinear,
	SF_Trilinear,
	SF_AnisotropicPoint,
	SF_AnisotropicLinear,
	ESamplerFilter_Num,
};

enum ESamplerAddressMode
{
	AM_Wrap,
	AM_Clamp,
	AM_Mirror,
	AM_Border,
	ESamplerAddressMode_Num,
};

enum ESamplerCompareFunction
{
	SCF_Never,
	SCF_Less,
};

enum ERasterizerFillMode
{
	FM_Point,
	FM_Wireframe,
	FM_Solid,
};

enum ERasterizerCullMode
{
	CM_None,
	CM_CW,
	CM_CCW,
};

enum class ERasterizerDepthClipMode : uint8
{
	DepthClip,
	DepthClamp,
};

enum EColorWriteMask
{
	CW_RED = 0x01,
	CW_GREEN = 0x02,
	CW_BLUE = 0x04,
	CW_ALPHA = 0x08,
	CW_NONE = 0,
	CW_RGB = CW_RED | CW_GREEN | CW_BLUE,
	CW_RGBA = CW_RGB | CW_ALPHA,
	CW_RG = CW_RED | CW_GREEN,
	CW_BA = CW_BLUE | CW_ALPHA,
};

enum ECompareFunction
{
	CF_Less,
	CF_LessEqual,
	CF_Greater,
	CF_GreaterEqual,
	CF_Equal,
	CF_NotEqual,
	CF_Never,
	CF_Always,
	CF_DepthNearOrEqual = CF_GreaterEqual, // reversed depth: near is 1
	CF_DepthNear = CF_Greater,
	CF_DepthFartherOrEqual = CF_LessEqual,
	CF_DepthFarther = CF_Less,
};

enum EStencilOp
{
	SO_Keep,
	SO_Zero,
	SO_Replace,
	SO_SaturatedIncrement,
	SO_SaturatedDecrement,
	SO_Invert,
	SO_Increment,
	SO_Decrement,
};

enum EBlendOperation
{
	BO_Add,
	BO_Subtract,
	BO_Min,
	BO_Max,
	BO_ReverseSubtract,
};

enum EBlendFactor
{
	BF_Zero,
	BF_One,
	BF_SourceColor,
	BF_InverseSourceColor,
	BF_SourceAlpha,
	BF_InverseSourceAlpha,
	BF_DestAlpha,
	BF_InverseDestAlpha,
	BF_DestColor,
	BF_InverseDestColor,
	BF_ConstantBlendFactor,
	BF_InverseConstantBlendFactor,
};

enum EPrimitiveType
{
	PT_TriangleList,
	PT_TriangleStrip,
	PT_LineList,
	PT_QuadList,
	PT_PointList,
	PT_RectList,
};

enum EResourceLockMode
{
	RLM_ReadOnly,
	RLM_WriteOnly,
	RLM_WriteOnly_NoOverwrite,
};

/** How ReadSurfaceData maps values. RCM_MinMax leaves them as they are. */
enum ERangeCompressionMode
{
	RCM_UNorm,      // clamped to 0..1
	RCM_SNorm,      // clamped to -1..1
	RCM_MinMaxNorm, // 0..1; scaled to it when a value lies outside
	RCM_MinMax,
};

enum ECubeFace
{
	CubeFace_PosX,
	CubeFace_NegX,
	CubeFace_PosY,
	CubeFace_NegY,
	CubeFace_PosZ,
	CubeFace_NegZ,
	CubeFace_MAX,
};

enum class EApplyRendertargetOption : int
{
	DoNothing,
	ForceApply,
	CheckApply,
};

/** The access of a depth-stencil binding to each plane. */
class FExclusiveDepthStencil
{
public:
	enum Type : uint8
	{
		DepthNop = 0x00,
		DepthRead = 0x01,
		DepthWrite = 0x02,
		DepthMask = 0x0f,
		StencilNop = 0x00,
		StencilRead = 0x10,
		StencilWrite = 0x20,
		StencilMask = 0xf0,
		DepthNop_StencilNop = DepthNop | StencilNop,
		DepthRead_StencilNop = DepthRead | StencilNop,
		DepthWrite_StencilNop = DepthWrite | StencilNop,
		DepthNop_StencilRead = DepthNop | StencilRead,
		DepthRead_StencilRead = DepthRead | StencilRead,
		DepthWrite_StencilRead = DepthWrite | StencilRead,
		DepthNop_StencilWrite = DepthNop | StencilWrite,
		DepthRead_StencilWrite = DepthRead | StencilWrite,
		DepthWrite_StencilWrite = DepthWrite | StencilWrite,
	};

	FExclusiveDepthStencil(Type InValue = DepthNop_StencilNop)
		: Value(InValue)
	{
	}

	bool IsUsingDepthStencil() const { return Value != DepthNop_StencilNop; }
	bool IsUsingDepth() const { return (Value & DepthMask) != DepthNop; }
	bool IsUsingStencil() const { return (Value & StencilMask) != StencilNop; }
	bool IsDepthRead() const { return (Value & DepthMask) == DepthRead; }
	bool IsStencilRead() const { return (Value & StencilMask) == StencilRead; }
	bool IsDepthWrite() const { return (Value & DepthMask) == DepthWrite; }
	bool IsStencilWrite() const { return (Value & StencilMask) == StencilWrite; }
	bool IsAnyWrite() const { return IsDepthWrite() || IsStencilWrite(); }
	Type GetDepthStencil() const { return Value; }
	operator Type() const { return Value; }
	bool operator==(const FExclusiveDepthStencil& Other) const { return Value == Other.Value; }
	bool operator==(Type Other) const { return Value == Other; }

private:
	Type Value;
};
