// Compilers of the user's own, tried with stand-ins: scripts that are called as dxc or slangc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ChildProcess.h"
#include "HlslCompiler.h"
#include "ShaderFrontEnd.h"
#include "ShaderSource.h"

#include <fstream>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

FShaderHarness MakeShader(const std::string& Body)
{
	FShaderHarness Harness("RWTexture2D<float4> Out;\nfloat Scale;\n[numthreads(1, 1, 1)] void Main(uint3 Id : "
						   "SV_DispatchThreadID)\n{\n" +
							   Body + "\n}\n",
		"Main", EShaderStage::Compute);
	Harness.Textures["Out"] = FTestTexture(2, 1);
	Harness.SetFloats("Scale", {3});
	return Harness;
}

std::vector<std::string> ArgumentsOf(EHlslCompiler Kind, EShaderStage Stage)
{
	FShaderCompileRequest Request;
	Request.EntryPoint = "MainEntry";
	Request.Stage = Stage;
	return MakeHlslCompilerArguments({"/bin/compiler", Kind}, Request, "in.hlsl", "out.spv");
}

} // namespace

class FHlslCompilerTest : public testing::Test
{
protected:
	const FScratchFolder Folder;
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", (Folder.Path / "cache").string()};
};

TEST_F(FHlslCompilerTest, ItsSpirvIsWhatRuns)
{
	// The module is that of another text, so that nothing but the stand-in can have given it.
	const FShaderHarness Other = MakeShader("Out[Id.xy].y = Id.x > 0 ? Scale * 2 : 14;");
	const std::vector<uint32_t> Words = CompileToSpirv(FlattenShader(Other.Request), Other.Request);
	const std::string Module = (Folder.Path / "module.spv").string();
	std::ofstream(Module, std::ios::binary)
		.write(reinterpret_cast<const char*>(Words.data()), std::streamsize(Words.size() * 4));
	const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER",
		Folder.AddScript("dxc", "while [ \"$1\" != -Fo ]; do shift; done; cp \"" + Module + "\" \"$2\""));
	FShaderHarness Harness = MakeShader("Out[Id.xy].y = 5;");
	Harness.Run(4, 2, 1);
	EXPECT_EQ(14.0f, Harness.Textures["Out"].Texel(0, 0)[1]);
	EXPECT_EQ(6.0f, Harness.Textures["Out"].Texel(1, 0)[1]);
}

TEST_F(FHlslCompilerTest, ItsMessagesNameTheAuthorsFileLineAndColumn)
{
	const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER",
		Folder.AddScript(
			"dxc-1.8", "echo \"/Test/Shader.usf:5:7: error: use of undeclared identifier 'Nothing'\" >&2; exit 1"));
	FShaderHarness Harness = MakeShader("\tOut[Id.xy] = Nothing;");
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		AllOf(HasSubstr("/Test/Shader.usf:5:7: error: use of undeclared identifier 'Nothing' [DD6010]"),
			HasSubstr("\n  5 | \tOut[Id.xy] = Nothing;\n    | \t     ^")));
}

TEST_F(FHlslCompilerTest, MembersOfUniformBuffersAreWrittenAsTheEngineWritesThem)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Shader.usf";
	Request.UniformBuffers = {{"View", {"ViewSizeAndInvSize"}, "cbuffer View { float4 View_ViewSizeAndInvSize; };\n"}};
	EXPECT_THAT(WriteForCompiler("float2 A = View.ViewSizeAndInvSize.xy;\nfloat B = Other.View.ViewSizeAndInvSize;\n"
								 "float C = View.NotThere;\n",
					Request),
		AllOf(HasSubstr("float2 A = View_ViewSizeAndInvSize.xy;\n"), HasSubstr("Other.View.ViewSizeAndInvSize;\n"),
			HasSubstr("float C = View.NotThere;")));
}

TEST_F(FHlslCompilerTest, WhatAnotherCompilerMadeIsNotTaken)
{
	FShaderHarness Harness = MakeShader("Out[Id.xy] = 5;");
	Harness.Run(4, 1, 1);
	const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", Folder.AddScript("dxc", "exit 3"));
	EXPECT_THAT(ErrorOf([&] { CompileShader(Harness.Request); }), HasSubstr("dxc ended with exit code 3 on 'Main'"));
}

TEST_F(FHlslCompilerTest, ProgramsThatCannotBeCalledAreNamed)
{
	const FShaderHarness Harness = MakeShader("Out[Id.xy] = 6;");
	{
		const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", "/nonexistent/dxc");
		EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
			HasSubstr("DRYDOCK_HLSL_COMPILER: there is no program '/nonexistent/dxc'"));
	}
	const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", Folder.AddScript("fxc", "exit 0"));
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		HasSubstr("'fxc' is not known; a program is called as its name begins: dxc or slangc"));
}

TEST_F(FHlslCompilerTest, OneThatIsNotThereIsNamedWhateverTheCacheHolds)
{
	FShaderHarness Harness = MakeShader("Out[Id.xy] = 6;");
	Harness.Run(4, 1, 1);
	for (const std::string& Name : {std::string("/nonexistent/dxc"), std::string(" "), Folder.Path.string()})
	{
		ForgetCompiledShaders(); // the files of the cache stay
		const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", Name);
		EXPECT_THAT(ErrorOf([&] { CompileShader(Harness.Request); }),
			HasSubstr("DD6012: DRYDOCK_HLSL_COMPILER: there is no program '" + Name + "'"));
	}
}

TEST_F(FHlslCompilerTest, OnlyAFileOfWhatItWritesIsRead)
{
	const std::string Output = "while [ \"$1\" != -Fo ]; do shift; done; ";
	for (const auto& [Script, Problem] : {std::pair("exit 0", "No such file or directory"),
			 std::pair("mkfifo \"$2\"", "it is a pipe, and only files are read"),
			 std::pair("ln -s /dev/zero \"$2\"", "it is a device, and only files are read"),
			 std::pair("truncate -s 20G \"$2\"", "it has 21474836480 bytes, and at most 16777216 are read")})
	{
		const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", Folder.AddScript("dxc", Output + Script));
		EXPECT_THAT(ErrorOf([&] { ReflectShader(MakeShader("Out[Id.xy] = 6;").Request); }),
			HasSubstr(std::string("DD6012: dxc has written nothing that can be read for 'Main': ") + Problem));
	}
}

TEST(HlslCompilerArguments, AreThoseOfTheProgram)
{
	const std::vector<std::string> Dxc = ArgumentsOf(EHlslCompiler::Dxc, EShaderStage::Pixel);
	EXPECT_THAT(Dxc, AllOf(Contains("-spirv"), Contains("ps_6_0"), Contains("MainEntry"), Contains("-Zpr")));
	EXPECT_EQ("in.hlsl", Dxc.back());
	EXPECT_EQ("out.spv", Dxc[Dxc.size() - 2]);
	const std::vector<std::string> Slang = ArgumentsOf(EHlslCompiler::Slang, EShaderStage::Vertex);
	EXPECT_THAT(Slang, AllOf(Contains("spirv"), Contains("vertex"), Contains("-matrix-layout-row-major")));
}

TEST(ParseCompilerMessages, ReadsEveryForm)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Shader.usf";
	Request.EntryPoint = "Main";
	const std::vector<FDiagnostic> Errors = ParseCompilerMessages(
		"/A/B.ush:12:34: error: use of undeclared identifier 'Foo'\n    return Foo;\n           ^\n"
		"/A/B.ush:13:1: warning: unused\n/A/C.usf(7): error 30015: undefined identifier 'Bar'.\n"
		"/A/D.usf(8,9): fatal error: too much\nerror: missing entry point 'Main' definition\n",
		Request);
	std::vector<std::string> Texts;
	for (const FDiagnostic& Error : Errors)
	{
		Texts.push_back(Error.ToString());
	}
	EXPECT_THAT(
		Texts, ElementsAre("/A/B.ush:12:34: error: use of undeclared identifier 'Foo' [DD6010]",
				   "/A/C.usf:7: error: undefined identifier 'Bar'. [DD6010]", "/A/D.usf:8:9: error: too much [DD6010]",
				   "/Test/Shader.usf: error DD6011: missing entry point 'Main' definition"));
}
