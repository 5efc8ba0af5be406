// Names, identity and memory layout of HLSL's types. Layouts: the worked examples of Microsoft's "Packing Rules for
// Constant Variables", and C++ structs for structured buffers.
#include <gtest/gtest.h>

#include "HlslTypes.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Drydock::Hlsl::Tests
{
namespace
{

FStructType MakeTypesStruct(const std::string& Name, const std::vector<const FType*>& Members)
{
	FStructType Struct;
	Struct.Name = Name;
	for (const FType* const Type : Members)
	{
		FMember Member;
		Member.Name = "M" + std::to_string(Struct.Members.size());
		Member.Type = Type;
		Struct.Members.push_back(Member);
	}
	return Struct;
}

const char* const GTypesScalars[] = {"bool", "int", "uint", "dword", "half", "float", "double", "min16float",
	"min10float", "min16int", "min12int", "min16uint", "float16_t", "float32_t", "float64_t", "int16_t", "int32_t",
	"int64_t", "uint16_t", "uint32_t", "uint64_t"};

TEST(HlslTypes, EachSpellingIsFoundAndItsNameIsASpellingOfIt)
{
	for (const bool bRealHalf : {false, true})
	{
		FTypes Types(bRealHalf);
		for (const std::string Scalar : GTypesScalars)
		{
			std::vector<std::string> Names = {Scalar};
			for (char A = '1'; A <= '4'; ++A)
			{
				Names.push_back(Scalar + A);
				for (char B = '1'; B <= '4'; ++B)
				{
					Names.push_back(Scalar + A + "x" + B);
				}
			}
			for (const std::string& Name : Names)
			{
				const FType* const Type = Types.FindNumeric(Name, EOrder::Column);
				ASSERT_NE(Type, nullptr) << Name;
				EXPECT_EQ(Types.FindNumeric(GetName(Type), EOrder::Column), Type) << Name << " is " << GetName(Type);
				const std::string Size = Name.substr(Scalar.size());
				EXPECT_EQ(Type->IsScalar(), Size.empty());
				EXPECT_EQ(Type->IsVector(), Size.size() == 1);
				EXPECT_EQ(Type->IsMatrix(), Size.size() == 3);
				EXPECT_EQ(Type->Columns, Size.empty() ? 1 : Size.back() - '0');
				EXPECT_EQ(Type->Rows, Type->IsMatrix() ? Size[0] - '0' : 1);
			}
		}
		for (const char* const Name : {"float5", "float0", "float2x5", "float2x", "float22", "floats", "int8_t",
				 "FItem", "", "float2x2x2", "Float", "uint3 "})
		{
			EXPECT_EQ(Types.FindNumeric(Name, EOrder::Row), nullptr) << Name;
		}
		EXPECT_EQ(GetName(Types.FindNumeric("vector", EOrder::Row)), "float4");
		EXPECT_EQ(GetName(Types.FindNumeric("matrix", EOrder::Row)), "float4x4");
		EXPECT_EQ(Types.GetBits(Types.FindNumeric("half", EOrder::Row)->Scalar), bRealHalf ? 16u : 32u);
		EXPECT_EQ(Types.GetBits(Types.FindNumeric("min16int", EOrder::Row)->Scalar), bRealHalf ? 16u : 32u);
		EXPECT_EQ(Types.GetBits(Types.FindNumeric("float16_t", EOrder::Row)->Scalar), 16u);
		EXPECT_EQ(Types.GetBits(EScalar::Bool), 32u);
	}
}

TEST(HlslTypes, AreMadeOnce)
{
	FTypes Types(false);
	const FType* const Float3 = Types.Vector(EScalar::Float, 3);
	EXPECT_EQ(Types.FindNumeric("float3", EOrder::Row), Float3);
	EXPECT_EQ(Types.WithScalar(Types.Vector(EScalar::Int, 3), EScalar::Float), Float3);
	EXPECT_EQ(Types.Array(Float3, 2), Types.Array(Float3, 2));
	EXPECT_NE(Types.Array(Float3, 2), Types.Array(Float3, 3));
	EXPECT_NE(Types.Vector(EScalar::Float, 1), Types.Scalar(EScalar::Float));
	EXPECT_FALSE(IsSame(Types.Vector(EScalar::Float, 1), Types.Scalar(EScalar::Float)));
	EXPECT_NE(Types.Struct(MakeTypesStruct("FA", {Float3})), Types.Struct(MakeTypesStruct("FA", {Float3})));
	EXPECT_EQ(Types.Object(EObject::Texture2D, "Texture2D", Float3),
		Types.Object(EObject::Texture2D, std::string("Texture2D"), Float3));

	const FType* const Row = Types.Matrix(EScalar::Float, 2, 3, EOrder::Row);
	const FType* const Column = Types.WithOrder(Row, EOrder::Column);
	EXPECT_NE(Row, Column);
	EXPECT_TRUE(IsSame(Row, Column));
	EXPECT_TRUE(IsSame(Types.Array(Row, 2), Types.WithOrder(Types.Array(Row, 2), EOrder::Column)));
	EXPECT_EQ(Types.WithOrder(Column, EOrder::Row), Row);
	EXPECT_TRUE(IsSame(Types.WithNorm(Float3, true, false), Float3));

	const int KeyA = 0;
	const int KeyB = 0;
	const FType* const Enum = Types.Enum("EA", &KeyA, EScalar::Int);
	EXPECT_EQ(Types.Enum("EA", &KeyA, EScalar::Int), Enum);
	EXPECT_FALSE(IsSame(Enum, Types.Enum("EA", &KeyB, EScalar::Int)));
	EXPECT_FALSE(IsSame(Enum, Types.Scalar(EScalar::Int)));
}

TEST(HlslTypes, AreNamedAsWritten)
{
	FTypes Types(false);
	const FType* const Float4 = Types.Vector(EScalar::Float, 4);
	const FType* const Item = Types.Struct(MakeTypesStruct("FPair<float, 2>", {Float4}));
	EXPECT_EQ(GetName(Types.Array(Types.Array(Item, 3), 2)), "FPair<float, 2>[2][3]");
	EXPECT_EQ(GetName(Types.Array(Float4, 0)), "float4[]");
	EXPECT_EQ(GetName(Types.Object(EObject::Texture2D, "Texture2D", Float4)), "Texture2D<float4>");
	EXPECT_EQ(GetName(Types.Object(EObject::Texture2DMS, "Texture2DMS", Float4, 4)), "Texture2DMS<float4, 4>");
	EXPECT_EQ(GetName(Types.Object(EObject::RWTexture2D, "RWTexture2D", Types.WithNorm(Float4, true, false))),
		"RWTexture2D<unorm float4>");
	EXPECT_EQ(GetName(Types.Object(EObject::SamplerState, "SamplerState", nullptr)), "SamplerState");
	EXPECT_EQ(GetName(Types.Scalar(EScalar::LiteralInt)), "literal int");
	EXPECT_EQ(GetName(Types.Void()), "void");
	EXPECT_EQ(FTypes::FindObject("RWStructuredBuffer"), EObject::RWStructuredBuffer);
	EXPECT_EQ(FTypes::FindObject("RaytracingAccelerationStructure"), EObject::Unsupported);
	EXPECT_EQ(FTypes::FindObject("Texture"), std::nullopt);
}

TEST(HlslTypes, ScalarsOfCompositesAreCountedInOrder)
{
	FTypes Types(false);
	const FType* const Inner =
		Types.Struct(MakeTypesStruct("FInner", {Types.Scalar(EScalar::Bool), Types.Vector(EScalar::Int, 2)}));
	const FType* const Texture = Types.Object(EObject::Texture2D, "Texture2D", Types.Vector(EScalar::Float, 4));
	const FType* const Outer = Types.Struct(MakeTypesStruct(
		"FOuter", {Types.Array(Inner, 2), Types.Matrix(EScalar::Double, 2, 2), Types.Scalar(EScalar::Uint)}));
	const EScalar Wanted[] = {EScalar::Bool, EScalar::Int, EScalar::Int, EScalar::Bool, EScalar::Int, EScalar::Int,
		EScalar::Double, EScalar::Double, EScalar::Double, EScalar::Double, EScalar::Uint};
	ASSERT_EQ(CountScalars(Outer), std::size(Wanted));
	for (uint32_t i = 0; i < std::size(Wanted); ++i)
	{
		EXPECT_EQ(GetScalarAt(Outer, i), Wanted[i]) << i;
	}
	EXPECT_FALSE(HasObject(Outer));
	const FType* const Bound = Types.Struct(MakeTypesStruct("FBound", {Outer, Types.Array(Texture, 2)}));
	EXPECT_TRUE(HasObject(Types.Array(Bound, 3)));
	EXPECT_EQ(CountScalars(Bound), CountScalars(Outer));

	// A struct that gets its members later.
	const FType* const Late = Types.Struct(MakeTypesStruct("FLate", {}));
	EXPECT_EQ(CountScalars(Late), 0u);
	Late->Struct->Members.push_back({"A", Outer, {}, "", 0});
	EXPECT_EQ(CountScalars(Late), CountScalars(Outer));
}

TEST(HlslTypes, StructsOfStructsTakeNoTime)
{
	FTypes Types(false);
	const FType* Type = Types.Scalar(EScalar::Float);
	for (int i = 0; i < 200; ++i)
	{
		Type = Types.Array(Types.Struct(MakeTypesStruct("FTwice", {Type, Type, Type})), 3);
	}
	EXPECT_EQ(CountScalars(Type), UINT32_MAX);
	EXPECT_FALSE(HasObject(Type));
	EXPECT_GT(GetLayout(Types, Type, ELayout::Constants).Size, 0x7FFFFFFFu);
	GetScalarAt(Type, 12345);
}

// One letter a member: 1 to 4 a vector of floats; ( ) a struct; [ ] two elements of what is between.
class FPackingText
{
public:
	FPackingText(FTypes& InTypes, const std::string& InText)
		: Types(InTypes)
		, Text(InText)
	{
	}

	const FType* Read()
	{
		std::vector<const FType*> Members;
		while (At < Text.size() && Text[At] != ')' && Text[At] != ']')
		{
			const char Letter = Text[At++];
			const FType* const Inner = Letter == '(' || Letter == '[' ? Read() : nullptr;
			At += Inner ? 1 : 0;
			Members.push_back(Letter == '('   ? Inner
							  : Letter == '[' ? Types.Array(Inner->Struct->Members[0].Type, 2)
											  : Types.Vector(EScalar::Float, uint32_t(Letter - '0')));
		}
		return Types.Struct(MakeTypesStruct("FPacked", Members));
	}

private:
	FTypes& Types;
	const std::string Text;
	size_t At = 0;
};

TEST(HlslLayout, MicrosoftsExamplesOfConstantBuffers)
{
	struct FExample
	{
		const char* Members;
		uint32_t Registers;
		std::vector<uint32_t> Offsets;
	};
	const FExample Examples[] = {{"422", 2, {0, 16, 24}}, {"242", 3, {0, 16, 32}}, {"112", 1, {0, 4, 8}},
		{"121", 1, {0, 4, 12}}, {"1112", 2, {0, 4, 8, 16}}, {"31", 1, {0, 12}}, {"13", 1, {0, 4}},
		{"113", 2, {0, 4, 16}}, {"1(41)", 3, {0, 16}}, {"1(14)", 3, {0, 16}}, {"1(11)", 2, {0, 16}}, {"[4]", 2, {0}},
		{"[1]1", 2, {0, 20}}, {"[1]4", 3, {0, 32}}, {"[3]1", 2, {0, 28}}, {"[(31)]1", 3, {0, 32}}, {"[2]2", 2, {0, 24}},
		{"1[1]", 3, {0, 16}}};
	FTypes Types(false);
	for (const FExample& Example : Examples)
	{
		const FType* const Type = FPackingText(Types, Example.Members).Read();
		EXPECT_EQ((GetLayout(Types, Type, ELayout::Constants).Size + 15) / 16, Example.Registers) << Example.Members;
		EXPECT_EQ(GetOffsets(Types, *Type->Struct, ELayout::Constants), Example.Offsets) << Example.Members;
	}
}

TEST(HlslLayout, MatricesOfConstantBuffers)
{
	FTypes Types(true);
	const auto Find = [&Types](const char* Name, EOrder Order)
	{
		return GetLayout(Types, Types.FindNumeric(Name, Order), ELayout::Constants);
	};
	// Registers are columns of a column_major matrix, rows of a row_major one; the last is not filled up.
	EXPECT_EQ(Find("float4x4", EOrder::Column).Size, 64u);
	EXPECT_EQ(Find("float3x3", EOrder::Column).Size, 44u);
	EXPECT_EQ(Find("float2x4", EOrder::Column).Size, 56u);
	EXPECT_EQ(Find("float2x4", EOrder::Row).Size, 32u);
	EXPECT_EQ(Find("float4x2", EOrder::Column).Size, 32u);
	EXPECT_EQ(Find("float4x2", EOrder::Row).Size, 56u);
	EXPECT_EQ(Find("float4x1", EOrder::Row).Size, 52u);
	EXPECT_EQ(Find("float4x1", EOrder::Column).Size, 16u);
	EXPECT_EQ(Find("float3x3", EOrder::Row).Stride, 16u);
	EXPECT_EQ(Find("float3x3", EOrder::Row).Alignment, 16u);
	EXPECT_EQ(Find("double4x4", EOrder::Row).Stride, 32u);
	EXPECT_EQ(Find("double4x4", EOrder::Row).Size, 128u);
	EXPECT_EQ(Find("double2x2", EOrder::Row).Size, 32u);
	EXPECT_EQ(Find("half3x3", EOrder::Row).Size, 38u);

	// Numbers of other widths: at their own size, in one register where they fit.
	const FType* const Mixed = Types.Struct(MakeTypesStruct(
		"FMixed", {Types.Scalar(EScalar::Float), Types.Scalar(EScalar::Double), Types.Scalar(EScalar::Half),
					  Types.Vector(EScalar::Half, 3), Types.Scalar(EScalar::Float), Types.Vector(EScalar::Double, 2),
					  Types.Scalar(EScalar::Bool), Types.Vector(EScalar::Long, 3), Types.Vector(EScalar::Ushort, 4)}));
	EXPECT_EQ(GetOffsets(Types, *Mixed->Struct, ELayout::Constants),
		(std::vector<uint32_t>{0, 8, 16, 18, 24, 32, 48, 64, 88}));
}

TEST(HlslLayout, StructuredBuffersAreAsInCpp)
{
	struct FInner
	{
		float A[3];
		double B;
	};
	struct FCpp
	{
		float A;
		float B[3];
		uint16_t C;
		double D[2];
		uint32_t E; // bool
		FInner F[2];
		uint16_t G[3];
		float H[3][3];
		uint16_t I;
	};
	FTypes Types(true);
	const FType* const Inner =
		Types.Struct(MakeTypesStruct("FInner", {Types.Vector(EScalar::Float, 3), Types.Scalar(EScalar::Double)}));
	const FType* const Type = Types.Struct(MakeTypesStruct(
		"FCpp", {Types.Scalar(EScalar::Float), Types.Vector(EScalar::Float, 3), Types.Scalar(EScalar::Ushort),
					Types.Vector(EScalar::Double, 2), Types.Scalar(EScalar::Bool), Types.Array(Inner, 2),
					Types.Vector(EScalar::Half, 3), Types.Matrix(EScalar::Float, 3, 3), Types.Scalar(EScalar::Short)}));
	const std::vector<uint32_t> Wanted = {offsetof(FCpp, A), offsetof(FCpp, B), offsetof(FCpp, C), offsetof(FCpp, D),
		offsetof(FCpp, E), offsetof(FCpp, F), offsetof(FCpp, G), offsetof(FCpp, H), offsetof(FCpp, I)};
	EXPECT_EQ(GetOffsets(Types, *Type->Struct, ELayout::Structured), Wanted);
	EXPECT_EQ(GetLayout(Types, Type, ELayout::Structured).Size, sizeof(FCpp));
	EXPECT_EQ(GetLayout(Types, Type, ELayout::Structured).Alignment, alignof(FCpp));
	EXPECT_EQ(GetLayout(Types, Types.Array(Inner, 2), ELayout::Structured).Stride, sizeof(FInner));

	// The one whose stride was 32: a uint and a float3.
	const FType* const Small =
		Types.Struct(MakeTypesStruct("FS", {Types.Scalar(EScalar::Uint), Types.Vector(EScalar::Float, 3)}));
	EXPECT_EQ(GetLayout(Types, Small, ELayout::Structured).Size, 16u);
	EXPECT_EQ(GetLayout(Types, Types.Vector(EScalar::Float, 3), ELayout::Structured).Size, 12u);
}

} // namespace
} // namespace Drydock::Hlsl::Tests
