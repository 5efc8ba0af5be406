// Texts without measure: each ends soon, with a message that says which bound it is beyond.
#include "HlslFrontEnd.h"

#include "Diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace Drydock::Hlsl::Tests
{
namespace
{

std::string Repeat(const std::string& Text, int Count)
{
	std::string Result;
	for (int i = 0; i < Count; ++i)
	{
		Result += Text;
	}
	return Result;
}

/** The first message, or nothing. */
std::string CompileBody(const std::string& Before, const std::string& Body)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Bounds.usf";
	Request.EntryPoint = "Main";
	Request.Stage = EShaderStage::Compute;
	try
	{
		Compile("RWStructuredBuffer<float4> Out;\n" + Before +
					"\n[numthreads(1, 1, 1)] void Main(uint3 P : SV_DispatchThreadID)\n{\n" + Body + "\n}\n",
			Request);
	}
	catch (const FError& Error)
	{
		return Error.GetDiagnostics().front().Message;
	}
	return {};
}

TEST(HlslBounds, Depth)
{
	const std::pair<std::string, std::string> Nests[] = {{"Out[0] = " + Repeat("(", 100000), Repeat(")", 100000) + ";"},
		{"Out[0] = " + Repeat("- ", 100000), "1;"}, {"Out[0] = " + Repeat("!", 100000), "1;"},
		{"Out[0] = " + Repeat("sin(", 50000), Repeat(")", 50000) + ";"}, {Repeat("{", 100000), Repeat("}", 100000)},
		{Repeat("if (P.x) ", 100000), ";"}, {Repeat("if (P.x) Out[0] = 1; else ", 50000), ";"},
		{"float4 A = " + Repeat("{", 100000), "1" + Repeat("}", 100000) + ";"},
		{"Out[0] = " + Repeat("P.x ? 1 : ", 20000), "2;"}, {"Out[0] = " + Repeat("(float)", 50000), "1;"},
		{Repeat("vector<", 50000), "float, 2> A;"}};
	for (const auto& [First, Last] : Nests)
	{
		EXPECT_THAT(CompileBody("", First + Last), testing::HasSubstr("nested too deep")) << First.substr(0, 40);
	}
	EXPECT_THAT(CompileBody("", "float A = P.x; Out[0] = A" + Repeat(" + A", 100000) + ";"),
		testing::HasSubstr("more than 1024 operators in a row"));
	EXPECT_THAT(CompileBody(Repeat("namespace N { ", 100000), ""), testing::HasSubstr("nested too deep"));
}

TEST(HlslBounds, Size)
{
	std::string Calls = "float F0(float X) { return X * 2; }\n";
	for (int i = 1; i <= 40; ++i)
	{
		const std::string Callee = "F" + std::to_string(i - 1);
		Calls += "float F" + std::to_string(i) + "(float X) { return " + Callee + "(X) + " + Callee + "(X + 1); }\n";
	}
	EXPECT_THAT(CompileBody(Calls, "Out[0] = F40(P.x);"), testing::HasSubstr("the shader is too large"));
	EXPECT_THAT(
		CompileBody("template<int N> float F(float X) { return F<N - 1>(X) + F<N - 1>(X + 1); }\ntemplate<> float "
					"F<0>(float X) { return X; }",
			"Out[0] = F<30>(P.x);"),
		testing::HasSubstr("the shader is too large"));
	EXPECT_THAT(CompileBody("static const float A[70000] = {" + Repeat("1,", 69999) + "1};", "Out[0] = A[P.x];"),
		testing::HasSubstr("more than 65000 values"));
	std::string Cases;
	for (int i = 0; i < 20000; ++i)
	{
		Cases += "case " + std::to_string(i) + ": A += 1; break;";
	}
	EXPECT_THAT(
		CompileBody("", "float A = 0; switch (P.x) {" + Cases + "} Out[0] = A;"), testing::HasSubstr("too large"));
	EXPECT_THAT(
		CompileBody("", "float A[60000][60000]; A[P.x][1] = 1;"), testing::HasSubstr("more than 1048576 numbers"));
	EXPECT_THAT(
		CompileBody("template<typename T, typename U> struct W { T A; U B; }; template<typename T> float F(int D) { "
					"return F<W<T, T> >(D); }",
			"Out[0] = F<int>(1);"),
		testing::HasSubstr("has more than 1048576 numbers"));
	std::string Members;
	for (int i = 0; i < 10000; ++i)
	{
		Members += "float M" + std::to_string(i) + ";";
	}
	EXPECT_EQ(CompileBody("struct FS {" + Members + "};", "FS S = (FS)0; S.M5 = P.x; Out[0] = S.M5;"), "");
}

} // namespace
} // namespace Drydock::Hlsl::Tests
