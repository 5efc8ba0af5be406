// Texture descriptions: clear-value constants, comparison, validity. Source: engine RHI.cpp, RHIResources.h.
#include "RHITextureDesc.h"

#include <algorithm>
#include <bit>
#include <initializer_list>

constinit const FClearValueBinding FClearValueBinding::None(EClearBinding::ENoneBound);
constinit const FClearValueBinding FClearValueBinding::Black(0.0f, 0.0f, 0.0f, 1.0f);
constinit const FClearValueBinding FClearValueBinding::BlackMaxAlpha(0.0f, 0.0f, 0.0f, FLT_MAX);
constinit const FClearValueBinding FClearValueBinding::White(1.0f, 1.0f, 1.0f, 1.0f);
constinit const FClearValueBinding FClearValueBinding::Transparent(0.0f, 0.0f, 0.0f, 0.0f);
constinit const FClearValueBinding FClearValueBinding::DepthOne(1.0f, 0u);
constinit const FClearValueBinding FClearValueBinding::DepthZero(0.0f, 0u);
constinit const FClearValueBinding FClearValueBinding::DepthNear(1.0f, 0u);
constinit const FClearValueBinding FClearValueBinding::DepthFar(0.0f, 0u);
constinit const FClearValueBinding FClearValueBinding::Green(0.0f, 1.0f, 0.0f, 1.0f);
constinit const FClearValueBinding FClearValueBinding::DefaultNormal8Bit(
	128.0f / 255.0f, 128.0f / 255.0f, 128.0f / 255.0f, 1.0f);

namespace
{

/** FNV-1a over whole words: the same on every run, so that nothing ordered by a hash changes. */
uint32 HashWords(std::initializer_list<uint32> Words)
{
	uint32 Hash = 2166136261u;
	for (uint32 Word : Words)
	{
		Hash = (Hash ^ Word) * 16777619u;
		Hash ^= Hash >> 15;
	}
	return Hash;
}

} // namespace

bool FClearValueBinding::operator==(const FClearValueBinding& Other) const
{
	if (ColorBinding != Other.ColorBinding)
	{
		return false;
	}
	switch (ColorBinding)
	{
	case EClearBinding::EColorBound:
		return std::equal(Value.Color, Value.Color + 4, Other.Value.Color);
	case EClearBinding::EDepthStencilBound:
		return Value.DSValue.Depth == Other.Value.DSValue.Depth && Value.DSValue.Stencil == Other.Value.DSValue.Stencil;
	case EClearBinding::ENoneBound:
		break;
	}
	return true;
}

uint32 GetTypeHash(const FClearValueBinding& Binding)
{
	// Adding 0 makes -0 hash as 0, which it equals.
	const auto Bits = [](float Value)
	{
		return std::bit_cast<uint32>(Value + 0.0f);
	};
	switch (Binding.ColorBinding)
	{
	case EClearBinding::EColorBound:
	{
		const float* Color = Binding.Value.Color;
		return HashWords({1, Bits(Color[0]), Bits(Color[1]), Bits(Color[2]), Bits(Color[3])});
	}
	case EClearBinding::EDepthStencilBound:
		return HashWords({2, Bits(Binding.Value.DSValue.Depth), Binding.Value.DSValue.Stencil});
	case EClearBinding::ENoneBound:
		break;
	}
	return HashWords({0});
}

bool FRHITextureDesc::IsValid(FString* OutReason) const
{
	const auto Fail = [OutReason](const TCHAR* Reason)
	{
		if (OutReason)
		{
			*OutReason = FString(Reason);
		}
		return false;
	};

	if (Format == PF_Unknown || Format >= PF_MAX || !GPixelFormats[Format].Supported || Format == PF_X24_G8)
	{
		return Fail(TEXT("the format is none that a texture can have"));
	}
	if (Extent.X <= 0 || Extent.Y <= 0 || Depth == 0)
	{
		return Fail(TEXT("the extent must be at least one texel in every direction"));
	}
	if (Extent.X > GMaxTextureDimensions || Extent.Y > GMaxTextureDimensions || Depth > GMaxTextureDimensions)
	{
		return Fail(TEXT("the extent must be at most 16384 texels in every direction"));
	}
	if (ArraySize == 0 || NumMips == 0)
	{
		return Fail(TEXT("there must be at least one array slice and one mip"));
	}
	if (NumSamples < 1 || NumSamples > 8)
	{
		return Fail(TEXT("the number of samples must lie in 1..8"));
	}
	if (NumMips > GMaxTextureMipCount || NumMips > std::bit_width(uint32(std::max({Extent.X, Extent.Y, int32(Depth)}))))
	{
		return Fail(TEXT("there are more mips than the extent allows"));
	}
	if (NumSamples > 1 && !IsTexture2D())
	{
		return Fail(TEXT("only 2D textures can be multisampled"));
	}
	if (IsTexture3D() ? ArraySize != 1 : Depth != 1)
	{
		return Fail(TEXT("only 3D textures have depth, and they have no array slices"));
	}
	if (IsTextureCube() && Extent.X != Extent.Y)
	{
		return Fail(TEXT("the faces of a cube must be as wide as high"));
	}
	if (!IsTextureArray() && ArraySize != 1)
	{
		return Fail(TEXT("only array textures have more than one array slice"));
	}
	return true;
}

bool FRHITextureDesc::operator==(const FRHITextureDesc& Other) const
{
	return Flags == Other.Flags && ClearValue == Other.ClearValue && ExtData == Other.ExtData &&
		   Extent == Other.Extent && Depth == Other.Depth && ArraySize == Other.ArraySize && NumMips == Other.NumMips &&
		   NumSamples == Other.NumSamples && Dimension == Other.Dimension && Format == Other.Format &&
		   UAVFormat == Other.UAVFormat;
}

uint32 GetTypeHash(const FRHITextureDesc& Desc)
{
	return HashWords({uint32(Desc.Dimension), uint32(uint64(Desc.Flags)), uint32(uint64(Desc.Flags) >> 32),
		uint32(Desc.Format), uint32(Desc.UAVFormat), uint32(Desc.Extent.X), uint32(Desc.Extent.Y), Desc.Depth,
		Desc.ArraySize, Desc.NumMips, Desc.NumSamples, GetTypeHash(Desc.ClearValue), Desc.ExtData});
}
