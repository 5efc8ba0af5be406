// Where the members of a parameter struct lie: HLSL's rule that nothing straddles 16 bytes.
#include <gtest/gtest.h>

#include "ShaderParameterStructs.h"

static_assert(offsetof(FTestLayout, A) == 0);
static_assert(offsetof(FTestLayout, B) == 8, "two floats align to 8");
static_assert(offsetof(FTestLayout, C) == 16, "three floats align to 16");
static_assert(offsetof(FTestLayout, D) == 28, "a float fills the fourth component");
static_assert(offsetof(FTestLayout, E) == 32);
static_assert(offsetof(FTestLayout, F) == 48, "a rectangle aligns to 16");
static_assert(offsetof(FTestLayout, G) == 64);
static_assert(offsetof(FTestLayout, H) == 80, "a matrix aligns to 16");
static_assert(offsetof(FTestLayout, I) == 144, "three integers align to 16");
static_assert(offsetof(FTestLayout, J) == 160, "two integers align to 8 and do not fit behind three");
static_assert(offsetof(FTestLayout, K) == 176, "a colour aligns to 16");
static_assert(offsetof(FTestLayout, L) == 192);
static_assert(offsetof(FTestLayout, M) == 208, "seven scalars take two registers");
static_assert(offsetof(FTestLayout, N) == 240, "array elements are 16 bytes apart");
static_assert(offsetof(FTestLayout, O) == 288);
static_assert(offsetof(FTestLayout, P) == 296, "pointers align to 8");
static_assert(offsetof(FTestLayout, Q) == 304);
static_assert(offsetof(FTestLayout, R) == 320);
static_assert(sizeof(FTestLayout) == 336);
static_assert(alignof(FTestLayout) == 16);
static_assert(sizeof(FTestViewport) == 32, "a struct's size is a multiple of 16");
static_assert(offsetof(FTestEverything, Levels) % 16 == 0);
static_assert(offsetof(FTestEverything, RenderTargets) % 16 == 0);

TEST(ShaderParameterLayout, MetadataRepeatsTheOffsets)
{
	const FShaderParametersMetadata& Metadata = *FTestLayout::FTypeInfo::GetStructMetadata();
	EXPECT_EQ(28u, Metadata.FindMemberByName(TEXT("D"))->GetOffset());
	EXPECT_EQ(144u, Metadata.FindMemberByName(TEXT("I"))->GetOffset());
	EXPECT_EQ(296u, Metadata.FindMemberByName(TEXT("P"))->GetOffset());
	EXPECT_EQ(336u, Metadata.GetSize());
}

TEST(ShaderParameterLayout, MembersStartAtZero)
{
	const FTestLayout Layout;
	EXPECT_EQ(0.0f, Layout.A);
	EXPECT_EQ(0, Layout.E);
	EXPECT_EQ(nullptr, Layout.P);
	EXPECT_EQ(0.0f, GET_SCALAR_ARRAY_ELEMENT(Layout.M, 6));
}

TEST(ShaderParameterLayout, ScalarArrayElementsLieOneAfterAnother)
{
	FTestLayout Layout;
	for (int32 Index = 0; Index < 7; ++Index)
	{
		GET_SCALAR_ARRAY_ELEMENT(Layout.M, Index) = static_cast<float>(Index);
	}
	const float* Floats = reinterpret_cast<const float*>(&Layout.M);
	EXPECT_EQ(0.0f, Floats[0]);
	EXPECT_EQ(4.0f, Floats[4]);
	EXPECT_EQ(6.0f, Floats[6]);
}

TEST(ShaderParameterLayout, LooseScalarArraysLookTheSame)
{
	DECLARE_SCALAR_ARRAY(uint32, Counts, 6);
	GET_SCALAR_ARRAY_ELEMENT(Counts, 5) = 7u;
	EXPECT_EQ(32u, sizeof(Counts));
	EXPECT_EQ(7u, reinterpret_cast<const uint32*>(&Counts)[5]);
}

TEST(ShaderParameterLayout, MemberSizesFollowFromTheirTypes)
{
	const FShaderParametersMetadata& Metadata = *FTestLayout::FTypeInfo::GetStructMetadata();
	EXPECT_EQ(4u, Metadata.FindMemberByName(TEXT("A"))->GetMemberSize());
	EXPECT_EQ(12u, Metadata.FindMemberByName(TEXT("C"))->GetMemberSize());
	EXPECT_EQ(64u, Metadata.FindMemberByName(TEXT("H"))->GetMemberSize());
	EXPECT_EQ(32u, Metadata.FindMemberByName(TEXT("M"))->GetMemberSize());
	EXPECT_EQ(48u, Metadata.FindMemberByName(TEXT("N"))->GetMemberSize());
	EXPECT_EQ(8u, Metadata.FindMemberByName(TEXT("P"))->GetMemberSize());
}
