// What stands below a message about a shader: the line, the caret, the path on disk; and one message for one cause.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ShaderMessages.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string ErrorsOf(const FShaderCompileRequest& Request)
{
	return ErrorOf([&] { ReflectShader(Request); });
}

FShaderCompileRequest MakeRequest(const std::string& Body)
{
	return FShaderHarness("RWTexture2D<float4> Out;\n[numthreads(1, 1, 1)] void Main()\n{\n" + Body + "\n}\n", "Main",
		EShaderStage::Compute)
		.Request;
}

/** Lines of prose may be broken anywhere. */
std::string JoinBlanks(const std::string& Text)
{
	std::istringstream Words(Text);
	std::string Result;
	for (std::string Word; Words >> Word;)
	{
		Result += (Result.empty() ? "" : " ") + Word;
	}
	return Result;
}

/** The next block that begins with "```Kind"; empty at the end. At: behind it then. */
std::string NextBlock(const std::string& Text, const std::string& Kind, size_t& At)
{
	const std::string Fence = "```" + Kind + "\n";
	const size_t Open = Text.find(Fence, At);
	const size_t Close = Open == std::string::npos ? Open : Text.find("\n```", Open);
	At = Close == std::string::npos ? Text.size() : Close + 1;
	return Close == std::string::npos ? "" : Text.substr(Open + Fence.size(), Close + 1 - Open - Fence.size());
}

} // namespace

TEST(ShaderMessages, ThePageQuotesWhatIsPrinted)
{
	std::ifstream File(DRYDOCK_TEST_SOURCE_DIR "/docs/shaders.md");
	const std::string Page(std::istreambuf_iterator<char>(File), {});
	const size_t Begin = Page.find("\n## Messages\n");
	ASSERT_NE(std::string::npos, Begin);
	const std::string Section = Page.substr(Begin, Page.find("\n## ", Begin + 1) - Begin);
	const size_t NumDirectories = CountShaderDirectories();
	AddShaderDirectory("/Engine", DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/Engine");
	int NumQuoted = 0;
	for (size_t At = 0;; ++NumQuoted)
	{
		const std::string Text = NextBlock(Section, "hlsl", At);
		if (Text.empty())
		{
			break;
		}
		const bool bPixel = Text.find("SV_Target") != std::string::npos;
		FShaderHarness Harness(Text, "Main", bPixel ? EShaderStage::Pixel : EShaderStage::Compute);
		FShaderCompileRequest& Request = Harness.Request;
		Request.VirtualPath = "/MyPlugin/Tint.usf";
		Request.GeneratedFiles = {{Request.VirtualPath, Text}};
		Request.UniformBuffers = {{"View", {"PreExposure"}, "cbuffer View { float View_PreExposure; };\n"}};
		Harness.Buffers["Out"].assign(64, 0);
		EXPECT_EQ(JoinBlanks(NextBlock(Section, "text", At)), JoinBlanks(ErrorOf([&] { CompileShader(Request); })))
			<< Text;
	}
	ForgetShaderDirectories(NumDirectories);
	EXPECT_EQ(8, NumQuoted);
}

TEST(ShaderMessages, WhatIsDeclaredIsNearest)
{
	FShaderCompileRequest Request = MakeRequest("\tOut[int2(0, 0)] = SceneColr.Load(int3(0, 0, 0));");
	Request.GeneratedFiles[0].second = "Texture2D SceneColor;\n" + Request.GeneratedFiles[0].second;
	EXPECT_THAT(ErrorsOf(Request), HasSubstr("undeclared identifier 'SceneColr'; did you mean SceneColor? [DD6010]"));
	EXPECT_THAT(
		ErrorsOf(MakeRequest("\tfloat4 Color = 1;\n\tfloat A = Colr.x;")), HasSubstr("did you mean Color? [DD6010]"));
	EXPECT_THAT(ErrorsOf(MakeRequest("\tfloat A = Nothing;")), HasSubstr("undeclared identifier 'Nothing' [DD6010]"));
	EXPECT_THAT(ErrorsOf(MakeRequest("\tfloat A = satrate(0.5);")), HasSubstr("; did you mean saturate? [DD6010]"));
	EXPECT_THAT(ErrorsOf(MakeRequest("\tMian();")), HasSubstr("; did you mean Main? [DD6010]"));
}

TEST(ShaderMessages, ShowTheLineAndTheName)
{
	EXPECT_THAT(ErrorsOf(MakeRequest("\tfloat A = 1 + Nothing;")),
		HasSubstr("/Test/Shader.usf:4:16: error: X3004: undeclared identifier 'Nothing' [DD6010]\n"
				  "  4 | \tfloat A = 1 + Nothing;\n"
				  "    | \t              ^"));
}

TEST(ShaderMessages, SemanticsAreRefusedWhereTheyStand)
{
	const auto ErrorOfPixelShader = [](const std::string& Text)
	{
		FShaderCompileRequest Request = MakeRequest("");
		Request.Stage = EShaderStage::Pixel;
		Request.GeneratedFiles[0].second = Text;
		return ErrorsOf(Request);
	};
	EXPECT_THAT(ErrorOfPixelShader("struct FIn\n{\n\tfloat2 UV : TEXCOORD0;\n\tuint Tint : sv_primitiveid;\n};\n"
								   "float4 Main(FIn In) : SV_Target0\n{\n\treturn In.Tint * In.UV.x;\n}\n"),
		HasSubstr("/Test/Shader.usf:4: error: pixel input 'In.Tint' has the semantic "));
	EXPECT_THAT(ErrorOfPixelShader("void Main(float4 P : SV_POSITION,\n\tout float4 C : SV_Target0,\n"
								   "\tout uint D : SV_Coverage)\n{\n\tC = 1;\n\tD = 1;\n}\n"),
		HasSubstr("/Test/Shader.usf:3: error: pixel output 'D' ("));
}

TEST(ShaderMessages, NameTheFileOnDisk)
{
	const FScratchFolder Folder;
	const size_t NumDirectories = CountShaderDirectories();
	AddShaderDirectory("/ShaderMessagesTest", Folder.Path.string());
	const std::string Real =
		Folder.Add("Real.usf", "\r\n[numthreads(1, 1, 1)] void Main()\r\n{\r\n\tfloat B = Gone;\r\n}\r\n");
	FShaderCompileRequest Request = MakeRequest("");
	Request.VirtualPath = "/ShaderMessagesTest/Real.usf";
	const std::string Errors = ErrorsOf(Request);
	ForgetShaderDirectories(NumDirectories);
	EXPECT_THAT(
		Errors, AllOf(HasSubstr("/ShaderMessagesTest/Real.usf:4:12: error: X3004: undeclared identifier 'Gone'"),
					HasSubstr("\n  4 | \tfloat B = Gone;\n    | \t          ^\n  " + Real + ":4:12")));
}

TEST(ShaderMessages, RefusalsShowTheLineToo)
{
	EXPECT_THAT(ErrorsOf(MakeRequest("\tfloat2 A = 2 * ddx(1.0);")),
		AllOf(HasSubstr("/Test/Shader.usf:4:17: error: X4532: ddx in a compute shader"),
			HasSubstr("[DD6010]\n  4 | \tfloat2 A = 2 * ddx(1.0);\n    | \t               ^")));
}

TEST(ShaderMessages, OneNameThatIsMissingIsOneMessage)
{
	FShaderCompileRequest Request =
		MakeRequest("\tfloat A = Scene.X;\n\tfloat B = Scene.Y;\n\tfloat C = Scene.Z;\n\tfloat D = Scene.X;");
	Request.UniformBuffers = {{"Scenes", {"X"}, ""}, {"View", {"Y"}, ""}};
	const std::string Errors = ErrorsOf(Request);
	EXPECT_THAT(Errors,
		HasSubstr("/Test/Shader.usf:4:12: error: X3004: undeclared identifier 'Scene', and no uniform buffer of that "
				  "name is registered; did you mean Scenes?"));
	EXPECT_EQ(Errors.find("error:"), Errors.rfind("error:")) << Errors;
}

TEST(ShaderMessages, WhatFollowsFromAnErrorInItsLineIsNotSaid)
{
	FShaderCompileRequest Request = MakeRequest("\tfloat3 A = View.PreExposre * float3(1, 2, 3);");
	Request.UniformBuffers = {{"View", {"PreExposure"}, "cbuffer View { float View_PreExposure; };\n"}};
	const std::string Errors = ErrorsOf(Request);
	EXPECT_THAT(Errors, HasSubstr("uniform buffer 'View' has no member 'PreExposre'; did you mean PreExposure?"));
	EXPECT_EQ(Errors.find("error:"), Errors.rfind("error:")) << Errors;
	const FError Two({{ESeverity::Error, 6010, "'A' : unknown variable", "/Test/Shader.usf", 4, 0, {}},
						 {ESeverity::Error, 6010, "'*' : wrong operand types", "/Test/Shader.usf", 4, 0, {}},
						 {ESeverity::Error, 6010, "'=' : cannot convert", "/Test/Shader.usf", 5, 0, {}}},
		ExitUsage);
	EXPECT_EQ(2u, ExplainShaderErrors(Two, Request).GetDiagnostics().size()) << "of another line it is said";
}

TEST(ShaderMessages, AnEntryThatIsMissingHasANearestName)
{
	FShaderCompileRequest Request = MakeRequest("\tOut[int2(0, 0)] = 1;");
	Request.EntryPoint = "Mian";
	const std::string Errors = ErrorsOf(Request);
	EXPECT_THAT(Errors, HasSubstr("entry point 'Mian' does not exist in this shader; did you mean Main?"));
	EXPECT_EQ(Errors.find("error"), Errors.rfind("error")) << Errors;
}

TEST(ShaderMessages, WhatStaysOutIsOneMessageWithAWayRound)
{
	struct FLeftOut
	{
		const char* Text;
		EShaderStage Stage;
		const char* Message;
	};
	const FLeftOut LeftOut[] = {
		{"RaytracingAccelerationStructure Scene;\nRWTexture2D<float4> Out;\n[numthreads(1, 1, 1)] void Main()\n{\n"
		 "	RayQuery<0> Query;\n	Query.TraceRayInline(Scene, 0, 255, Ray);\n	Query.Proceed();\n}\n",
			EShaderStage::Compute,
			"/Test/Shader.usf:1:1: error: ray tracing ('RaytracingAccelerationStructure') does not run on the CPU "
			"tier; "
			"march through the depth texture, or read what the G-buffer has [DD6020]\n  1 | "},
		{"struct V { float4 P : SV_POSITION; };\n[maxvertexcount(3)]\n"
		 "void Main(triangle V In[3], inout TriangleStream<V> Out)\n{\n	Out.Append(In[0]);\n}\n",
			EShaderStage::Pixel, "a geometry shader ('maxvertexcount') does not run on the CPU tier; drydock draws"},
		{"struct V { float4 P : SV_POSITION; };\n"
		 "float4 Main(InputPatch<V, 3> Patch) : SV_Target0\n{\n	return Patch[0].P;\n}\n",
			EShaderStage::Pixel,
			"/Test/Shader.usf:2:13: error: tessellation ('InputPatch') does not run on the CPU tier"},
		{"RWTexture2D<float4> Out;\n[outputtopology(\"triangle\")] [numthreads(1, 1, 1)] void Main()\n{\n"
		 "	SetMeshOutputCounts(3, 1);\n}\n",
			EShaderStage::Compute, "a mesh shader ('outputtopology') does not run on the CPU tier"},
		{"Texture2DMS<float4> Source;\nfloat4 Main(float4 P : SV_POSITION) : SV_Target0\n{\n"
		 "	return Source.Load(int2(P.xy), 1);\n}\n",
			EShaderStage::Pixel, "multisampled"},
	};
	for (const FLeftOut& Each : LeftOut)
	{
		const std::string Errors = ErrorsOf(FShaderHarness(Each.Text, "Main", Each.Stage).Request);
		EXPECT_THAT(Errors, HasSubstr(Each.Message));
		EXPECT_THAT(Errors, HasSubstr("/Test/Shader.usf:")) << Each.Text;
		EXPECT_EQ(Errors.find("error:"), Errors.rfind("error:")) << Errors;
	}
}
