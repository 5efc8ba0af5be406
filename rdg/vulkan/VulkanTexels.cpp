// Chooses formats and converts rows.
#include "VulkanTexels.h"

#include "TexelRows.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace Drydock
{

namespace
{

VkFormat GetWideFormat(int32_t Channels, ESpirvType Scalar)
{
	const VkFormat One = Scalar == ESpirvType::Float ? VK_FORMAT_R32_SFLOAT
						 : Scalar == ESpirvType::Int ? VK_FORMAT_R32_SINT
													 : VK_FORMAT_R32_UINT;
	constexpr int FormatsPerChannel = VK_FORMAT_R32G32_UINT - VK_FORMAT_R32_UINT;
	return VkFormat(int(One) + (Channels - 1) * FormatsPerChannel);
}

/** Channels of a texel that a driver has formats of. */
int32_t GetNumChannels(ETexelStorage Storage)
{
	const int32_t Channels = GetTexelStorageInfo(Storage).NumChannels;
	return Channels == 3 ? 4 : Channels;
}

/** Whether half floats hold all its values. */
bool FitsHalf(ETexelStorage Storage)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	return Info.Kind == ETexelKind::Float && Info.BitsPerChannel <= 16;
}

bool Has(const FVulkanDevice& Device, VkFormat Format, VkFormatFeatureFlags Features)
{
	return (Device.GetFormat(Format).optimalTilingFeatures & Features) == Features;
}

} // namespace

FVulkanTexels ChooseSampledTexels(const FVulkanDevice& Device, ETexelStorage Storage, ESpirvType Scalar, bool bFiltered)
{
	FVulkanTexels Result;
	Result.bUint = GetTexelStorageInfo(Storage).Kind == ETexelKind::Uint;
	if (Result.bUint != (Scalar != ESpirvType::Float))
	{
		throw FVulkanError(std::string("a texture of format ") + GetTexelStorageInfo(Storage).Name +
						   " is read as another kind of number");
	}
	Result.Channels = GetNumChannels(Storage);
	Result.Format = GetWideFormat(Result.Channels, Scalar);
	if (!bFiltered || Result.bUint)
	{
		return Result;
	}
	constexpr VkFormatFeatureFlags Filtered =
		VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
	if (!Has(Device, Result.Format, Filtered) && FitsHalf(Storage))
	{
		Result.bHalf = true;
		Result.Format = Result.Channels == 1   ? VK_FORMAT_R16_SFLOAT
						: Result.Channels == 2 ? VK_FORMAT_R16G16_SFLOAT
											   : VK_FORMAT_R16G16B16A16_SFLOAT;
	}
	if (!Has(Device, Result.Format, Filtered))
	{
		throw FVulkanError(std::string("it does not filter textures of format ") + GetTexelStorageInfo(Storage).Name);
	}
	return Result;
}

FVulkanTexels GetStorageTexels(uint32_t SpirvFormat, ETexelStorage Storage)
{
	struct FKnown
	{
		uint32_t Format; // SPIR-V specification, 3.11
		int32_t Channels;
		ESpirvType Scalar;
	};
	static constexpr FKnown Known[] = {
		{1, 4, ESpirvType::Float},
		{3, 1, ESpirvType::Float},
		{6, 2, ESpirvType::Float},
		{21, 4, ESpirvType::Int},
		{24, 1, ESpirvType::Int},
		{25, 2, ESpirvType::Int},
		{30, 4, ESpirvType::Uint},
		{33, 1, ESpirvType::Uint},
		{35, 2, ESpirvType::Uint},
	};
	const FKnown* const Found = std::ranges::find(Known, SpirvFormat, &FKnown::Format);
	if (Found == std::end(Known))
	{
		throw FVulkanError("the shader declares a texture that it writes with image format " +
						   std::to_string(SpirvFormat) + ", and drydock knows those of 32-bit channels");
	}
	FVulkanTexels Result;
	Result.bUint = Found->Scalar != ESpirvType::Float;
	Result.Channels = Found->Channels;
	Result.Format = GetWideFormat(Found->Channels, Found->Scalar);
	if (Result.bUint != (GetTexelStorageInfo(Storage).Kind == ETexelKind::Uint))
	{
		throw FVulkanError(std::string("a texture of format ") + GetTexelStorageInfo(Storage).Name +
						   " is written as another kind of number");
	}
	return Result;
}

void ReadTexels(ETexelStorage Storage, const uint8_t* From, int32_t Count, const FVulkanTexels& Texels, uint8_t* Out)
{
	const size_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	if (Texels.bUint)
	{
		for (int32_t i = 0; i < Count; ++i)
		{
			uint32_t RGBA[4];
			DecodeTexel(Storage, From + size_t(i) * Bytes, RGBA);
			std::memcpy(Out + size_t(i) * Texels.GetBytes(), RGBA, Texels.GetBytes());
		}
		return;
	}
	if (!Texels.bHalf)
	{
		DecodeTexelRow(Storage, From, Count, Texels.Channels, reinterpret_cast<float*>(Out));
		return;
	}
	std::vector<float> Values(size_t(Count) * size_t(Texels.Channels));
	DecodeTexelRow(Storage, From, Count, Texels.Channels, Values.data());
	for (size_t i = 0; i < Values.size(); ++i)
	{
		const uint16_t Half = EncodeHalf(double(Values[i]));
		std::memcpy(Out + i * sizeof(Half), &Half, sizeof(Half));
	}
}

void WriteTexels(ETexelStorage Storage, const uint8_t* Values, int32_t Count, const FVulkanTexels& Texels,
	bool bSaturate, uint8_t* To)
{
	const size_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	if (Texels.Channels == 4 && !Texels.bUint)
	{
		EncodeTexelRow(Storage, reinterpret_cast<const float*>(Values), Count, To, bSaturate);
		return;
	}
	for (int32_t i = 0; i < Count; ++i)
	{
		uint8_t* const Texel = To + size_t(i) * Bytes;
		const uint8_t* const Value = Values + size_t(i) * Texels.GetBytes();
		if (Texels.bUint)
		{
			uint32_t RGBA[4];
			DecodeTexel(Storage, Texel, RGBA);
			std::memcpy(RGBA, Value, Texels.GetBytes());
			EncodeTexel(Storage, RGBA, Texel);
		}
		else
		{
			float RGBA[4];
			DecodeTexel(Storage, Texel, RGBA);
			std::memcpy(RGBA, Value, Texels.GetBytes());
			EncodeTexel(Storage, RGBA, Texel, bSaturate);
		}
	}
}

} // namespace Drydock
