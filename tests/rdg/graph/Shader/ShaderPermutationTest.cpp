// Permutation dimensions and domains: ids, values and defines.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ShaderPermutation.h"

namespace
{

enum class EOutputDevice
{
	SRGB,
	Rec709,
	Linear,
	MAX
};

class FUseBloomDim : SHADER_PERMUTATION_BOOL("USE_BLOOM");
class FQualityDim : SHADER_PERMUTATION_INT("QUALITY", 5);
class FTapsDim : SHADER_PERMUTATION_RANGE_INT("TAPS", 3, 4);
class FTileDim : SHADER_PERMUTATION_SPARSE_INT("TILE", 8, 16, 32);
class FDeviceDim : SHADER_PERMUTATION_ENUM_CLASS("DEVICE", EOutputDevice);

using FFlatDomain = TShaderPermutationDomain<FUseBloomDim, FQualityDim, FTileDim>;
using FInnerDomain = TShaderPermutationDomain<FUseBloomDim, FDeviceDim>;
using FOuterDomain = TShaderPermutationDomain<FTapsDim, FInnerDomain>;

std::string FindDefine(const FShaderCompilerEnvironment& Environment, const std::string& Name)
{
	for (const auto& [DefinedName, Value] : Environment.GetDefines())
	{
		if (DefinedName == Name)
		{
			return Value;
		}
	}
	return "undefined";
}

template<typename TDomain>
FShaderCompilerEnvironment DefinesOf(const TDomain& Domain)
{
	FShaderCompilerEnvironment Environment;
	Domain.ModifyCompilationEnvironment(Environment);
	return Environment;
}

} // namespace

TEST(ShaderPermutation, NoDimensionsMakeOnePermutation)
{
	EXPECT_EQ(1, FShaderPermutationNone::PermutationCount);
	EXPECT_EQ(0, FShaderPermutationNone().ToDimensionValueId());
}

TEST(ShaderPermutation, CountIsTheProductOfTheDimensions)
{
	EXPECT_EQ(2 * 5 * 3, FFlatDomain::PermutationCount);
}

TEST(ShaderPermutation, FirstDimensionVariesFastest)
{
	FFlatDomain Domain;
	Domain.Set<FUseBloomDim>(true);
	Domain.Set<FQualityDim>(3);
	Domain.Set<FTileDim>(8);
	EXPECT_EQ(1 + 2 * (3 + 5 * 2), Domain.ToDimensionValueId());
}

TEST(ShaderPermutation, SparseIdsRunBackward)
{
	EXPECT_EQ(2, FTileDim::ToDimensionValueId(8));
	EXPECT_EQ(1, FTileDim::ToDimensionValueId(16));
	EXPECT_EQ(0, FTileDim::ToDimensionValueId(32));
	EXPECT_EQ(8, FTileDim::FromDimensionValueId(2));
}

TEST(ShaderPermutation, RangeIdsCountFromTheStart)
{
	EXPECT_EQ(0, FTapsDim::ToDimensionValueId(3));
	EXPECT_EQ(3, FTapsDim::ToDimensionValueId(6));
	EXPECT_EQ(4, FTapsDim::FromDimensionValueId(1));
}

TEST(ShaderPermutation, EnumClassCountsUpToMax)
{
	EXPECT_EQ(3, FDeviceDim::PermutationCount);
	EXPECT_EQ(EOutputDevice::Linear, FDeviceDim::FromDimensionValueId(2));
}

TEST(ShaderPermutation, DefaultIsEveryDimensionAtIdZero)
{
	EXPECT_FALSE(FFlatDomain().Get<FUseBloomDim>());
	EXPECT_EQ(0, FFlatDomain().Get<FQualityDim>());
	EXPECT_EQ(32, FFlatDomain().Get<FTileDim>());
}

TEST(ShaderPermutation, NestedDomainIsOneDigit)
{
	FInnerDomain Inner;
	Inner.Set<FUseBloomDim>(true);
	Inner.Set<FDeviceDim>(EOutputDevice::Rec709);
	FOuterDomain Outer;
	Outer.Set<FTapsDim>(5);
	Outer.Set<FInnerDomain>(Inner);
	EXPECT_EQ(2 + 4 * (1 + 2 * 1), Outer.ToDimensionValueId());
}

TEST(ShaderPermutation, NestedDomainReadsBackFromItsId)
{
	const FOuterDomain Outer(2 + 4 * (1 + 2 * 1));
	EXPECT_EQ(5, Outer.Get<FTapsDim>());
	EXPECT_TRUE(Outer.Get<FInnerDomain>().Get<FUseBloomDim>());
	EXPECT_EQ(EOutputDevice::Rec709, Outer.Get<FInnerDomain>().Get<FDeviceDim>());
}

RC_GTEST_PROP(ShaderPermutation, IdsAndDomainsMapOneToOne, ())
{
	const int Id = *rc::gen::inRange(0, FOuterDomain::PermutationCount);
	RC_ASSERT(FOuterDomain(Id).ToDimensionValueId() == Id);
}

TEST(ShaderPermutation, DefinesAreTheValues)
{
	FFlatDomain Domain;
	Domain.Set<FUseBloomDim>(true);
	Domain.Set<FQualityDim>(4);
	Domain.Set<FTileDim>(16);
	EXPECT_EQ("1", FindDefine(DefinesOf(Domain), "USE_BLOOM"));
	EXPECT_EQ("4", FindDefine(DefinesOf(Domain), "QUALITY"));
	EXPECT_EQ("16", FindDefine(DefinesOf(Domain), "TILE"));
}

TEST(ShaderPermutation, DefinesOfNestedDomainsAreFlat)
{
	FInnerDomain Inner;
	Inner.Set<FDeviceDim>(EOutputDevice::Linear);
	FOuterDomain Outer;
	Outer.Set<FInnerDomain>(Inner);
	EXPECT_EQ("2", FindDefine(DefinesOf(Outer), "DEVICE"));
	EXPECT_EQ("0", FindDefine(DefinesOf(Outer), "USE_BLOOM"));
	EXPECT_EQ("3", FindDefine(DefinesOf(Outer), "TAPS"));
}

TEST(ShaderPermutation, ValueOutsideTheRangeIsACheck)
{
	FFlatDomain Domain;
	Domain.Set<FQualityDim>(5);
	EXPECT_THROW(Domain.ToDimensionValueId(), Drydock::FCheckFailure);
}

TEST(ShaderPermutation, ValueMissingFromASparseListIsACheck)
{
	FFlatDomain Domain;
	Domain.Set<FTileDim>(64);
	EXPECT_THROW(Domain.ToDimensionValueId(), Drydock::FCheckFailure);
}

TEST(ShaderPermutation, IdBeyondTheDomainIsACheck)
{
	EXPECT_THROW(FFlatDomain(30), Drydock::FCheckFailure);
	EXPECT_THROW(FFlatDomain(-1), Drydock::FCheckFailure);
}

TEST(ShaderPermutation, EqualityComparesValues)
{
	FFlatDomain Domain;
	EXPECT_TRUE(Domain == FFlatDomain());
	Domain.Set<FQualityDim>(1);
	EXPECT_FALSE(Domain == FFlatDomain());
}
