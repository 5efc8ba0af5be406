// Constants against run time: the same expressions, once of constants, which the front end folds, and once of values
// from a buffer, which the interpreter computes, give the same bits.
#include "ConstantsCases.h"

namespace Drydock::Hlsl::Tests
{
namespace
{

std::vector<FConstantsCase> MakeConstantsCases(
	const std::vector<std::string>& Types, const std::vector<std::string>& Expressions, const std::string& Result = "")
{
	std::vector<FConstantsCase> Cases;
	for (const std::string& Type : Types)
	{
		for (const std::string& Expression : Expressions)
		{
			const std::string Size = Type.substr(ScalarOf(Type).size());
			Cases.push_back({Type,
				Result.empty()                                            ? Type
				: Result == "bool" || Result == "int" || Result == "uint" ? Result + Size
																		  : Result.substr(1),
				Expression});
		}
	}
	return Cases;
}

// The optimiser has rules for an operation of an operation with a constant; what a rule gets wrong differs from the
// folded value.
TEST_F(HlslConstantsRun, AnOperationOfAnOperation)
{
	std::vector<std::string> Expressions;
	for (const char* const Inner : {"(A + 3)", "(A - 3)", "(3 - A)", "(A * 3)", "(A / 3)", "(7 / (A | 1))", "(A / 1)",
			 "(A % 3)", "(-A)", "(A / 0x7FFFFFFF)"})
	{
		for (const char* const Outer : {"-$", "$ + 5", "$ - 5", "5 - $", "$ * 4", "$ / 4", "$ * 3", "$ / 3", "$ % 4",
				 "2 / ($ | 1)", "$ + A", "$ - A", "A - $", "$ * A", "($ / 3) * 3"})
		{
			const std::string Text = Outer;
			const size_t At = Text.find('$');
			Expressions.push_back(Text.substr(0, At) + Inner + Text.substr(At + 1));
		}
	}
	Check(MakeConstantsCases({"int", "uint", "int3"}, Expressions));
	for (std::string& Expression : Expressions)
	{
		Expression.erase(std::remove(Expression.begin(), Expression.end(), '|'), Expression.end());
	}
	std::erase_if(Expressions, [](const std::string& Text) { return Text.find(" 1)") != std::string::npos; });
	Check(MakeConstantsCases({"float", "float2"}, Expressions));
}

TEST_F(HlslConstantsRun, OperatorsAndFunctions)
{
	const std::vector<std::string> Floats = {"float", "float2", "float3", "float4", "float2x2", "float3x4"};
	const std::vector<std::string> Vectors = {"float2", "float3", "float4"};
	const std::vector<std::string> Integers = {"int", "uint", "int3", "uint4", "int2x2"};
	std::vector<FConstantsCase> Cases;
	const auto Add = [&Cases](const std::vector<FConstantsCase>& More)
	{
		Cases.insert(Cases.end(), More.begin(), More.end());
	};
	Add(MakeConstantsCases(
		Floats, {"A + B", "A - B", "A * B", "A / B", "A % B", "-A", "A * 2 + 1.5", "abs(A)", "floor(A)", "ceil(A)",
					"trunc(A)", "round(A)", "frac(A)", "sqrt(A)", "rsqrt(A)", "rcp(A)", "exp(A)", "exp2(A)", "log(A)",
					"log2(A)", "log10(A)", "sin(A)", "cos(A)", "tan(A)", "asin(A)", "acos(A)", "atan(A)", "sinh(A)",
					"cosh(A)", "tanh(A)", "degrees(A)", "radians(A)", "saturate(A)", "fmod(A, B)", "atan2(A, B)",
					"pow(A, B)", "step(A, B)", "min(A, B)", "max(A, B)", "ldexp(A, B)", "clamp(A, B, C)",
					"mad(A, B, C)", "lerp(A, B, C)", "smoothstep(A, B, C)", "select(A < B, A, C)"}));
	Add(MakeConstantsCases(Floats,
		{"A < B", "A > B", "A <= B", "A >= B", "A == B", "A != B", "isnan(A)", "isinf(A)", "isfinite(A)"}, "bool"));
	Add(MakeConstantsCases(Floats, {"int(1) * sign(A)", "A"}, "int"));
	Add(MakeConstantsCases(Floats, {"A", "asuint(A)", "f32tof16(A)"}, "uint"));
	Add(MakeConstantsCases(Vectors, {"normalize(A)", "reflect(A, B)", "refract(A, B, 0.7)", "faceforward(A, B, C)"}));
	Add(MakeConstantsCases(Vectors, {"dot(A, B)", "length(A)", "distance(A, B)"}, "=float"));
	Add(MakeConstantsCases({"float3"}, {"cross(A, B)"}));
	Add(MakeConstantsCases({"float4"}, {"dst(A, B)", "lit(A.x, B.y, C.z)"}));
	Add(MakeConstantsCases({"float2x2", "float3x3", "float4x4"}, {"mul(A, B)", "transpose(A)", "mul(A, 3)", "A * B"}));
	Add(MakeConstantsCases({"float2x2", "float3x3", "float4x4"}, {"determinant(A)", "dot(A[0], A[1])"}, "=float"));
	Add(MakeConstantsCases({"float3x3", "float2x3"}, {"mul(A, B[1])"}, "=float3"));
	Cases.back().Result = "float2";
	Add(MakeConstantsCases({"float3x3", "float3x2"}, {"mul(float3(1, -2, 0.3), A)"}, "=float3"));
	Cases.back().Result = "float2";
	Add(MakeConstantsCases({"float2x3"}, {"mul(A, float3x2(B))"}, "=float2x2"));
	Add(MakeConstantsCases(Integers,
		{"A + B", "A - B", "A * B", "A / (B | 1)", "A % (B | 1)", "-A", "~A", "A & B", "A | B", "A ^ B", "A << B",
			"A >> B", "abs(A)", "min(A, B)", "max(A, B)", "clamp(A, B, C)", "mad(A, B, C)", "reversebits(A)"}));
	Add(MakeConstantsCases(Integers, {"sign(A)"}, "int"));
	Add(MakeConstantsCases(Integers, {"countbits(A)", "firstbithigh(A)", "firstbitlow(A)"}, "uint"));
	Add(MakeConstantsCases(Integers, {"A < B", "A > B", "A <= B", "A >= B", "A == B", "A != B", "A"}, "bool"));
	Add(MakeConstantsCases({"uint", "uint3", "int", "int2"}, {"A", "A * 0.1"}, "=float"));
	for (size_t i = Cases.size() - 8; i < Cases.size(); ++i)
	{
		Cases[i].Result = "float" + Cases[i].Type.substr(ScalarOf(Cases[i].Type).size());
	}
	Add(MakeConstantsCases({"uint", "uint2"}, {"asint(A)", "A"}, "int"));
	Add(MakeConstantsCases({"int3", "int4"}, {"dot(A, B)"}, "=int"));
	Add(MakeConstantsCases({"int2x2"}, {"mul(A, B)", "transpose(A)"}));
	Add(MakeConstantsCases({"bool", "bool3"}, {"and(A, B)", "or(A, B)", "!A", "A == B", "A != B"}));
	Add(MakeConstantsCases({"bool3", "bool2x2"}, {"any(A)", "all(A)"}, "=bool"));
	Add(MakeConstantsCases({"bool3"}, {"A + B", "A * 3", "-A"}, "int"));
	Add(MakeConstantsCases({"bool3"}, {"A * 1.5"}, "=float3"));
	Add(MakeConstantsCases(
		{"float"}, {"float(half(A))", "float(double(A) * 1.0000001L + B)", "A < B || C > 0 ? A : B", "(A, B)"}));
	Add(MakeConstantsCases({"float"}, {"int(double(A) * 3.0L)", "int(int64_t(A))"}, "int"));
	Add(MakeConstantsCases(
		{"int"}, {"int(int64_t(A) * B >> 7)", "int(int64_t(A) / (int64_t(B) | 1))", "int(int16_t(A) * int16_t(B))",
					 "int(uint16_t(A) >> uint16_t(B & 15))", "int(uint64_t(A) % 1000ull)"}));
	Add(MakeConstantsCases({"float"}, {"float(float16_t(A) * float16_t(B))", "float(sqrt(float16_t(A)))",
										  "float(float16_t(A) / float16_t(B) + float16_t(C))"}));
	Add(MakeConstantsCases({"float"}, {"int(int16_t(A))", "int(uint16_t(A))", "int(int64_t(uint64_t(A)))"}, "int"));
	for (int Round = 0; Round < 3; ++Round)
	{
		Check(Cases);
	}
	EXPECT_EQ(NumInstructions[0], 0u) << "not everything is folded";
	EXPECT_GT(NumInstructions[1], Cases.size());
}

} // namespace
} // namespace Drydock::Hlsl::Tests
