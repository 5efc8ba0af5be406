// Methods of HLSL's resources: results and parameters by Microsoft's reference, and what wrong calls are told.
#include "HlslIntrinsics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace Drydock::Hlsl
{

namespace
{

class FMethodTypes
{
public:
	FMethodTypes()
	{
		FStructType Item;
		Item.Name = "FItem";
		Item.Members.resize(1);
		Item.Members[0].Name = "A";
		Item.Members[0].Type = Types.Vector(EScalar::Float, 3);
		Struct = Types.Struct(Item);
	}

	/** "Texture2D<float2>", "SamplerState", "FItem", "uint2", "1". */
	const FType* Read(const std::string& Name)
	{
		const size_t Open = Name.find('<');
		const std::string Outer = Name.substr(0, Open);
		if (const std::optional<EObject> Object = FTypes::FindObject(Outer))
		{
			const FType* const Element =
				Open == std::string::npos ? nullptr : Read(Name.substr(Open + 1, Name.size() - Open - 2));
			return Types.Object(*Object, Names.emplace_back(Outer), Element);
		}
		return Name == "1"       ? Types.Scalar(EScalar::LiteralInt)
			   : Name == "1.0"   ? Types.Scalar(EScalar::LiteralFloat)
			   : Name == "FItem" ? Struct
								 : Types.FindNumeric(Name, EOrder::Row);
	}

	/** "Texture2D<float>.Load(int3)" -> "float(int3)"; z and Z are samplers. */
	std::string Call(const std::string& Text)
	{
		const size_t Dot = Text.find('.');
		const size_t Open = Text.find('(');
		const size_t List = std::min(Text.find('<', Dot), Open);
		std::vector<const FType*> Templates;
		if (List < Open)
		{
			Templates.push_back(Read(Text.substr(List + 1, Open - List - 2)));
		}
		std::vector<const FType*> Arguments;
		size_t At = Open + 1;
		while (Text[At] != ')')
		{
			const size_t End = Text.find_first_of(",)", At);
			const std::string Name = Text.substr(At, End - At);
			Arguments.push_back(Read(Name == "z" ? "SamplerState" : Name == "Z" ? "SamplerComparisonState" : Name));
			EXPECT_NE(Arguments.back(), nullptr) << Text;
			At = Text[End] == ',' ? End + 2 : End;
		}
		const FType* const Object = Read(Text.substr(0, Dot));
		const FIntrinsicCall Call =
			FindMethodCall(Types, Object, Text.substr(Dot + 1, List - Dot - 1), Templates, Arguments);
		if (!Call.Error.empty())
		{
			return Call.Error;
		}
		EXPECT_EQ(Call.Name, Text.substr(Dot + 1, List - Dot - 1));
		std::string Result = (Call.Result->Kind == EType::Void ? "void" : GetName(Call.Result)) + "(";
		for (size_t i = 0; i < Call.Parameters.size(); ++i)
		{
			const FType* const Type = Call.Parameters[i];
			Result += (i ? ", " : "") + std::string(Call.bOut[i] ? ">" : "");
			Result += !Type->IsObject() ? GetName(Type) : Type->Object == EObject::SamplerState ? "z" : "Z";
		}
		return Result + ")";
	}

	FTypes Types{true};
	const FType* Struct = nullptr;
	std::deque<std::string> Names;
};

struct FExpectedMethod
{
	const char* Call;
	const char* Result;
};

void CheckMethods(std::initializer_list<FExpectedMethod> Calls)
{
	for (const FExpectedMethod& Expected : Calls)
	{
		EXPECT_EQ(FMethodTypes().Call(Expected.Call), Expected.Result) << Expected.Call;
	}
}

} // namespace

TEST(HlslMethods, Samples)
{
	CheckMethods({{"Texture2D<float4>.Sample(z, float2)", "float4(z, float2)"},
		{"Texture2D.Sample(z, float2)", "float4(z, float2)"},
		{"Texture2D<float>.Sample(z, float2, int2)", "float(z, float2, int2)"},
		{"Texture2D<float2>.Sample(z, float2, int2, float)", "float2(z, float2, int2, float)"},
		{"Texture2D<float2>.Sample(z, float2, int2, 1, uint)", "float2(z, float2, int2, float, >uint)"},
		{"Texture1D<float>.Sample(z, float)", "float(z, float)"},
		{"Texture1DArray<float>.Sample(z, float2, int)", "float(z, float2, int)"},
		{"Texture2DArray<float3>.Sample(z, float3, int2)", "float3(z, float3, int2)"},
		{"Texture3D<float4>.Sample(z, float3, int3)", "float4(z, float3, int3)"},
		{"TextureCube<float4>.Sample(z, float3)", "float4(z, float3)"},
		{"TextureCube<float4>.Sample(z, float3, float)", "float4(z, float3, float)"},
		{"TextureCubeArray<float4>.Sample(z, float4, float, uint)", "float4(z, float4, float, >uint)"},
		{"Texture2D<float4>.Sample(z, float4)", "float4(z, float2)"},
		{"Texture2D<float4>.Sample(z, int2)", "float4(z, float2)"},
		{"Texture2D<float4>.SampleBias(z, float2, 1, int2)", "float4(z, float2, float, int2)"},
		{"Texture2D<float4>.SampleLevel(z, float2, 1)", "float4(z, float2, float)"},
		{"Texture2D<float4>.SampleLevel(z, float2, float, int2, uint)", "float4(z, float2, float, int2, >uint)"},
		{"Texture2DArray<float4>.SampleLevel(z, float3, 1)", "float4(z, float3, float)"},
		{"TextureCube<float4>.SampleLevel(z, float3, float)", "float4(z, float3, float)"},
		{"Texture2D<float4>.SampleGrad(z, float2, float2, float2)", "float4(z, float2, float2, float2)"},
		{"Texture2DArray<float4>.SampleGrad(z, float3, float2, float2, int2)",
			"float4(z, float3, float2, float2, int2)"},
		{"TextureCubeArray<float4>.SampleGrad(z, float4, float3, float3, float)",
			"float4(z, float4, float3, float3, float)"},
		{"Texture2D<float4>.SampleCmp(Z, float2, float)", "float(Z, float2, float)"},
		{"Texture2D<float4>.SampleCmp(Z, float2, float, int2, float)", "float(Z, float2, float, int2, float)"},
		{"TextureCube<float>.SampleCmpLevelZero(Z, float3, 1)", "float(Z, float3, float)"},
		{"Texture2DArray<float>.SampleCmpLevelZero(Z, float3, float, int2)", "float(Z, float3, float, int2)"},
		{"Texture2D<float>.SampleCmpLevel(Z, float2, float, float)", "float(Z, float2, float, float)"},
		{"Texture2D<float>.SampleCmpBias(Z, float2, float, float)", "float(Z, float2, float, float)"},
		{"Texture2D<float>.SampleCmpGrad(Z, float2, float, float2, float2)", "float(Z, float2, float, float2, float2)"},
		{"Texture2D<float4>.CalculateLevelOfDetail(z, float2)", "float(z, float2)"},
		{"Texture2DArray<float4>.CalculateLevelOfDetailUnclamped(z, float2)", "float(z, float2)"},
		{"TextureCubeArray<float4>.CalculateLevelOfDetail(z, float3)", "float(z, float3)"}});
}

TEST(HlslMethods, Gathers)
{
	for (const std::string Name : {"GatherRed", "GatherGreen", "GatherBlue", "GatherAlpha"})
	{
		FMethodTypes Types;
		EXPECT_EQ(Types.Call("Texture2D<float4>." + Name + "(z, float2)"), "float4(z, float2)") << Name;
		EXPECT_EQ(Types.Call("Texture2D<float2>." + Name + "(z, float2, int2)"), "float4(z, float2, int2)") << Name;
		EXPECT_EQ(Types.Call("Texture2DArray<uint>." + Name + "(z, float3, int2, int2, int2, int2)"),
			"uint4(z, float3, int2, int2, int2, int2)")
			<< Name;
		EXPECT_EQ(Types.Call("TextureCube<float4>." + Name + "(z, float3)"), "float4(z, float3)") << Name;
	}
	for (const std::string Name : {"GatherCmp", "GatherCmpRed", "GatherCmpGreen", "GatherCmpBlue", "GatherCmpAlpha"})
	{
		FMethodTypes Types;
		EXPECT_EQ(Types.Call("Texture2D<float>." + Name + "(Z, float2, 1)"), "float4(Z, float2, float)") << Name;
		EXPECT_EQ(Types.Call("Texture2D<float>." + Name + "(Z, float2, 1, int2)"), "float4(Z, float2, float, int2)")
			<< Name;
	}
	CheckMethods({{"Texture2D<float>.Gather(z, float2)", "float4(z, float2)"},
		{"Texture2D<int3>.Gather(z, float2, int2)", "int4(z, float2, int2)"},
		{"Texture2D<float>.Gather(z, float2, int2, uint)", "float4(z, float2, int2, >uint)"},
		{"TextureCubeArray<float>.Gather(z, float4, uint)", "float4(z, float4, >uint)"},
		{"Texture2D<float>.GatherCmpRed(Z, float2, 1, int2, int2, int2, int2, uint)",
			"float4(Z, float2, float, int2, int2, int2, int2, >uint)"}});
}

TEST(HlslMethods, Loads)
{
	CheckMethods({{"Texture1D<float>.Load(int2)", "float(int2)"}, {"Texture1DArray<float>.Load(int3)", "float(int3)"},
		{"Texture2D<float4>.Load(int3)", "float4(int3)"}, {"Texture2D<float2>.Load(uint3)", "float2(int3)"},
		{"Texture2D<float4>.Load(float4)", "float4(int3)"},
		{"Texture2D<float4>.Load(int3, int2)", "float4(int3, int2)"},
		{"Texture2D<float4>.Load(int3, int2, uint)", "float4(int3, int2, >uint)"},
		{"Texture2DArray<uint>.Load(int4)", "uint(int4)"}, {"Texture3D<float4>.Load(int4, int3)", "float4(int4, int3)"},
		{"Texture2DMS<float4>.Load(int2, 1)", "float4(int2, int)"},
		{"Texture2DMSArray<float4>.Load(int3, 1, int2)", "float4(int3, int, int2)"},
		{"Texture2DMS<float4>.GetSamplePosition(1)", "float2(int)"}, {"RWTexture1D<float>.Load(int)", "float(int)"},
		{"RWTexture2D<float4>.Load(uint2)", "float4(int2)"}, {"RWTexture2D<float4>.Load(int3)", "float4(int2)"},
		{"RWTexture2D<float4>.Load(int2, uint)", "float4(int2, >uint)"},
		{"RWTexture2DArray<int2>.Load(int3)", "int2(int3)"}, {"RWTexture3D<float>.Load(int3)", "float(int3)"},
		{"Buffer<float4>.Load(1)", "float4(int)"}, {"RWBuffer<uint>.Load(uint, uint)", "uint(int, >uint)"},
		{"StructuredBuffer<FItem>.Load(uint)", "FItem(int)"},
		{"RWStructuredBuffer<float3>.Load(1, uint)", "float3(int, >uint)"}});
}

TEST(HlslMethods, Sizes)
{
	CheckMethods({{"Texture1D<float>.GetDimensions(uint)", "void(>uint)"},
		{"Texture1D<float>.GetDimensions(1, uint, uint)", "void(uint, >uint, >uint)"},
		{"Texture1DArray<float>.GetDimensions(uint, uint)", "void(>uint, >uint)"},
		{"Texture2D<float>.GetDimensions(uint, uint)", "void(>uint, >uint)"},
		{"Texture2D<float>.GetDimensions(int, float)", "void(>int, >float)"},
		{"Texture2D<float>.GetDimensions(1, float, float, uint)", "void(uint, >float, >float, >uint)"},
		{"Texture2DArray<float>.GetDimensions(uint, uint, uint)", "void(>uint, >uint, >uint)"},
		{"Texture2DArray<float>.GetDimensions(1, uint, uint, uint, uint)", "void(uint, >uint, >uint, >uint, >uint)"},
		{"Texture3D<float>.GetDimensions(uint, uint, uint)", "void(>uint, >uint, >uint)"},
		{"TextureCube<float>.GetDimensions(1, uint, uint, uint)", "void(uint, >uint, >uint, >uint)"},
		{"TextureCubeArray<float>.GetDimensions(uint, uint, uint)", "void(>uint, >uint, >uint)"},
		{"Texture2DMS<float>.GetDimensions(uint, uint, uint)", "void(>uint, >uint, >uint)"},
		{"Texture2DMSArray<float>.GetDimensions(uint, uint, uint, uint)", "void(>uint, >uint, >uint, >uint)"},
		{"RWTexture1D<float>.GetDimensions(uint)", "void(>uint)"},
		{"RWTexture2D<float>.GetDimensions(uint, uint)", "void(>uint, >uint)"},
		{"RWTexture3D<float>.GetDimensions(uint, uint, uint)", "void(>uint, >uint, >uint)"},
		{"Buffer<float>.GetDimensions(uint)", "void(>uint)"}, {"RWBuffer<float>.GetDimensions(uint)", "void(>uint)"},
		{"StructuredBuffer<FItem>.GetDimensions(uint, uint)", "void(>uint, >uint)"},
		{"AppendStructuredBuffer<FItem>.GetDimensions(uint, uint)", "void(>uint, >uint)"},
		{"ByteAddressBuffer.GetDimensions(uint)", "void(>uint)"}});
}

TEST(HlslMethods, Bytes)
{
	CheckMethods({{"ByteAddressBuffer.Load(int)", "uint(uint)"}, {"ByteAddressBuffer.Load2(uint)", "uint2(uint)"},
		{"ByteAddressBuffer.Load3(1)", "uint3(uint)"}, {"RWByteAddressBuffer.Load4(uint, uint)", "uint4(uint, >uint)"},
		{"ByteAddressBuffer.Load<float4>(uint)", "float4(uint)"},
		{"RWByteAddressBuffer.Load<FItem>(uint, uint)", "FItem(uint, >uint)"},
		{"RWByteAddressBuffer.Store(uint, uint)", "void(uint, uint)"},
		{"RWByteAddressBuffer.Store(1, 1)", "void(uint, uint)"},
		{"RWByteAddressBuffer.Store(1, 1.0)", "void(uint, float)"},
		{"RWByteAddressBuffer.Store(uint, int)", "void(uint, int)"},
		{"RWByteAddressBuffer.Store(uint, float3)", "void(uint, float3)"},
		{"RWByteAddressBuffer.Store(uint, FItem)", "void(uint, FItem)"},
		{"RWByteAddressBuffer.Store<float3>(uint, int3)", "void(uint, float3)"},
		{"RWByteAddressBuffer.Store<uint16_t>(uint, 1)", "void(uint, uint16_t)"},
		{"RWByteAddressBuffer.Store2(uint, uint2)", "void(uint, uint2)"},
		{"RWByteAddressBuffer.Store3(uint, int3)", "void(uint, uint3)"},
		{"RWByteAddressBuffer.Store4(uint, 1)", "void(uint, uint4)"},
		{"RWByteAddressBuffer.InterlockedAdd(uint, 1)", "void(uint, uint)"},
		{"RWByteAddressBuffer.InterlockedAdd(uint, float)", "void(uint, uint)"},
		{"RWByteAddressBuffer.InterlockedAdd(uint, 1, uint)", "void(uint, uint, >uint)"},
		{"RWByteAddressBuffer.InterlockedMin(uint, int, int)", "void(uint, int, >int)"},
		{"RWByteAddressBuffer.InterlockedMax(uint, uint)", "void(uint, uint)"},
		{"RWByteAddressBuffer.InterlockedAnd(uint, uint)", "void(uint, uint)"},
		{"RWByteAddressBuffer.InterlockedOr(uint, uint)", "void(uint, uint)"},
		{"RWByteAddressBuffer.InterlockedXor(uint, uint)", "void(uint, uint)"},
		{"RWByteAddressBuffer.InterlockedExchange(uint, 1, uint)", "void(uint, uint, >uint)"},
		{"RWByteAddressBuffer.InterlockedCompareStore(uint, 1, 1)", "void(uint, uint, uint)"},
		{"RWByteAddressBuffer.InterlockedCompareExchange(uint, 1, 1, uint)", "void(uint, uint, uint, >uint)"},
		{"RWByteAddressBuffer.InterlockedAdd64(uint, uint64_t, uint64_t)", "void(uint, uint64_t, >uint64_t)"},
		{"RWByteAddressBuffer.InterlockedMin64(uint, int64_t)", "void(uint, int64_t)"},
		{"RWByteAddressBuffer.InterlockedMax64(uint, 1)", "void(uint, uint64_t)"},
		{"RWByteAddressBuffer.InterlockedCompareExchange64(uint, 1, uint64_t, uint64_t)",
			"void(uint, uint64_t, uint64_t, >uint64_t)"},
		{"RWByteAddressBuffer.InterlockedExchange64(uint, 1, uint64_t)", "void(uint, uint64_t, >uint64_t)"},
		{"RWByteAddressBuffer.InterlockedCompareStore64(uint, 1, 1)", "void(uint, uint64_t, uint64_t)"},
		{"RWByteAddressBuffer.InterlockedExchangeFloat(uint, 1, float)", "void(uint, float, >float)"},
		{"RWByteAddressBuffer.InterlockedCompareStoreFloatBitwise(uint, 1.0, float)", "void(uint, float, float)"},
		{"RWByteAddressBuffer.InterlockedCompareExchangeFloatBitwise(uint, 1, 1, float)",
			"void(uint, float, float, >float)"}});
}

TEST(HlslMethods, Structures)
{
	CheckMethods({{"RWStructuredBuffer<FItem>.IncrementCounter()", "uint()"},
		{"RWStructuredBuffer<FItem>.DecrementCounter()", "uint()"},
		{"AppendStructuredBuffer<FItem>.Append(FItem)", "void(FItem)"},
		{"AppendStructuredBuffer<float2>.Append(1)", "void(float2)"},
		{"ConsumeStructuredBuffer<uint>.Consume()", "uint()"}});
}

TEST(HlslMethods, WrongCallsSayHowToWriteThem)
{
	CheckMethods({
		{"Texture2D<float4>.Smaple(z, float2)",
			"X3018: Texture2D<float4> has no method 'Smaple'; did you mean Sample?"},
		{"StructuredBuffer<FItem>.Append(FItem)",
			"X3018: StructuredBuffer<FItem> has no method 'Append', which is of AppendStructuredBuffer"},
		{"Texture3D<float4>.Gather(z, float3)",
			"X3018: Texture3D<float4> has no method 'Gather', which is of Texture2D, "
			"Texture2DArray, TextureCube, TextureCubeArray"},
		{"Texture2D<float4>.Sample(float2)",
			"X3013: 'Sample' takes 2, 3, 4 or 5 arguments, but 1 is given; write Sample(SamplerState, float2)"},
		{"Texture2D<float4>.Sample(Z, float2)",
			"X3013: argument 1 of 'Sample' has the type SamplerComparisonState, but a "
			"SamplerState is expected; write Sample(SamplerState, float2)"},
		{"Texture2D<float4>.SampleCmp(z, float2, 1)",
			"X3013: argument 1 of 'SampleCmp' has the type SamplerState, but a "
			"SamplerComparisonState is expected; write "
			"SampleCmp(SamplerComparisonState, float2, float)"},
		{"Texture2DArray<float4>.Sample(z, float2)",
			"X3013: argument 2 of 'Sample' has the type float2, but float3 is expected; "
			"write Sample(SamplerState, float3)"},
		{"Texture2D<float4>.Load(int2)",
			"X3013: argument 1 of 'Load' has the type int2, but int3 is expected; write Load(int3)"},
		{"Texture2D<float4>.GetDimensions(uint)",
			"X3013: 'GetDimensions' takes 2 or 4 arguments, but 1 is given; write GetDimensions(out uint, out uint)"},
		{"Texture2D<float4>.Load<float>(int3)", "X3013: 'Load' takes no type between < and >"},
		{"RWByteAddressBuffer.Store<float3>(uint, float2)",
			"X3013: argument 2 of 'Store' has the type float2, but float3 is expected; write Store(uint, float3)"},
		{"ByteAddressBuffer.Load<SamplerState>(uint)",
			"X3013: 'Load' reads and writes types that lie in memory, not SamplerState"},
		{"RWByteAddressBuffer.Store(uint, z)",
			"X3013: argument 2 of 'Store' has the type SamplerState, but a type that lies in "
			"memory is expected; write Store(uint, uint)"},
		{"AppendStructuredBuffer<FItem>.Append(float)",
			"X3013: argument 1 of 'Append' has the type float, but FItem is expected; write Append(FItem)"},
	});
}

TEST(HlslMethods, ListsAndDimensions)
{
	FMethodTypes Types;
	EXPECT_THAT(ListMethods(Types.Read("Texture2D<float4>")),
		testing::IsSupersetOf({"Sample", "GatherCmpRed", "GetDimensions"}));
	EXPECT_THAT(ListMethods(Types.Read("ConsumeStructuredBuffer<uint>")),
		testing::UnorderedElementsAre("Consume", "GetDimensions"));
	EXPECT_THAT(ListMethods(Types.Read("SamplerState")), testing::IsEmpty());
	const std::pair<EObject, uint32_t> Dimensions[] = {{EObject::Texture1D, 1}, {EObject::Texture1DArray, 2},
		{EObject::Texture2D, 2}, {EObject::Texture2DArray, 3}, {EObject::Texture2DMS, 2},
		{EObject::Texture2DMSArray, 3}, {EObject::Texture3D, 3}, {EObject::TextureCube, 3},
		{EObject::TextureCubeArray, 4}, {EObject::RWTexture1D, 1}, {EObject::RWTexture1DArray, 2},
		{EObject::RWTexture2D, 2}, {EObject::RWTexture2DArray, 3}, {EObject::RWTexture3D, 3}, {EObject::Buffer, 1},
		{EObject::RWBuffer, 1}, {EObject::StructuredBuffer, 1}, {EObject::RWByteAddressBuffer, 1},
		{EObject::SamplerState, 0}, {EObject::ConstantBuffer, 0}};
	for (const auto& [Object, Count] : Dimensions)
	{
		EXPECT_EQ(GetDimensions(Object), Count) << int(Object);
	}
}

TEST(HlslMethods, TexelsLoseTheirNorm)
{
	FMethodTypes Types;
	const FType* const Texel = Types.Types.WithNorm(Types.Types.Vector(EScalar::Float, 4), true, false);
	const FType* const Texture = Types.Types.Object(EObject::RWTexture2D, "RWTexture2D", Texel);
	const FIntrinsicCall Call = FindMethodCall(Types.Types, Texture, "Load", {}, {Types.Types.Vector(EScalar::Int, 2)});
	EXPECT_EQ(Call.Result, Types.Types.Vector(EScalar::Float, 4));
}

} // namespace Drydock::Hlsl
