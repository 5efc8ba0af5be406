// Descriptions of textures and buffers. Source: engine RHIResources.h, RHIDefinitions.h, RenderGraphDefinitions.h (the
// graph's FRDGTextureDesc is this FRHITextureDesc).
#pragma once

#include "CoreMinimal.h"
#include "RHIDefinitions.h"

#include <cfloat>

/** The value that ERenderTargetLoadAction::EClear clears a texture to. Default: transparent black. */
struct FClearValueBinding
{
	struct DSVAlue
	{
		float Depth;
		uint32 Stencil;
	};

	constexpr FClearValueBinding()
		: FClearValueBinding(0.0f, 0.0f, 0.0f, 0.0f)
	{
	}
	constexpr FClearValueBinding(EClearBinding NoBinding)
		: FClearValueBinding()
	{
		ColorBinding = NoBinding;
	}
	explicit FClearValueBinding(const FLinearColor& Color)
		: FClearValueBinding(Color.R, Color.G, Color.B, Color.A)
	{
	}
	constexpr explicit FClearValueBinding(float Depth, uint32 Stencil = 0)
		: FClearValueBinding()
	{
		ColorBinding = EClearBinding::EDepthStencilBound;
		Value.DSValue = {Depth, Stencil};
	}
	constexpr FClearValueBinding(float R, float G, float B, float A)
	{
		Value.Color[0] = R;
		Value.Color[1] = G;
		Value.Color[2] = B;
		Value.Color[3] = A;
	}

	FLinearColor GetClearColor() const
	{
		return FLinearColor(Value.Color[0], Value.Color[1], Value.Color[2], Value.Color[3]);
	}

	void GetDepthStencil(float& OutDepth, uint32& OutStencil) const
	{
		OutDepth = Value.DSValue.Depth;
		OutStencil = Value.DSValue.Stencil;
	}

	DRYDOCK_API bool operator==(const FClearValueBinding& Other) const;

	EClearBinding ColorBinding = EClearBinding::EColorBound;

	struct // the engine has a union; separate members keep every read defined
	{
		float Color[4] = {};
		DSVAlue DSValue = {};
	} Value;

	static DRYDOCK_API const FClearValueBinding None;
	static DRYDOCK_API const FClearValueBinding Black;
	static DRYDOCK_API const FClearValueBinding BlackMaxAlpha;
	static DRYDOCK_API const FClearValueBinding White;
	static DRYDOCK_API const FClearValueBinding Transparent;
	static DRYDOCK_API const FClearValueBinding DepthOne;
	static DRYDOCK_API const FClearValueBinding DepthZero;
	static DRYDOCK_API const FClearValueBinding DepthNear; // reversed depth: 1
	static DRYDOCK_API const FClearValueBinding DepthFar;  // 0
	static DRYDOCK_API const FClearValueBinding Green;
	static DRYDOCK_API const FClearValueBinding DefaultNormal8Bit;
};

DRYDOCK_API uint32 GetTypeHash(const FClearValueBinding& Binding);

/** A texture's shape and format. Depth is that of 3D textures, ArraySize the number of layers (a cube has six faces per
 *  layer); extents are in texels of mip 0. */
struct FRHITextureDesc
{
	FRHITextureDesc() = default;
	explicit FRHITextureDesc(ETextureDimension InDimension)
		: Dimension(InDimension)
	{
	}
	FRHITextureDesc(ETextureDimension InDimension, ETextureCreateFlags InFlags, EPixelFormat InFormat,
		FClearValueBinding InClearValue, FIntPoint InExtent, uint16 InDepth, uint16 InArraySize, uint8 InNumMips,
		uint8 InNumSamples, uint32 InExtData)
		: Flags(InFlags)
		, ClearValue(InClearValue)
		, ExtData(InExtData)
		, Extent(InExtent)
		, Depth(InDepth)
		, ArraySize(InArraySize)
		, NumMips(InNumMips)
		, NumSamples(InNumSamples)
		, Dimension(InDimension)
		, Format(InFormat)
	{
	}

	static FRHITextureDesc Create2D(FIntPoint Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, uint8 NumMips = 1, uint8 NumSamples = 1, uint32 ExtData = 0)
	{
		return FRHITextureDesc(
			ETextureDimension::Texture2D, Flags, Format, ClearValue, Size, 1, 1, NumMips, NumSamples, ExtData);
	}

	static FRHITextureDesc Create2DArray(FIntPoint Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, uint16 ArraySize, uint8 NumMips = 1, uint8 NumSamples = 1, uint32 ExtData = 0)
	{
		return FRHITextureDesc(ETextureDimension::Texture2DArray, Flags, Format, ClearValue, Size, 1, ArraySize,
			NumMips, NumSamples, ExtData);
	}

	static FRHITextureDesc Create3D(FIntVector Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, uint8 NumMips = 1, uint32 ExtData = 0)
	{
		return FRHITextureDesc(ETextureDimension::Texture3D, Flags, Format, ClearValue, FIntPoint(Size.X, Size.Y),
			uint16(Size.Z), 1, NumMips, 1, ExtData);
	}

	static FRHITextureDesc CreateCube(uint32 Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, uint8 NumMips = 1, uint8 NumSamples = 1, uint32 ExtData = 0)
	{
		return FRHITextureDesc(ETextureDimension::TextureCube, Flags, Format, ClearValue,
			FIntPoint(int32(Size), int32(Size)), 1, 1, NumMips, NumSamples, ExtData);
	}

	static FRHITextureDesc CreateCubeArray(uint32 Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, uint16 ArraySize, uint8 NumMips = 1, uint8 NumSamples = 1, uint32 ExtData = 0)
	{
		return FRHITextureDesc(ETextureDimension::TextureCubeArray, Flags, Format, ClearValue,
			FIntPoint(int32(Size), int32(Size)), 1, ArraySize, NumMips, NumSamples, ExtData);
	}

	/** The form of 4.2x and 5.0, with targetable flags apart. */
	static FRHITextureDesc Create2DDesc(FIntPoint Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, ETextureCreateFlags TargetableFlags,
		bool bForceSeparateTargetAndShaderResource = false, uint16 NumMips = 1)
	{
		(void)bForceSeparateTargetAndShaderResource;
		return Create2D(Size, Format, ClearValue, Flags | TargetableFlags, uint8(NumMips));
	}

	/** Makes the description of an input fit for an output: single-sampled, renderable, without what ties it to its
	 * use. */
	void Reset()
	{
		NumSamples = 1;
		Flags |= ETextureCreateFlags::RenderTargetable;
		Flags &= ~(ETextureCreateFlags::UAV | ETextureCreateFlags::ResolveTargetable |
				   ETextureCreateFlags::DepthStencilResolveTarget | ETextureCreateFlags::Memoryless);
	}

	bool IsTexture2D() const
	{
		return Dimension == ETextureDimension::Texture2D || Dimension == ETextureDimension::Texture2DArray;
	}
	bool IsTexture3D() const { return Dimension == ETextureDimension::Texture3D; }
	bool IsTextureCube() const
	{
		return Dimension == ETextureDimension::TextureCube || Dimension == ETextureDimension::TextureCubeArray;
	}
	bool IsTextureArray() const
	{
		return Dimension == ETextureDimension::Texture2DArray || Dimension == ETextureDimension::TextureCubeArray;
	}
	bool IsMipChain() const { return NumMips > 1; }
	bool IsMultisample() const { return NumSamples > 1; }

	FIntVector GetSize() const { return FIntVector(Extent.X, Extent.Y, Depth); }

	/** Layers in memory: array layers, six per cube. 1 for 3D textures. */
	int32 GetNumSlices() const { return int32(ArraySize) * (IsTextureCube() ? 6 : 1); }

	/** The shape is one a texture can be made from. OutReason, when given, receives a sentence when it is not. */
	DRYDOCK_API bool IsValid(FString* OutReason = nullptr) const;

	DRYDOCK_API bool operator==(const FRHITextureDesc& Other) const;
	bool operator!=(const FRHITextureDesc& Other) const { return !(*this == Other); }

	ETextureCreateFlags Flags = ETextureCreateFlags::None;
	FClearValueBinding ClearValue;
	uint32 ExtData = 0;
	FIntPoint Extent = FIntPoint(1, 1);
	uint16 Depth = 1;
	uint16 ArraySize = 1;
	uint8 NumMips = 1;
	uint8 NumSamples = 1;
	ETextureDimension Dimension = ETextureDimension::Texture2D;
	EPixelFormat Format = PF_Unknown;
	EPixelFormat UAVFormat = PF_Unknown; // PF_Unknown: as Format
};

DRYDOCK_API uint32 GetTypeHash(const FRHITextureDesc& Desc);

/** A description with a name, filled by chained setters, for RHICreateTexture. */
struct FRHITextureCreateDesc : FRHITextureDesc
{
	FRHITextureCreateDesc() = default;
	FRHITextureCreateDesc(const FRHITextureDesc& InDesc, const TCHAR* InDebugName)
		: FRHITextureDesc(InDesc)
		, DebugName(InDebugName)
	{
	}
	FRHITextureCreateDesc(const TCHAR* InDebugName, ETextureDimension InDimension)
		: FRHITextureDesc(InDimension)
		, DebugName(InDebugName)
	{
	}

	static FRHITextureCreateDesc Create(const TCHAR* Name, ETextureDimension InDimension)
	{
		return {Name, InDimension};
	}
	static FRHITextureCreateDesc Create2D(const TCHAR* Name) { return {Name, ETextureDimension::Texture2D}; }
	static FRHITextureCreateDesc Create2D(const TCHAR* Name, FIntPoint Size, EPixelFormat InFormat)
	{
		return Create2D(Name).SetExtent(Size).SetFormat(InFormat);
	}
	static FRHITextureCreateDesc Create2D(const TCHAR* Name, int32 SizeX, int32 SizeY, EPixelFormat InFormat)
	{
		return Create2D(Name, FIntPoint(SizeX, SizeY), InFormat);
	}
	static FRHITextureCreateDesc Create2DArray(
		const TCHAR* Name, FIntPoint Size, uint16 InArraySize, EPixelFormat InFormat)
	{
		return Create(Name, ETextureDimension::Texture2DArray)
			.SetExtent(Size)
			.SetArraySize(InArraySize)
			.SetFormat(InFormat);
	}
	static FRHITextureCreateDesc Create3D(const TCHAR* Name, FIntVector Size, EPixelFormat InFormat)
	{
		return Create(Name, ETextureDimension::Texture3D)
			.SetExtent(FIntPoint(Size.X, Size.Y))
			.SetDepth(uint16(Size.Z))
			.SetFormat(InFormat);
	}
	static FRHITextureCreateDesc CreateCube(const TCHAR* Name, uint32 Size, EPixelFormat InFormat)
	{
		return Create(Name, ETextureDimension::TextureCube)
			.SetExtent(FIntPoint(int32(Size), int32(Size)))
			.SetFormat(InFormat);
	}

	FRHITextureCreateDesc& SetFlags(ETextureCreateFlags InFlags) { return With(Flags, InFlags); }
	FRHITextureCreateDesc& AddFlags(ETextureCreateFlags InFlags) { return With(Flags, Flags | InFlags); }
	FRHITextureCreateDesc& SetClearValue(FClearValueBinding InClearValue) { return With(ClearValue, InClearValue); }
	FRHITextureCreateDesc& SetExtData(uint32 InExtData) { return With(ExtData, InExtData); }
	FRHITextureCreateDesc& SetExtent(FIntPoint InExtent) { return With(Extent, InExtent); }
	FRHITextureCreateDesc& SetExtent(int32 X, int32 Y) { return With(Extent, FIntPoint(X, Y)); }
	FRHITextureCreateDesc& SetDepth(uint16 InDepth) { return With(Depth, InDepth); }
	FRHITextureCreateDesc& SetArraySize(uint16 InArraySize) { return With(ArraySize, InArraySize); }
	FRHITextureCreateDesc& SetNumMips(uint8 InNumMips) { return With(NumMips, InNumMips); }
	FRHITextureCreateDesc& SetNumSamples(uint8 InNumSamples) { return With(NumSamples, InNumSamples); }
	FRHITextureCreateDesc& SetFormat(EPixelFormat InFormat) { return With(Format, InFormat); }
	FRHITextureCreateDesc& SetUAVFormat(EPixelFormat InFormat) { return With(UAVFormat, InFormat); }
	FRHITextureCreateDesc& SetInitialState(ERHIAccess InState) { return With(InitialState, InState); }
	FRHITextureCreateDesc& SetDebugName(const TCHAR* Name) { return With(DebugName, Name); }
	FRHITextureCreateDesc& DetermineInititialState() { return *this; }

	const TCHAR* DebugName = TEXT("");
	ERHIAccess InitialState = ERHIAccess::Unknown;

private:
	template<typename T>
	FRHITextureCreateDesc& With(T& Member, const std::type_identity_t<T>& Value)
	{
		Member = Value;
		return *this;
	}
};

struct FRHIBufferDesc
{
	FRHIBufferDesc() = default;
	FRHIBufferDesc(uint32 InSize, uint32 InStride, EBufferUsageFlags InUsage)
		: Size(InSize)
		, Stride(InStride)
		, Usage(InUsage)
	{
	}

	bool operator==(const FRHIBufferDesc& Other) const
	{
		return Size == Other.Size && Stride == Other.Stride && Usage == Other.Usage;
	}
	bool operator!=(const FRHIBufferDesc& Other) const { return !(*this == Other); }

	uint32 Size = 0;   // bytes
	uint32 Stride = 0; // bytes per element; 0 where the format of a view says it
	EBufferUsageFlags Usage = EBufferUsageFlags::None;
};
