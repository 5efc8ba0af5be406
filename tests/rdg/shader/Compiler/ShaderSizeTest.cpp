// Large shaders: work that grows with their length and no faster, the same numbers however the text is cut, and limits
// that are named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"
#include "SpirvEmit.h"
#include "SpirvLimits.h"

#include <algorithm>
#include <random>
#include <sstream>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

constexpr int32_t Width = 19;
constexpr int32_t Height = 3;

/** A compute shader that writes r. Line 1 declares its parameters, Globals begin on line 2, Body two lines after them.
 */
std::string MakeShader(const std::string& Body, const std::string& Globals = "")
{
	return "RWTexture2D<float4> Out; float4 P; int N;\n" + Globals +
		   "\n[numthreads(8, 8, 1)] void Main(uint3 Id : SV_DispatchThreadID) { float4 r = float4(Id.xy, P.xy);\n" +
		   Body + "\nOut[Id.xy] = r; }\n";
}

FShaderHarness MakeHarness(const std::string& Text)
{
	FShaderHarness Harness(Text, "Main", EShaderStage::Compute);
	Harness.SetFloats("P", {0.25f, -1.5f, 3.0f, 0.125f});
	Harness.Constants["N"] = {5};
	Harness.Textures["Out"] = FTestTexture(Width, Height);
	return Harness;
}

std::string Emit(const std::string& Text)
{
	const FShaderHarness Harness(Text, "Main", EShaderStage::Compute);
	const FSpirvModule Module = ReadSpirv(CompileToSpirv(FlattenShader(Harness.Request), Harness.Request));
	const FSpirvStructure Structure = BuildSpirvStructure(Module);
	const FSpirvReflection Reflection = ReflectSpirv(Module, Structure, Text);
	return EmitKernel({Module, Structure, AnalyzeUniformity(Module, Structure), Reflection}, "test");
}

/** The kernel at every given lane count has the model's bits. */
void ExpectModelsBits(const std::string& Text, const std::vector<int32_t>& LaneCounts)
{
	FShaderHarness Model = MakeHarness(Text);
	Model.RunModel(Width, Height);
	for (const int32_t Lanes : LaneCounts)
	{
		FShaderHarness Kernel = MakeHarness(Text);
		Kernel.Run(Lanes, Width, Height);
		for (int32_t i = 0; i < Width * Height * 4; ++i)
		{
			const float Expected = Model.Textures["Out"].Texel(0, 0)[i];
			const float Got = Kernel.Textures["Out"].Texel(0, 0)[i];
			ASSERT_TRUE(SameFloat(Expected, Got)) << Lanes << " lanes, number " << i << ": " << Expected << ", " << Got;
		}
	}
}

/** An array in a struct, given by value, changed there and given back, where some threads run and some do not. */
std::string MakeArrayShader(int Size)
{
	const std::string S = std::to_string(Size);
	return MakeShader(
		"FBig A; for (int i = 0; i < " + S +
			"; ++i) { A.V[i] = i * r.x + P.x; } A.K = int(Id.x);\n"
			"FBig B = Change(A, int(Id.x) * 7);\n"
			"if (Id.x % 3 == 1) { A = Change(B, 2); B.V[N] = -1; }\n"
			"for (int k = 0; k < 3; ++k) { FBig C = B; if (k == int(Id.y)) break; B = A; A = C; A.V[k] += 0.5; }\n"
			"FBig Old = A; A.V[1] = 9; r = float4(Sum(A), Sum(B), Sum(Old), A.K + B.K);",
		"struct FBig { float V[" + S +
			"]; int K; };\n"
			"FBig Change(FBig F, int k) { F.V[k % " +
			S +
			"] += 1; F.K += k; return F; }\n"
			"float Sum(FBig F) { float s = 0; for (int i = 0; i < " +
			S + "; ++i) s += F.V[i] * (i % 5); return s; }");
}

/** Random statements on four vectors, among them branches and loops that are left early. Seed: stated by the caller. */
std::string MakeLongBody(int NumStatements, uint32_t Seed)
{
	std::mt19937 Random(Seed);
	const auto Vector = [&Random]
	{
		return std::string(1, "abcd"[Random() % 4]);
	};
	std::string Body = "float4 a = r; float4 b = r.wzyx * P; float4 c = P; float4 d = r + P.yxwz;\n";
	for (int i = 0; i < NumStatements; ++i)
	{
		const std::string X = Vector(), Y = Vector(), Z = Vector();
		switch (Random() % 10)
		{
		case 0:
			Body += "if (" + Y + ".x > " + Z + ".y) { " + X + " = " + Z + " * 0.5; } else { " + Y + ".z += 0.25; }\n";
			break;
		case 1:
			Body += "for (int i" + std::to_string(i) + " = 0; i" + std::to_string(i) + " < N; ++i" + std::to_string(i) +
					") { if (" + X + ".w > 2) break; " + X + ".w += 0.75; " + Y + " = " + Z + " - 1; }\n";
			break;
		case 2:
			Body += X + " = lerp(" + Y + ", " + Z + ", 0.25);\n";
			break;
		case 3:
			Body += X + " = max(" + Y + ", " + Z + ".yzwx * 0.5);\n";
			break;
		default:
			Body += X + " = " + Y + " * 0.625 + " + Z + ".wxyz;\n";
			break;
		}
	}
	return Body + "r = a + b + c + d;";
}

std::string NestIfs(int Depth)
{
	std::string Open;
	std::string Close;
	for (int i = 0; i < Depth; ++i)
	{
		Open += "if (r.x > " + std::to_string(i) + ") { r.y += r.z;\n";
		Close += "}";
	}
	return Open + Close;
}

} // namespace

TEST(ShaderSize, ArraysByValueAreCopiedByLoops)
{
	const auto CountLines = [](const std::string& Text)
	{
		return std::count(Text.begin(), Text.end(), '\n');
	};
	const std::string Small = Emit(MakeArrayShader(100));
	const std::string Large = Emit(MakeArrayShader(2000));
	EXPECT_LT(CountLines(Large), CountLines(Small) + 10);
	EXPECT_LT(CountLines(Large), 600);
}

TEST(ShaderSize, ArraysByValueHaveTheModelsBits)
{
	ExpectModelsBits(MakeArrayShader(3), {4}); // too small for loops
	ExpectModelsBits(MakeArrayShader(70), GetLaneCounts());
}

TEST(ShaderSize, LongCodeIsCutIntoFunctions)
{
	const std::string Text = Emit(MakeShader(MakeLongBody(3000, 5)));
	std::istringstream Lines(Text);
	size_t InPart = 0;
	size_t Longest = 0;
	size_t NumParts = 0;
	for (std::string Line; std::getline(Lines, Line);)
	{
		const bool bBegins = Line.find("[&]() __attribute__((noinline))") != std::string::npos;
		NumParts += bBegins;
		InPart = bBegins || Line.find("}();") != std::string::npos ? 0 : InPart + 1;
		Longest = NumParts > 0 ? std::max(Longest, InPart) : 0; // before the first one all variables are declared
	}
	EXPECT_GT(NumParts, 8u);
	EXPECT_LT(Longest, 2 * SpirvLimits::LinesPerPart) << "#line directives and braces count here too";
	EXPECT_EQ(std::string::npos, Emit(MakeShader(MakeLongBody(100, 5))).find("[&]()")) << "what is short stays whole";
}

TEST(ShaderSize, LongCodeHasTheModelsBits)
{
	ExpectModelsBits(MakeShader(MakeLongBody(700, 6)), {4});
	ExpectModelsBits(MakeShader("if (Id.x % 2 == 0) { for (int q = 0; q < 2; ++q) { if (q == int(Id.y)) break;\n" +
								MakeLongBody(700, 7) + " } }"),
		{GetWidestLanes(false)});
}

TEST(ShaderSize, ReadingAndEmittingGrowWithTheLength)
{
	// 20,000 operations in a row and 5,000 branches behind each other: seconds if anything were quadratic.
	std::string Line;
	for (int i = 0; i < 5000; ++i)
	{
		Line += i % 5 ? "r = r.yzwx * P + r;\n" : "if (r.x > P.y) { r.z += 1; }\n";
	}
	const FShaderHarness Harness(MakeShader(Line), "Main", EShaderStage::Compute);
	const std::vector<uint32_t> Words = CompileToSpirv(FlattenShader(Harness.Request), Harness.Request);
	const auto Start = std::chrono::steady_clock::now();
	const FSpirvModule Module = ReadSpirv(Words);
	const FSpirvStructure Structure = BuildSpirvStructure(Module);
	const FSpirvReflection Reflection = ReflectSpirv(Module, Structure, "");
	EmitKernel({Module, Structure, AnalyzeUniformity(Module, Structure), Reflection}, "test");
	EXPECT_LT(std::chrono::steady_clock::now() - Start, std::chrono::seconds(20));
}

TEST(ShaderLimits, AreNamedWithEntryLineAndLimit)
{
	const auto ErrorsOf = [](const std::string& Text)
	{
		return ErrorOf([&] { CompileShader(FShaderHarness(Text, "Main", EShaderStage::Compute).Request); });
	};
	EXPECT_THAT(ErrorsOf(MakeShader(NestIfs(250))),
		testing::AllOf(
			HasSubstr("/Test/Shader.usf:204: error: the shader has more than 200 selections and loops inside "
					  "each other, which is drydock's limit"),
			HasSubstr("(entry point Main)"), HasSubstr("DD6021")));
	EXPECT_THAT(ErrorsOf(MakeShader("float A[100000]; A[N] = 1;\nr = A[Id.x];")),
		HasSubstr("the type float[100000] has 100000 numbers, more than the 65536 that are drydock's limit"));
	EXPECT_THAT(ErrorsOf(MakeShader("float A[20000]; float B[20000]; A[N] = 1; B[Id.x] = A[N];\nr = A[Id.x] + B[N];")),
		testing::AllOf(HasSubstr("more than 131072 bytes of arrays for each thread"), HasSubstr("/Test/Shader.usf:4: "),
			HasSubstr("(entry point Main)")));
	std::string Cases;
	for (int i = 0; i < 1100; ++i)
	{
		Cases += "case " + std::to_string(i) + ": r.x = " + std::to_string(i * 3 % 7) + "; break;\n";
	}
	EXPECT_THAT(ErrorsOf(MakeShader("switch (N) {\n" + Cases + "}")), HasSubstr("more than 1000 cases in a switch"));
}
