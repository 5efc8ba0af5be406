// What stands below a message about a shader: the line, the caret, the path on disk; and one message for one cause.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"

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

} // namespace

TEST(ShaderMessages, ShowTheLineAndTheName)
{
	EXPECT_THAT(ErrorsOf(MakeRequest("\tfloat A = 1 + Nothing;")),
		HasSubstr("/Test/Shader.usf:4: error: 'Nothing' : unknown variable [DD6010]\n"
				  "  4 | \tfloat A = 1 + Nothing;\n"
				  "    | \t              ^"));
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
	EXPECT_THAT(Errors, AllOf(HasSubstr("/ShaderMessagesTest/Real.usf:4: error: 'Gone'"),
							HasSubstr("\n  4 | \tfloat B = Gone;\n    | \t          ^\n  " + Real + ":4:12")));
}

TEST(ShaderMessages, RefusalsShowTheLineToo)
{
	EXPECT_THAT(ErrorsOf(MakeRequest("\tfloat2 A = Gone._m00_m11;")),
		AllOf(HasSubstr("/Test/Shader.usf:4:18: error: several elements of a matrix (_m00_m11)"),
			HasSubstr("[DD6010]\n  4 | \tfloat2 A = Gone._m00_m11;\n    | \t                ^")));
}

TEST(ShaderMessages, OneNameThatIsMissingIsOneMessage)
{
	FShaderCompileRequest Request =
		MakeRequest("\tfloat A = Scene.X;\n\tfloat B = Scene.Y;\n\tfloat C = Scene.Z;\n\tfloat D = Scene.X;");
	Request.UniformBuffers = {{"Scenes", {"X"}, ""}, {"View", {"Y"}, ""}};
	const std::string Errors = ErrorsOf(Request);
	EXPECT_THAT(
		Errors, HasSubstr("/Test/Shader.usf:4: error: 'Scene' : unknown variable, and no uniform buffer of that "
						  "name is registered; did you mean Scenes?"));
	EXPECT_EQ(Errors.find("error:"), Errors.rfind("error:")) << Errors;
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
			"/Test/Shader.usf:1: error: ray tracing ('RaytracingAccelerationStructure') does not run on the CPU tier; "
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
