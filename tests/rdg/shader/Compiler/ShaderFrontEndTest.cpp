// What an author sees when a shader is wrong: file, line, all messages, and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ChildProcess.h"
#include "ShaderHarness.h"

#include <csignal>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

/** Errors of a compute shader with an output texture, whose line 1 declares it. */
std::string ErrorsOf(const std::string& Text, EShaderStage Stage = EShaderStage::Compute)
{
	return ErrorOf([&] { ReflectShader(FShaderHarness("RWTexture2D<float4> Out;\n" + Text, "Main", Stage).Request); });
}

/** Errors of one statement in an entry point, on line 3. */
std::string ErrorsOfStatement(const std::string& Statement, const std::string& Globals = "")
{
	return ErrorsOf(Globals +
					"\n[numthreads(8, 8, 1)] void Main(uint3 Id : SV_DispatchThreadID, uint Lane : SV_GroupIndex) {\n" +
					Statement + "\n}\n");
}

} // namespace

TEST(ShaderErrors, SyntaxErrorHasFileAndLine)
{
	EXPECT_THAT(ErrorsOf("void Main()\n{\n\tint a = (1;\n}\n"),
		HasSubstr("/Test/Shader.usf:4:12: error: X3000: syntax error: unexpected token ';'; expected ')' of the '(' in "
				  "line 4, column 10"));
}

TEST(ShaderErrors, SeveralErrorsAreAllReported)
{
	const std::string Syntax = ErrorsOf("void Main()\n{\n\tfloat a = 1, b = (2;\n}\nfloat F() { return 2 +; }\n");
	EXPECT_THAT(Syntax, AllOf(HasSubstr("/Test/Shader.usf:4:"), HasSubstr("/Test/Shader.usf:6:")));
	const std::string Names = ErrorsOf(
		"float F() { return Bar(2); }\n[numthreads(1, 1, 1)] void Main()\n{\n\tfloat a = Foo(1), b = F();\n}\n");
	EXPECT_THAT(Names,
		AllOf(HasSubstr("/Test/Shader.usf:5:12: error: X3004: undeclared identifier 'Foo': there is no such function"),
			HasSubstr("/Test/Shader.usf:2:20: error: X3004: undeclared identifier 'Bar': there is no such function")));
}

TEST(ShaderErrors, LineSurvivesIncludesAndCarriageReturns)
{
	FShaderHarness Harness(
		"#include \"Inner.ush\"\r\n\r\nfloat4 Main() : SV_Target0 { return Nope; }\r\n", "Main", EShaderStage::Pixel);
	Harness.Request.GeneratedFiles.push_back({"/Test/Inner.ush", "float Fine() { return 1; }\r\n\r\n\r\n\r\n"});
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		HasSubstr("/Test/Shader.usf:3:37: error: X3004: undeclared identifier 'Nope'"));
}

TEST(ShaderErrors, ErrorInAnIncludeNamesTheInclude)
{
	FShaderHarness Harness(
		"#include \"Inner.ush\"\nfloat4 Main() : SV_Target0 { return Broken(); }\n", "Main", EShaderStage::Pixel);
	Harness.Request.GeneratedFiles.push_back({"/Test/Inner.ush", "\nfloat Broken() { return Nope; }\n"});
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		HasSubstr("/Test/Inner.ush:2:25: error: X3004: undeclared identifier 'Nope'"));
}

TEST(ShaderErrors, UnknownEntryPointIsNamed)
{
	EXPECT_THAT(ErrorsOf("float F() { return 1; }\n"), HasSubstr("entry point 'Main' does not exist"));
}

TEST(ShaderErrors, UnknownUniformBufferMemberNamesTheNearest)
{
	FShaderHarness Harness(
		"cbuffer View { float4 View_ViewSize; };\nfloat4 Main() : SV_Target0\n{\n\treturn View.ViewSice;\n}\n", "Main",
		EShaderStage::Pixel);
	Harness.Request.UniformBuffers = {{"View", {"ViewSize", "Exposure"}, ""}};
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		HasSubstr(
			"/Test/Shader.usf:4:14: error: uniform buffer 'View' has no member 'ViewSice'; did you mean ViewSize?"));
}

TEST(ShaderErrors, UnknownMemberInInactiveTextIsNone)
{
	FShaderHarness Harness("#if 0\nfloat x = View.Nothing;\n#endif\nfloat4 Main() : SV_Target0 { return 1; }\n", "Main",
		EShaderStage::Pixel);
	Harness.Request.UniformBuffers = {{"View", {"ViewSize"}, ""}};
	EXPECT_EQ("", ErrorOf([&] { ReflectShader(Harness.Request); }));
}

TEST(ShaderRefusals, DerivativesSayWhatToDo)
{
	EXPECT_THAT(ErrorsOfStatement("Out[Id.xy] = ddx(float(Id.x));"),
		HasSubstr("/Test/Shader.usf:4:14: error: X4532: ddx in a compute shader is an error: only pixel shaders have "
				  "neighbours to take a difference from; compute the step from the size of a texel"));
}

TEST(ShaderRefusals, WaveIntrinsicsOfPixelShadersAreNamedAsInHlsl)
{
	const char* const Calls[] = {"WaveActiveSum(x)", "WavePrefixSum(x)", "WaveActiveProduct(x)", "WaveActiveMax(x)",
		"WaveActiveMin(x)", "WaveActiveAnyTrue(x > 1)", "WaveActiveAllTrue(x > 1)", "WaveActiveBallot(x > 1).x",
		"WaveReadLaneFirst(x)", "WaveReadLaneAt(x, 1)", "WaveIsFirstLane()", "WaveGetLaneCount()",
		"WaveGetLaneIndex()"};
	for (const std::string Call : Calls)
	{
		const std::string Name = Call.substr(0, Call.find('('));
		EXPECT_THAT(
			ErrorsOf("float4 Main(float x : TEXCOORD0) : SV_Target0\n{\n\treturn float4(" + Call + ", 0, 0, 1);\n}\n",
				EShaderStage::Pixel),
			HasSubstr(Name + ": wave operations run in compute shaders only"));
	}
}

TEST(ShaderRefusals, TypesAreNamedAsInHlsl)
{
	EXPECT_THAT(ErrorsOfStatement("Out[Id.xy] = T.Load(int2(0, 0), 0);", "Texture2DMS<float4> T;"),
		HasSubstr("/Test/Shader.usf:2:1: error: a multisampled texture ('Texture2DMS') does not run on the CPU "
				  "tier; resolve it into a Texture2D first"));
	EXPECT_THAT(ErrorsOfStatement("Out[Id.xy] = T.Load(int2(0, 0));", "Texture1D<float4> T;"),
		HasSubstr("/Test/Shader.usf:4: error: Texture1D<float4> is not supported on the CPU tier; use Texture2D"));
}

TEST(ShaderRefusals, RecursionNamesTheFunctions)
{
	const std::string Errors = ErrorsOfStatement("Out[Id.xy] = F(int(Id.x));",
		"float G(int n); float F(int n) { return n < 2 ? 1 : G(n - 1) * n; } float G(int n) { "
		"return F(n - 1); }");
	EXPECT_THAT(
		Errors, AnyOf(HasSubstr("'F' calls 'G'"), HasSubstr("'G' calls 'F'"))); // one edge of a circle is enough
	EXPECT_THAT(Errors, HasSubstr("write a loop"));
}

TEST(ShaderRefusals, AtomicsOfPixelShadersWhoseOrderIsSeenSayWhatToDo)
{
	const auto ErrorsOfPixel = [](const std::string& Body)
	{
		return ErrorsOf(
			"RWStructuredBuffer<uint> B;\nfloat4 Main(float x : TEXCOORD0) : SV_Target0\n{\n" + Body + "\n}\n",
			EShaderStage::Pixel);
	};
	EXPECT_THAT(ErrorsOfPixel("uint Old;\nInterlockedAdd(B[0], 1u, Old);\nreturn Old;"),
		HasSubstr("/Test/Shader.usf:6: error: an atomic operation of which the order is seen: pixels have none"));
	EXPECT_EQ("", ErrorsOfPixel("InterlockedAdd(B[0], 1u);\nreturn x;"));
}

TEST(ShaderRefusals, InputsThatNoPassFillsAreNamed)
{
	EXPECT_THAT(ErrorsOf("float4 Main(float4 C[13] : NORMAL) : SV_Target0 { return C[12]; }\n", EShaderStage::Pixel),
		HasSubstr("semantic NORMAL12"));
	EXPECT_THAT(ErrorsOf("float4 Main(uint C : SV_PrimitiveID) : SV_Target0 { return C; }\n", EShaderStage::Pixel),
		HasSubstr("semantic SV_PRIMITIVEID"));
	EXPECT_THAT(ErrorsOf("float4 Main(float4 P : SV_POSITION) : COLOR0 { return P; }\n", EShaderStage::Pixel),
		HasSubstr(
			"(COLOR0) is not supported on the CPU tier; outputs are colours of float, int or uint to SV_Target0..7"));
}

TEST(ShaderRefusals, InputsOfTypesThatNoPassFillsAreNamed)
{
	EXPECT_THAT(ErrorsOf("float4 Main(nointerpolation double2 C : TEXCOORD0) : SV_Target0 { return float4(C, C); }\n",
					EShaderStage::Pixel),
		HasSubstr("(TEXCOORD0) is of a type that the CPU tier does not fill (double2); use up to four floats, int or "
				  "uint"));
}

TEST(ShaderRefusals, GroupsLargerThanDirect3DsAreNamed)
{
	EXPECT_THAT(ErrorsOf("[numthreads(64, 32, 1)] void Main(uint3 Id : SV_DispatchThreadID) { Out[Id.xy] = 1; }\n"),
		HasSubstr("numthreads(64, 32, 1)"));
}

TEST(ShaderRefusals, GroupsOfNegativeSizesAreNamed)
{
	for (const char* const Sizes : {"-1, 1, 1", "1, -2, 1", "1, 1, -1"})
	{
		EXPECT_THAT(ErrorsOf("[numthreads(" + std::string(Sizes) +
							 ")] void Main(uint3 Id : SV_DispatchThreadID) { Out[Id.xy] = 1; }\n"),
			HasSubstr("[numthreads] of 'Main' has a negative number"))
			<< Sizes;
	}
}

TEST(ShaderRefusals, AComputeShaderWithoutAGroupSizeIsNamedOnItsLine)
{
	const std::string Body = "void Main(uint3 Id : SV_DispatchThreadID)\n{\n	Out[Id.xy] = 1;\n}\n";
	const std::string Other = "[numthreads(8, 8, 1)]\nvoid Other(uint3 Id : SV_DispatchThreadID)\n{\n	Main(Id);\n}\n";
	const std::string Without = ErrorsOf("\n" + Body + Other);
	EXPECT_THAT(Without, HasSubstr("'Main' has no [numthreads(X, Y, Z)] before it"));
	EXPECT_THAT(Without, HasSubstr("/Test/Shader.usf:3:"));
	EXPECT_EQ("", ErrorsOf("[numthreads(8, 8, 1)]\n[some(1)] " + Body));
}

TEST(RunChild, GivesOutputAndExitCode)
{
	const FChildResult Result = RunChild({"/bin/sh", "-c", "echo out; echo err >&2; exit 3"}, 10);
	EXPECT_EQ(3, Result.ExitCode);
	EXPECT_EQ("out\nerr\n", Result.Output);
}

TEST(RunChild, PassesArgumentsWithoutAShell)
{
	EXPECT_EQ("$(id) ; `x` 'y'\n", RunChild({"/bin/echo", "$(id) ; `x` 'y'"}, 10).Output);
}

TEST(RunChild, EndsWhatTakesTooLong)
{
	const FChildResult Result = RunChild({"/bin/sh", "-c", "sleep 60"}, 1);
	EXPECT_TRUE(Result.bTimedOut);
	EXPECT_EQ("took longer than 1 s", Result.Describe(1));
}

TEST(RunChild, NamesTheSignalOfACrash)
{
	EXPECT_EQ("was ended by signal 11", RunChild({"/bin/sh", "-c", "kill -SEGV $$"}, 10).Describe(10));
}

TEST(RunChild, GoesWithAParentThatIsKilled)
{
	int Pipe[2]; // held by all that lives
	ASSERT_EQ(0, pipe(Pipe));
	const pid_t Parent = fork();
	if (Parent == 0)
	{
		const std::string Held = std::to_string(dup(Pipe[1])); // which exec does not close
		close(Pipe[0]);
		RunChild({"/bin/sh", "-c", "sleep 60 & printf x >&" + Held + "; wait"}, 60);
		_exit(0);
	}
	close(Pipe[1]);
	char Byte;
	ASSERT_EQ(1, read(Pipe[0], &Byte, 1)); // the shell and what it started are there
	kill(Parent, SIGKILL);
	waitpid(Parent, nullptr, 0);
	pollfd Poll{Pipe[0], POLLIN, 0};
	EXPECT_EQ(1, poll(&Poll, 1, 10000)) << "a process lives on";
	EXPECT_EQ(0, read(Pipe[0], &Byte, 1));
	close(Pipe[0]);
}

TEST(RunChild, MissingProgramDoesNotStart)
{
	EXPECT_FALSE(RunChild({"/nonexistent/program"}, 10).bStarted);
}
