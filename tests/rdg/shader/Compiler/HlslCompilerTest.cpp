// Compilers of the user's own, tried with stand-ins: programs that are called as dxc or slangc, and let
// glslangValidator do the work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ChildProcess.h"
#include "HlslCompiler.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/** Takes dxc's arguments; tells errors as dxc does. */
const char* const LikeDxc = R"(while [ $# -gt 0 ]; do
	case "$1" in
	-T) Profile=$2; shift ;;
	-E) Entry=$2; shift ;;
	-Fo) Output=$2; shift ;;
	-HV) shift ;;
	-*) ;;
	*) Input=$1 ;;
	esac
	shift
done
case "$Profile" in cs_*) Stage=comp ;; ps_*) Stage=frag ;; *) Stage=vert ;; esac
Said=$(glslangValidator -D -V -g --hlsl-offsets --nan-clamp -fhlsl_functionality1 --auto-map-bindings \
	--auto-map-locations -S "$Stage" -e "$Entry" -o "$Output" "$Input") && exit 0
echo "$Said" | sed -n 's/^ERROR: \(\/[^:]*\):\([0-9]*\): \(.*\)/\1:\2:7: error: \3/p' >&2
exit 1)";

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
	void SetUp() override
	{
		if (FindProgram("glslangValidator").empty())
		{
			GTEST_SKIP() << "glslangValidator (package glslang-tools), which the stand-ins call, is not installed";
		}
	}

	const FScratchFolder Folder;
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", (Folder.Path / "cache").string()};
};

TEST_F(FHlslCompilerTest, ItsSpirvIsWhatRuns)
{
	const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", Folder.AddScript("dxc", LikeDxc));
	FShaderHarness Harness = MakeShader("Out[Id.xy].y = select(Id.x > 0, Scale, 7.0) * 2;");
	Harness.Run(4, 2, 1);
	EXPECT_EQ(14.0f, Harness.Textures["Out"].Texel(0, 0)[1]);
	EXPECT_EQ(6.0f, Harness.Textures["Out"].Texel(1, 0)[1]);
}

TEST_F(FHlslCompilerTest, ItsMessagesNameTheAuthorsFileLineAndColumn)
{
	const FScopedVariable Chosen("DRYDOCK_HLSL_COMPILER", Folder.AddScript("dxc-1.8", LikeDxc));
	FShaderHarness Harness = MakeShader("\tOut[Id.xy] = Nothing;");
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		AllOf(HasSubstr("/Test/Shader.usf:5:7: error: 'Nothing' : unknown variable [DD6010]"),
			HasSubstr("\n  5 | \tOut[Id.xy] = Nothing;\n    | \t     ^")));
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
		HasSubstr("'fxc' is not known; a program is called as its name begins: dxc, slangc or glslang"));
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
	EXPECT_THAT(ArgumentsOf(EHlslCompiler::Glslang, EShaderStage::Compute), AllOf(Contains("comp"), Contains("-D")));
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
