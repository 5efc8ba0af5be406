// Conversions, the meeting of types, and the choice of overloads: the table of public tests of DXC, and what was
// measured of D3D's compilers.
#include <gtest/gtest.h>

#include "HlslConstants.h"
#include "HlslConversions.h"

#include <string>
#include <vector>

namespace Drydock::Hlsl::Tests
{
namespace
{

class HlslConversions : public ::testing::Test
{
protected:
	FTypes Types{false};
	FProgram Program;

	const FType* Find(const std::string& Name)
	{
		if (Name.starts_with("S") || Name.starts_with("A"))
		{
			const uint32_t Count = uint32_t(Name[1] - '0');
			const FType* const Int = Types.Scalar(EScalar::Int);
			const FType*& Made = Composites[Name];
			if (!Made && Name[0] == 'S')
			{
				FStructType Struct;
				Struct.Name = Name;
				Struct.Members.resize(Count, {"A", Int, {}, "", 0});
				Made = Types.Struct(Struct);
			}
			Made = Made ? Made : Types.Array(Int, Count);
			return Made;
		}
		return Name == "1"     ? Types.Scalar(EScalar::LiteralInt)
			   : Name == "1.0" ? Types.Scalar(EScalar::LiteralFloat)
							   : Types.FindNumeric(Name, EOrder::Row);
	}

	/** "yes", "cut" (a warning), "cast" (it takes one) or "no". */
	std::string Judge(const std::string& From, const std::string& To)
	{
		const FConversion Implicit = FindConversion(Types, Find(From), Find(To));
		const FConversion Explicit = FindConversion(Types, Find(From), Find(To), true);
		EXPECT_TRUE(Explicit.bPossible || !Implicit.bPossible) << From << " to " << To;
		return Implicit.bPossible ? (Implicit.bTruncates ? "cut" : "yes") : Explicit.bPossible ? "cast" : "no";
	}

	/** The parameters of the function that is called: "float,int"; "ambiguous"; or why none is. */
	std::string Call(const std::vector<std::string>& Overloads, const std::string& Given)
	{
		std::vector<std::vector<FParameterType>> Parameters;
		for (const std::string& Overload : Overloads)
		{
			std::vector<FParameterType>& List = Parameters.emplace_back();
			for (std::string Name : Split(Overload))
			{
				FParameterType Parameter;
				const auto Take = [&Name](const std::string& Word)
				{
					const bool bHas = Name.starts_with(Word);
					Name = bHas ? Name.substr(Word.size()) : Name;
					return bHas;
				};
				Parameter.bDefault = Take("default ");
				if (Take("inout "))
				{
					Parameter.bOut = true;
				}
				else if (Take("out "))
				{
					Parameter.bOut = true;
					Parameter.bIn = false;
				}
				Parameter.Type = Find(Name);
				List.push_back(Parameter);
			}
		}
		std::vector<FArgumentType> Arguments;
		for (const std::string& Name : Split(Given))
		{
			const bool bPlace = Name.ends_with("&");
			Arguments.push_back({Find(bPlace ? Name.substr(0, Name.size() - 1) : Name), bPlace});
		}
		const FOverloadChoice Choice = ChooseOverload(Types, Parameters, Arguments);
		EXPECT_FALSE(Choice.Best && !Choice.Ambiguous.empty());
		return Choice.Best ? Overloads[*Choice.Best] : !Choice.Ambiguous.empty() ? "ambiguous" : "none: " + Choice.Why;
	}

	std::string Meet(const std::string& A, const std::string& B)
	{
		bool bTruncates = false;
		std::string Error;
		const FType* const Type = MeetTypes(Types, Find(A), Find(B), bTruncates, Error);
		EXPECT_EQ(Type == nullptr, !Error.empty());
		return Type ? GetName(Type) + (bTruncates ? " cut" : "") : "error";
	}

	FValue* MakeConstant(const FType* Type, const FConstant& Constant)
	{
		FValue* const Value = Program.Make<FValue>();
		Value->Type = Type;
		Value->Constant = Constant;
		return Value;
	}

	FValue* MakeVariable(const FType* Type, const std::optional<FConstant>& Constant = std::nullopt)
	{
		FVariable* const Variable = Program.Make<FVariable>();
		Variable->Type = Type;
		Variable->Constant = Constant;
		FValue* const Value = Program.Make<FValue>();
		Value->Kind = EValue::Variable;
		Value->Type = Type;
		Value->Variable = Variable;
		return Value;
	}

private:
	static std::vector<std::string> Split(const std::string& Text)
	{
		std::vector<std::string> Parts;
		size_t First = 0;
		while (First < Text.size())
		{
			const size_t End = std::min(Text.find(',', First), Text.size());
			Parts.push_back(Text.substr(First, End - First));
			First = End + 1;
		}
		return Parts;
	}

	std::map<std::string, const FType*> Composites;
};

TEST_F(HlslConversions, BetweenShapesAsInDxcsTable)
{
	const std::vector<std::vector<std::string>> Table = {// One component
		{"int1", "int", "yes"}, {"int1x1", "int", "yes"}, {"A1", "int", "cast"}, {"S1", "int", "cast"},
		{"int", "int1", "yes"}, {"int1x1", "int1", "yes"}, {"int", "int1x1", "yes"}, {"int1", "int1x1", "yes"},
		{"S1", "int1x1", "cast"}, {"int", "A1", "cast"}, {"int1", "A1", "cast"}, {"int1x1", "S1", "cast"},
		{"S1", "A1", "cast"}, {"A1", "S1", "cast"},
		// Cut to one
		{"int2", "int", "cut"}, {"int2x2", "int", "cut"}, {"A2", "int", "cast"}, {"S2", "int", "cast"},
		{"int2", "int1", "cut"}, {"int2x2", "int1", "cut"}, {"int2", "int1x1", "cut"}, {"int2x2", "int1x1", "cut"},
		{"A2", "A1", "cast"}, {"S2", "S1", "cast"},
		// Splat
		{"int", "int2", "yes"}, {"int1", "int2", "yes"}, {"int1x1", "int2", "yes"}, {"A1", "int2", "no"},
		{"S1", "int2", "no"}, {"int", "int2x2", "yes"}, {"int1", "int2x2", "yes"}, {"int1x1", "int2x2", "yes"},
		{"A1", "int2x2", "no"}, {"int", "A2", "cast"}, {"int1x1", "A2", "cast"}, {"A1", "A2", "no"}, {"S1", "A2", "no"},
		{"int", "S2", "cast"}, {"A1", "S2", "no"}, {"S1", "S2", "no"},
		// As many
		{"int1x2", "int2", "yes"}, {"int2x1", "int2", "yes"}, {"int2x2", "int4", "yes"}, {"A2", "int2", "cast"},
		{"S2", "int2", "cast"}, {"int2", "int1x2", "yes"}, {"int2", "int2x1", "yes"}, {"int4", "int2x2", "yes"},
		{"int2x1", "int1x2", "no"}, {"int1x2", "int2x1", "no"}, {"A2", "int2x1", "cast"}, {"A4", "int2x2", "cast"},
		{"S4", "int2x2", "cast"}, {"int2", "A2", "cast"}, {"int2x2", "A4", "cast"}, {"S2", "A2", "cast"},
		{"int2", "S2", "cast"}, {"int2x2", "S4", "cast"}, {"A2", "S2", "cast"},
		// Cut
		{"int4", "int2", "cut"}, {"int1x3", "int2", "cut"}, {"int3x1", "int2", "cut"}, {"int2x2", "int2", "no"},
		{"int3x3", "int2", "no"}, {"A4", "int2", "cast"}, {"S4", "int2", "cast"}, {"int4", "int1x2", "cut"},
		{"int4", "int2x1", "cut"}, {"int1x3", "int1x2", "cut"}, {"int3x1", "int1x2", "no"}, {"int2x2", "int1x2", "cut"},
		{"int3x1", "int2x1", "cut"}, {"int1x3", "int2x1", "no"}, {"int2x2", "int2x1", "cut"},
		{"int2x3", "int2x2", "cut"}, {"int3x2", "int2x2", "cut"}, {"int3x3", "int2x2", "cut"}, {"A5", "int2x2", "cast"},
		{"S5", "int2x2", "cast"}, {"int4", "A2", "cast"}, {"int3x3", "A2", "cast"}, {"A4", "A2", "cast"},
		{"S4", "A2", "cast"}, {"int4", "S2", "cast"}, {"int2x2", "S2", "cast"}, {"S4", "S2", "cast"},
		// Longer
		{"int2", "int4", "no"}, {"int1x2", "int4", "no"}, {"A2", "int4", "no"}, {"S2", "int4", "no"},
		{"int2", "int2x2", "no"}, {"int2x2", "int3x3", "no"}, {"int2", "A4", "no"}, {"int2x2", "A5", "no"},
		{"A2", "A4", "no"}, {"S2", "S4", "no"}, {"float2x2", "float3", "no"}, {"float3x3", "float2x2", "cut"},
		{"float2x2", "float4", "yes"}};
	for (const std::vector<std::string>& Row : Table)
	{
		EXPECT_EQ(Judge(Row[0], Row[1]), Row[2]) << Row[0] << " to " << Row[1];
	}
}

TEST_F(HlslConversions, EveryNumericTypeBecomesItselfAndAllScalars)
{
	const char* const Scalars[] = {
		"bool", "int", "uint", "half", "float", "double", "int64_t", "uint64_t", "int16_t", "float16_t", "min16int"};
	for (const std::string From : Scalars)
	{
		for (const std::string To : Scalars)
		{
			for (const std::string Shape : {"", "1", "3", "2x3", "1x4"})
			{
				const FConversion Conversion = FindConversion(Types, Find(From + Shape), Find(To + Shape));
				EXPECT_TRUE(Conversion.bPossible);
				EXPECT_FALSE(Conversion.bTruncates);
				EXPECT_EQ(Conversion.Rank == 0, From == To) << From << " to " << To;
			}
		}
	}
	EXPECT_TRUE(FindConversion(Types, Find("float"), Find("int")).bNarrows);
	EXPECT_TRUE(FindConversion(Types, Find("double2"), Find("float2")).bNarrows);
	EXPECT_FALSE(FindConversion(Types, Find("int"), Find("float")).bNarrows);
	EXPECT_FALSE(FindConversion(Types, Find("1"), Find("half")).bNarrows);
	EXPECT_TRUE(FindConversion(Types, Types.Error(), Find("S2")).bPossible);
	EXPECT_FALSE(FindConversion(Types, Types.Void(), Find("int")).bPossible);
}

TEST_F(HlslConversions, EnumerationsAndBases)
{
	const int Key = 0;
	const FType* const Enum = Types.Enum("EA", &Key, EScalar::Int);
	const FType* const Scoped = Types.Enum("EB", &Key + 1, EScalar::Uint, true);
	EXPECT_TRUE(FindConversion(Types, Enum, Find("int")).bPossible);
	EXPECT_GT(FindConversion(Types, Enum, Find("int")).Rank, 0u);
	EXPECT_TRUE(FindConversion(Types, Enum, Find("float3")).bPossible);
	EXPECT_FALSE(FindConversion(Types, Find("int"), Enum).bPossible);
	EXPECT_FALSE(FindConversion(Types, Find("1"), Enum).bPossible);
	EXPECT_TRUE(FindConversion(Types, Find("int"), Enum, true).bPossible);
	EXPECT_FALSE(FindConversion(Types, Scoped, Find("uint")).bPossible);
	EXPECT_FALSE(FindConversion(Types, Scoped, Enum).bPossible);
	EXPECT_TRUE(FindConversion(Types, Scoped, Enum, true).bPossible);
	bool bTruncates = false;
	std::string Error;
	EXPECT_EQ(MeetTypes(Types, Enum, Find("1"), bTruncates, Error), Find("int"));
	EXPECT_EQ(MeetTypes(Types, Scoped, Scoped, bTruncates, Error), Find("uint"));
	EXPECT_EQ(MeetTypes(Types, Scoped, Find("1"), bTruncates, Error), nullptr);
	EXPECT_NE(Error.find("EB"), std::string::npos);

	const FType* const Base = Find("S2");
	FStructType Derived;
	Derived.Name = "FDerived";
	Derived.Bases = {Base};
	Derived.Members = Base->Struct->Members;
	Derived.Members.push_back({"C", Find("float"), {}, "", 0});
	const FType* const Middle = Types.Struct(Derived);
	Derived.Bases = {Middle};
	const FType* const Last = Types.Struct(Derived);
	EXPECT_TRUE(FindConversion(Types, Middle, Base).bPossible);
	EXPECT_FALSE(FindConversion(Types, Base, Middle, true).bPossible);
	EXPECT_LT(FindConversion(Types, Last, Middle).Rank, FindConversion(Types, Last, Base).Rank);
	FValue* const AsBase = MakeConversion(Program, Types, MakeVariable(Last), Base);
	ASSERT_NE(AsBase, nullptr);
	EXPECT_EQ(AsBase->Kind, EValue::Cast);
	EXPECT_EQ(AsBase->Type, Base);
}

TEST_F(HlslConversions, ScalarsMeet)
{
	const char* const Rows[][3] = {{"bool", "bool", "int"}, {"bool", "float", "float"}, {"bool", "1", "int"},
		{"int", "uint", "uint"}, {"int", "int64_t", "int64_t"}, {"uint", "int64_t", "uint64_t"},
		{"uint64_t", "int64_t", "uint64_t"}, {"int16_t", "int", "int"}, {"uint16_t", "int", "uint"},
		{"min16uint", "int", "uint"}, {"bool", "int16_t", "int16_t"}, {"half", "float", "float"},
		{"float", "double", "double"}, {"1", "half", "half"}, {"1", "uint", "uint"}, {"1", "int64_t", "int64_t"},
		{"1.0", "int", "float"}, {"1.0", "half", "half"}, {"1.0", "double", "double"}, {"1.0", "uint64_t", "float"},
		{"1", "1", "literal int"}, {"1", "1.0", "literal float"}, {"int", "half", "half"},
		{"int64_t", "float", "float"}, {"float16_t", "uint", "float16_t"}};
	for (const auto& [A, B, Both] : Rows)
	{
		EXPECT_EQ(Meet(A, B), Both) << A << " with " << B;
		EXPECT_EQ(Meet(B, A), Both) << B << " with " << A;
	}
}

TEST_F(HlslConversions, ShapesMeet)
{
	const char* const Rows[][3] = {{"float4", "float3", "float3 cut"}, {"float3", "float4", "float3 cut"},
		{"float2", "int4", "float2 cut"}, {"float4x4", "float", "float4x4"}, {"int", "float3", "float3"},
		{"float1", "float3", "float3"}, {"float1", "float", "float"}, {"float", "float1", "float"},
		{"float4x4", "int4x4", "float4x4"}, {"float4x4", "float1x4", "float1x4 cut"},
		{"float4x4", "float3x2", "float3x2 cut"}, {"float2x3", "float3x2", "error"}, {"float1x4", "float2x3", "error"},
		{"float4", "float4x4", "error"}, {"float4x4", "float4", "error"}, {"float3", "float1x4", "float3 cut"},
		{"float1x4", "float2", "float2 cut"}, {"float4", "float2x2", "float4"}, {"float2x2", "float4", "float2x2"},
		{"float4", "float1x4", "float4"}, {"S2", "int", "error"}, {"A2", "A2", "error"}, {"bool3", "bool3", "int3"},
		{"1", "half3", "half3"}};
	for (const auto& [A, B, Both] : Rows)
	{
		EXPECT_EQ(Meet(A, B), Both) << A << " with " << B;
	}
	bool bTruncates = false;
	std::string Error;
	MeetTypes(Types, Find("float4"), Find("float4x4"), bTruncates, Error);
	EXPECT_NE(Error.find("X3020"), std::string::npos);
	EXPECT_NE(Error.find("mul("), std::string::npos);
}

TEST_F(HlslConversions, OverloadsOfScalarsAsMeasured)
{
	// Each: what is given, then what is preferred; those between two bars are as good as each other.
	const std::vector<std::pair<std::string, std::vector<std::vector<std::string>>>> Orders = {
		{"bool", {{"bool"}, {"uint", "int", "float", "double"}, {"half"}}},
		{"int", {{"int"}, {"uint"}, {"bool"}, {"float", "double"}, {"half"}}},
		{"1", {{"uint", "int"}, {"bool"}, {"float", "double", "half"}}},
		{"uint", {{"uint"}, {"int"}, {"bool"}, {"float", "double"}, {"half"}}},
		{"half", {{"half"}, {"float", "double"}, {"bool", "int", "uint"}}},
		{"float", {{"float"}, {"double"}, {"bool", "int", "uint", "half"}}},
		{"double", {{"double"}, {"bool", "int", "uint", "float", "half"}}}};
	for (const auto& [Given, Tiers] : Orders)
	{
		for (size_t Tier = 0; Tier < Tiers.size(); ++Tier)
		{
			for (const std::string& Better : Tiers[Tier])
			{
				for (const std::string& Other : Tiers[Tier])
				{
					EXPECT_EQ(Call({Better, Other}, Given), "ambiguous") << Given;
				}
				for (size_t Worse = Tier + 1; Worse < Tiers.size(); ++Worse)
				{
					for (const std::string& Other : Tiers[Worse])
					{
						EXPECT_EQ(Call({Other, Better}, Given), Better) << Given << " to " << Better << " or " << Other;
					}
				}
			}
		}
	}
}

TEST_F(HlslConversions, OverloadsOfTheReferencesList)
{
	EXPECT_EQ(Call({"half", "double"}, "float"), "double");
	EXPECT_EQ(Call({"uint", "min16int"}, "int"), "uint");
	EXPECT_EQ(Call({"float2", "double"}, "float"), "float2");
	EXPECT_EQ(Call({"int", "uint"}, "1"), "ambiguous");
	EXPECT_EQ(Call({"float", "int"}, "1"), "int");
	EXPECT_EQ(Call({"float", "int"}, "1.0"), "float");
	EXPECT_EQ(Call({"float", "double"}, "1.0"), "ambiguous");
	EXPECT_EQ(Call({"float3", "float4"}, "float3"), "float3");
	EXPECT_EQ(Call({"float3", "float4"}, "float4"), "float4");
	EXPECT_EQ(Call({"float2", "float3"}, "float4"), "ambiguous");
	EXPECT_EQ(Call({"float,float", "int,int", "uint,uint"}, "1,uint"), "uint,uint");
	EXPECT_EQ(Call({"float,float", "double,double"}, "1.0,float"), "float,float");
	// DXC: the worst conversion decides where neither function is better in all arguments.
	EXPECT_EQ(Call({"int,float", "float2,float2"}, "float,float"), "float2,float2");
	EXPECT_EQ(Call({"float,float2", "float2,float"}, "float,float"), "ambiguous");
}

TEST_F(HlslConversions, OverloadsWithOutAndDefaults)
{
	EXPECT_EQ(Call({"out int"}, "float&"), "out int");
	EXPECT_EQ(Call({"inout float4"}, "float&"), "inout float4");
	EXPECT_EQ(Call({"out float3"}, "float4&"), "none: argument 1, float4, cannot take back float3");
	EXPECT_EQ(
		Call({"inout float"}, "float"), "none: argument 1 is written to (inout): a variable is expected, not a value");
	EXPECT_EQ(Call({"S2"}, "A2"), "none: argument 1 is int[2], which does not become S2");
	EXPECT_EQ(Call({"float,float"}, "float"), "none: it takes 2 arguments, not 1");
	EXPECT_EQ(Call({"float,default float"}, "float,float,float"), "none: it takes from 1 to 2 arguments, not 3");
	EXPECT_EQ(Call({"float,default float"}, "float"), "float,default float");
	EXPECT_EQ(Call({"int", "inout int"}, "1"), "int");
	EXPECT_EQ(Call({"int", "float"}, "S2"), "none: ");
}

TEST_F(HlslConversions, ValuesAreConvertedInSteps)
{
	const char* const Names[] = {"float", "float1", "float3", "float4", "float1x1", "float2x2", "float3x3", "float1x4",
		"float4x1", "float2x3", "int", "int2", "int1x2", "int2x1", "int4", "int2x2", "half3", "double4", "bool",
		"bool2"};
	for (const std::string FromName : Names)
	{
		const FType* const From = Find(FromName);
		FConstant Constant;
		for (uint32_t i = 0; i < From->NumComponents(); ++i)
		{
			Constant.push_back(ConvertConstant(Types, EScalar::LiteralInt, From->Scalar, i + 1));
		}
		for (const std::string ToName : Names)
		{
			const FType* const To = Find(ToName);
			FValue* const Variable = MakeVariable(From, Constant);
			FValue* const Made = MakeConversion(Program, Types, Variable, To);
			ASSERT_EQ(Made != nullptr, FindConversion(Types, From, To).bPossible) << FromName << " to " << ToName;
			if (!Made)
			{
				continue;
			}
			EXPECT_TRUE(IsSame(Made->Type, To));
			EXPECT_EQ(Made == Variable, IsSame(From, To));
			const std::optional<FConstant> Folded = Fold(Types, *Made);
			ASSERT_TRUE(Folded) << FromName << " to " << ToName;
			for (uint32_t i = 0; i < To->NumComponents(); ++i)
			{
				// Component (row, column) is the same one; between a vector and a matrix they go in order.
				const bool bMatrices = From->IsMatrix() && To->IsMatrix() && From->NumComponents() > 1;
				const uint32_t At = bMatrices ? i / To->Columns * From->Columns + i % To->Columns : i;
				const uint32_t Source = From->NumComponents() == 1 ? 0 : At;
				const bool bBools = From->Scalar == EScalar::Bool || To->Scalar == EScalar::Bool;
				EXPECT_EQ(ConvertConstant(Types, To->Scalar, EScalar::Int, Folded->at(i)), bBools ? 1 : Source + 1)
					<< FromName << " to " << ToName;
			}
			// Each step is one that the emitter has.
			for (const FValue* Step = Made; Step != Variable; Step = Step->Operands[0])
			{
				const FType* const Before = Step->Operands[0]->Type;
				ASSERT_EQ(Step->Operands.size(), 1u);
				const bool bShape = Before->Shape != Step->Type->Shape || Before->Columns != Step->Type->Columns ||
									Before->Rows != Step->Type->Rows;
				EXPECT_NE(bShape, Before->Scalar != Step->Type->Scalar) << FromName << " to " << ToName;
			}
			// A constant stays one.
			const FValue* const Constantly = MakeConversion(Program, Types, MakeConstant(From, Constant), To);
			EXPECT_EQ(Constantly->Kind, EValue::Constant);
			EXPECT_EQ(Constantly->Constant, *Folded);
		}
	}
}

TEST_F(HlslConversions, CastsOfComposites)
{
	FStructType Struct;
	Struct.Name = "FMixed";
	Struct.Members = {{"A", Find("float2"), {}, "", 0}, {"B", Find("int"), {}, "", 0}};
	const FType* const Mixed = Types.Struct(Struct);
	const FType* const Literal = Find("1");
	const FValue* const Zero = MakeConversion(Program, Types, MakeConstant(Literal, {0}), Mixed, true);
	ASSERT_NE(Zero, nullptr);
	EXPECT_EQ(Zero->Kind, EValue::Zero);
	EXPECT_TRUE(Zero->Operands.empty());
	EXPECT_EQ(MakeConversion(Program, Types, MakeConstant(Literal, {0}), Mixed), nullptr);

	const FValue* const Seven = MakeConversion(Program, Types, MakeConstant(Literal, {7}), Mixed, true);
	EXPECT_EQ(Seven->Kind, EValue::Constant);
	EXPECT_EQ(Seven->Constant, (FConstant{0x40E00000, 0x40E00000, 7}));

	FValue* const Array = MakeVariable(Find("A3"), FConstant{1, 2, 3});
	const FValue* const Cast = MakeConversion(Program, Types, Array, Mixed, true);
	EXPECT_EQ(Cast->Kind, EValue::Cast);
	EXPECT_EQ(*Fold(Types, *Cast), (FConstant{0x3F800000, 0x40000000, 3}));
	const FValue* const Back =
		MakeConversion(Program, Types, MakeVariable(Mixed, Fold(Types, *Cast)), Find("int2"), true);
	EXPECT_EQ(*Fold(Types, *Back), (FConstant{1, 2}));
}

} // namespace
} // namespace Drydock::Hlsl::Tests
