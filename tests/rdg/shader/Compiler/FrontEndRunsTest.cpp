// How often the front end runs: once for a shader, whoever asks for what of it; and which files are read anew after an
// edit.
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ShaderCompiler.h"
#include "ShaderFrontEnd.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

class FFrontEndRuns : public testing::Test
{
protected:
	FFrontEndRuns() { ForgetCompiledShaders(); }

	static FShaderCompileRequest MakeRequest(const std::string& Text)
	{
		FShaderCompileRequest Request;
		Request.VirtualPath = "/Engine/Generated/Edited.usf";
		Request.EntryPoint = "Main";
		Request.Stage = EShaderStage::Compute;
		Request.GeneratedFiles = {{Request.VirtualPath, Text}};
		return Request;
	}

	/** Reflection and kernels of a shader that differs by a number. */
	static void AskForAll(int Edit)
	{
		const FShaderCompileRequest Request =
			MakeRequest("RWTexture2D<float4> Out;\n[numthreads(8, 8, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n"
						"{\n\tOut[Id.xy] = " +
						std::to_string(Edit) + ";\n}\n");
		EXPECT_EQ(1u, ReflectShader(Request).RWTextures.size());
		CompileShader(Request);
		FShaderCompileRequest InDouble = Request;
		InDouble.Lanes.bDouble = true;
		CompileShader(InDouble);
	}

	const FScratchFolder Scratch;
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", (Scratch.Path / "cache").string()};
};

} // namespace

TEST_F(FFrontEndRuns, OnceForReflectionAndKernelsOfAnEdit)
{
	const int64_t Before = GetNumCompiledTexts();
	for (int Edit = 1; Edit <= 3; ++Edit)
	{
		AskForAll(Edit);
		EXPECT_EQ(Edit, GetNumCompiledTexts() - Before);
	}
}

TEST_F(FFrontEndRuns, FilesAreReadOnceForReflectionAndKernelAndAnewWhereTheyAreNamed)
{
	const std::string Names[] = {"First.usf", "Second.usf"};
	const auto Write = [&](int NumTextures)
	{
		for (const std::string& Name : Names)
		{
			std::string Outputs;
			std::string Body;
			for (int i = 0; i < NumTextures; ++i)
			{
				Outputs += "RWTexture2D<float4> Out" + std::to_string(i) + ";\n";
				Body += "\tOut" + std::to_string(i) + "[Id.xy] = 1;\n";
			}
			Scratch.Add(
				Name, Outputs + "[numthreads(8, 8, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n" + Body + "}\n");
		}
	};
	const auto MakeFileRequest = [](const std::string& Name)
	{
		FShaderCompileRequest Request;
		Request.VirtualPath = "/FrontEndRunsTest/" + Name;
		Request.EntryPoint = "Main";
		Request.Stage = EShaderStage::Compute;
		return Request;
	};
	AddShaderDirectory("/FrontEndRunsTest", Scratch.Path.string());
	const auto CountTextures = [&](const std::string& Name)
	{
		return ReflectShader(MakeFileRequest(Name)).RWTextures.size();
	};
	Write(1);
	EXPECT_EQ(1u, CountTextures(Names[0]));
	EXPECT_EQ(1u, CountTextures(Names[1]));

	Write(2);
	EXPECT_EQ(1u, CompileShader(MakeFileRequest(Names[0]))->Reflection.RWTextures.size());

	ForgetCompiledShaders(FShaderFiles({(Scratch.Path / "." / Names[0]).string()})); // by another name of the file
	EXPECT_EQ(2u, CountTextures(Names[0]));
	EXPECT_EQ(2u, CompileShader(MakeFileRequest(Names[0]))->Reflection.RWTextures.size());
	EXPECT_EQ(1u, CountTextures(Names[1]));
	ForgetCompiledShaders();
	EXPECT_EQ(2u, CountTextures(Names[1]));
}
