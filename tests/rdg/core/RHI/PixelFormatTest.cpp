// The table of pixel formats has the engine's numbers, and names that lead both ways.
#include <gtest/gtest.h>

#include "PixelFormat.h"

TEST(PixelFormat, NumbersAreTheEngines)
{
	EXPECT_EQ(1, PF_A32B32G32R32F);
	EXPECT_EQ(10, PF_FloatRGBA);
	EXPECT_EQ(18, PF_A2B10G10R10);
	EXPECT_EQ(26, PF_FloatR11G11B10);
	EXPECT_EQ(37, PF_R8G8B8A8);
	EXPECT_EQ(49, PF_R16G16_UINT);
}

TEST(PixelFormat, BytesPerTexel)
{
	EXPECT_EQ(16, GPixelFormats[PF_A32B32G32R32F].BlockBytes);
	EXPECT_EQ(8, GPixelFormats[PF_FloatRGBA].BlockBytes);
	EXPECT_EQ(4, GPixelFormats[PF_FloatRGB].BlockBytes);
	EXPECT_EQ(2, GPixelFormats[PF_R16F].BlockBytes);
	EXPECT_EQ(1, GPixelFormats[PF_G8].BlockBytes);
}

TEST(PixelFormat, NumbersOfComponents)
{
	EXPECT_EQ(4, GPixelFormats[PF_B8G8R8A8].NumComponents);
	EXPECT_EQ(3, GPixelFormats[PF_FloatRGB].NumComponents);
	EXPECT_EQ(2, GPixelFormats[PF_G16R16F].NumComponents);
	EXPECT_EQ(1, GPixelFormats[PF_R8_UINT].NumComponents);
}

TEST(PixelFormat, NamesGoBothWays)
{
	EXPECT_STREQ("PF_FloatRGBA", GetPixelFormatString(PF_FloatRGBA));
	EXPECT_EQ(PF_FloatRGBA, GetPixelFormatFromString(TEXT("PF_FloatRGBA")));
	EXPECT_EQ(PF_FloatRGBA, GetPixelFormatFromString(TEXT("floatrgba")));
}

TEST(PixelFormat, AnUnknownNameIsPFUnknown)
{
	EXPECT_EQ(PF_Unknown, GetPixelFormatFromString(TEXT("PF_DXT1")));
	EXPECT_STREQ("PF_unknown", GetPixelFormatString(EPixelFormat(5)));
	EXPECT_FALSE(GPixelFormats[5].Supported);
}

TEST(PixelFormat, EveryStoredFormatFindsItselfByName)
{
	int32 NumSupported = 0;
	for (int32 Format = 0; Format < PF_MAX; ++Format)
	{
		if (GPixelFormats[Format].Supported)
		{
			++NumSupported;
			EXPECT_EQ(Format, GetPixelFormatFromString(GPixelFormats[Format].Name));
			EXPECT_EQ(Format, GPixelFormats[Format].UnrealFormat);
		}
	}
	EXPECT_EQ(36, NumSupported);
}

TEST(PixelFormat, Kinds)
{
	EXPECT_TRUE(IsInteger(PF_R8_UINT));
	EXPECT_FALSE(IsInteger(PF_R8G8B8A8));
	EXPECT_TRUE(IsFloatFormat(PF_FloatRGB));
	EXPECT_FALSE(IsFloatFormat(PF_A2B10G10R10));
	EXPECT_TRUE(IsDepthOrStencilFormat(PF_DepthStencil));
}

TEST(PixelFormat, StoredFormatsCanDoEverythingAndOthersNothing)
{
	constexpr EPixelFormatCapabilities Typed =
		EPixelFormatCapabilities::TypedUAVLoad | EPixelFormatCapabilities::TypedUAVStore;
	EXPECT_EQ(Typed, GPixelFormats[PF_FloatRGBA].Capabilities & Typed);
	EXPECT_TRUE(UE::PixelFormat::HasCapabilities(PF_R8_UINT, Typed | EPixelFormatCapabilities::AnyTexture));
	EXPECT_EQ(EPixelFormatCapabilities::None, GPixelFormats[PF_Unknown].Capabilities);
	EXPECT_FALSE(RHIPixelFormatHasCapabilities(PF_Unknown, EPixelFormatCapabilities::Texture2D));
}
