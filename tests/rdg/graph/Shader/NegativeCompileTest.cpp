// What the parameter macros refuse, and in which words: each file of NegativeCompile/ is given to the compiler.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{

struct FCompilation
{
	int ExitCode = 0;
	std::string Output;
};

FCompilation Compile(const std::string& File)
{
	const std::string Source = DRYDOCK_TEST_SOURCE_DIR;
	const char* const Compiler = std::getenv("CXX");
	std::string Command = std::string(Compiler ? Compiler : "c++") +
						  " -std=c++20 -fsyntax-only -fno-diagnostics-color -DGLM_FORCE_XYZW_ONLY";
	for (const char* Folder : {"core/Core", "core/Kernel", "core/RHI", "graph/Shader", "graph/Graph", "graph/Binding"})
	{
		Command += " -I'" + Source + "/rdg/" + Folder + "'";
	}
	Command += " '" + Source + "/tests/rdg/graph/Shader/NegativeCompile/" + File + ".cpp' 2>&1";

	FCompilation Result;
	FILE* const Pipe = popen(Command.c_str(), "r");
	std::array<char, 4096> Buffer;
	while (const size_t Count = std::fread(Buffer.data(), 1, Buffer.size(), Pipe))
	{
		Result.Output.append(Buffer.data(), Count);
	}
	Result.ExitCode = pclose(Pipe);
	return Result;
}

struct FRefusal
{
	const char* File;
	const char* Message;
};

void PrintTo(const FRefusal& Refusal, std::ostream* Stream)
{
	*Stream << Refusal.File;
}

class NegativeCompile : public testing::TestWithParam<FRefusal>
{
};

} // namespace

TEST(NegativeCompileControl, AGoodStructCompiles)
{
	const FCompilation Result = Compile("Accepted");
	EXPECT_EQ(0, Result.ExitCode) << Result.Output;
}

TEST_P(NegativeCompile, IsRefusedInWords)
{
	const FCompilation Result = Compile(GetParam().File);
	EXPECT_NE(0, Result.ExitCode);
	EXPECT_THAT(Result.Output, testing::HasSubstr(GetParam().Message));
}

INSTANTIATE_TEST_SUITE_P(Shader, NegativeCompile,
	testing::Values(
		FRefusal{"BoolParameter", "bool is not a shader parameter: its size differs between C++ and HLSL. Use uint32"},
		FRefusal{"DoubleParameter", "double is not a shader parameter: use float."},
		FRefusal{"Vector2DParameter", "FVector2D is double precision and not a shader parameter: use FVector2f."},
		FRefusal{"VectorParameter", "FVector is double precision and not a shader parameter: use FVector3f."},
		FRefusal{"Vector4Parameter", "FVector4 is double precision and not a shader parameter: use FVector4f."},
		FRefusal{"FloatArray", "SHADER_PARAMETER_ARRAY elements must be a multiple of 16 bytes"},
		FRefusal{"Vector2fArray", "SHADER_PARAMETER_ARRAY elements must be a multiple of 16 bytes"},
		FRefusal{"ScalarArrayOfVectors", "SHADER_PARAMETER_SCALAR_ARRAY takes float, int32 or uint32."},
		FRefusal{"StructAsNumber", "This type is not a shader parameter"},
		FRefusal{"ForeignPermutationDimension", "this dimension is not (or twice) in the permutation domain"}),
	[](const testing::TestParamInfo<FRefusal>& Info) { return std::string(Info.param.File); });
