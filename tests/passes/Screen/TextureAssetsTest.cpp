// Pixels behind a path: who loads them, how often, and what they hold.
#include <gtest/gtest.h>

#include "Screen/BuiltinTextures.h"
#include "Screen/TextureAssets.h"
#include "SettingObjects.h"

#include <stdexcept>

using namespace Drydock;

namespace
{

FTextureRHIRef MakeOne(float Value)
{
	return MakePictureTexture(FIntPoint(1, 1), {FLinearColor(Value, Value, Value, 1.0f)}, "One");
}

} // namespace

TEST(TextureAssets, APathIsLoadedOnceForALoader)
{
	int NumLoads = 0;
	const FScopedTextureLoader Loader(
		[&](const std::string&)
		{
			++NumLoads;
			return MakeOne(1.0f);
		});
	const FTextureRHIRef First = FindTexturePixels("/Game/A.A");
	EXPECT_EQ(First.GetReference(), FindTexturePixels("/Game/A.A").GetReference());
	EXPECT_EQ(First.GetReference(), FindTexturePixels(FindOrAddTexture("/Game/A.A")).GetReference());
	EXPECT_EQ(1, NumLoads);
	EXPECT_NE(First.GetReference(), FindTexturePixels("/Game/B.B").GetReference());
}

TEST(TextureAssets, TheLoaderBeforeItComesBack)
{
	const FTextureRHIRef OuterPixels = MakeOne(1.0f), InnerPixels = MakeOne(2.0f);
	const FScopedTextureLoader Outer([&](const std::string&) { return OuterPixels; });
	{
		const FScopedTextureLoader Inner([&](const std::string&) { return InnerPixels; });
		EXPECT_EQ(InnerPixels.GetReference(), FindTexturePixels("/Game/A.A").GetReference());
	}
	EXPECT_EQ(OuterPixels.GetReference(), FindTexturePixels("/Game/A.A").GetReference());
}

TEST(TextureAssets, NoTextureAndNoPixelsAreNull)
{
	const FScopedTextureLoader Loader([](const std::string&) { return nullptr; });
	EXPECT_FALSE(FindTexturePixels(static_cast<const UTexture*>(nullptr)));
	EXPECT_FALSE(FindTexturePixels("/Game/A.A"));
}

TEST(TextureAssets, WhatALoaderThrowsIsThrownAndNotKept)
{
	bool bBroken = true;
	const FScopedTextureLoader Loader(
		[&](const std::string&) { return bBroken ? throw std::runtime_error("broken") : MakeOne(1.0f); });
	EXPECT_THROW(FindTexturePixels("/Game/A.A"), std::runtime_error);
	bBroken = false;
	EXPECT_TRUE(FindTexturePixels("/Game/A.A"));
}

TEST(TextureAssets, BuiltinPicturesNeedNoLoader)
{
	const FTextureRHIRef Pixels = FindTexturePixels("Builtin/Airy");
	ASSERT_TRUE(Pixels);
	EXPECT_EQ(FIntPoint(BuiltinKernelSize, BuiltinKernelSize), Pixels->GetDesc().Extent);
}

TEST(TextureAssets, PicturesAreRowMajor)
{
	const FTextureRHIRef Pixels =
		MakePictureTexture(FIntPoint(2, 1), {FLinearColor(1, 2, 3, 4), FLinearColor(5, 6, 7, 8)}, "Two");
	const FVector4 Right = Pixels->ReadTexelDouble(1, 0);
	EXPECT_EQ(5, Right.X);
	EXPECT_EQ(8, Right.W);
}
