// Every shipped shader through glslang in its kept process and through glslangValidator: the same words, and after the
// optimiser, which leaves arithmetic of floats alone in the one, the same but for that.
#include <gtest/gtest.h>

#include "ShaderCompilation.h"
#include "ShaderFrontEnd.h"
#include "ShaderSource.h"
#include "SpirvOps.h"
#include "TemporaryFolder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace
{

using namespace Drydock;

/** glslangValidator by the name that the text has in the kept process, which stands in the words: shader.hlsl. */
constexpr const char* Script = "#!/bin/sh\n"
							   "Left=$#\n"
							   "for Argument; do\n"
							   "	shift\n"
							   "	Left=$((Left - 1))\n"
							   "	[ $Left -gt 0 ] && set -- \"$@\" \"$Argument\" || Input=$Argument\n"
							   "done\n"
							   "cd \"$(dirname \"$Input\")\" && exec glslangValidator \"$@\" shader.hlsl\n";

/** The first and the last permutation of a class that are compiled at all. */
std::set<int32> ChoosePermutations(const FShaderType& Type)
{
	std::set<int32> Chosen;
	for (int32 Id = 0; Id < Type.GetPermutationCount(); ++Id)
	{
		if (Type.ShouldCompilePermutation(Id))
		{
			Chosen.erase(Chosen.size() == 2 ? *Chosen.rbegin() : -1);
			Chosen.insert(Id);
		}
	}
	return Chosen;
}

/** What is done with memory and textures, and in which flow: opcodes, in order. */
std::vector<uint32_t> ListEffects(const std::vector<uint32_t>& Words)
{
	constexpr size_t HeaderWords = 5;
	std::vector<uint32_t> Effects;
	for (size_t At = HeaderWords; At < Words.size() && Words[At] >> 16; At += Words[At] >> 16)
	{
		const uint32_t Op = Words[At] & 0xffff;
		const bool bMemory = Op == Spirv::OpLoad || Op == Spirv::OpStore || Op == Spirv::OpImageTexelPointer;
		const bool bImage = Op >= Spirv::OpSampledImage && Op <= Spirv::OpImageQuerySamples;
		const bool bFlow = Op >= Spirv::OpPhi && Op <= Spirv::OpUnreachable;
		if (bMemory || bImage || bFlow)
		{
			Effects.push_back(Op);
		}
	}
	return Effects;
}

} // namespace

TEST(FrontEndBits, AreThoseOfGlslangValidatorForEveryShippedShader)
{
	const FTemporaryFolder Folder;
	const std::string Validator = Folder.Reserve("glslangValidator");
	std::ofstream(Validator) << Script;
	std::filesystem::permissions(Validator, std::filesystem::perms::owner_all);
	int NumShaders = 0;
	int NumSame = 0; // where there was nothing to fold
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			for (const int32 Id : ChoosePermutations(Type))
			{
				FShaderCompileRequest Request =
					MakeShaderCompileRequest(FShaderRef(Type.FindOrCreateShader(Id)), Type.GetRootParametersMetadata());
				if (!Request.VirtualPath.starts_with("/Engine/") && !Request.VirtualPath.starts_with("/Drydock/"))
				{
					continue; // a test's own, which may be broken
				}
				const FShaderSource Source = FlattenShader(Request);
				for (const bool bKeepFunctions : {false, true})
				{
					Request.bKeepFunctions = bKeepFunctions;
					const std::vector<uint32_t> Kept = CompileToSpirv(Source, Request);
					setenv("DRYDOCK_GLSLANG", Validator.c_str(), 1);
					const std::vector<uint32_t> Expected = CompileToSpirv(Source, Request);
					unsetenv("DRYDOCK_GLSLANG");
					EXPECT_FALSE(Expected.empty());
					const std::string Where = std::string(Type.GetName()) + ", permutation " + std::to_string(Id);
					if (bKeepFunctions)
					{
						EXPECT_EQ(Expected, Kept) << Where;
						continue;
					}
					EXPECT_EQ(ListEffects(Expected), ListEffects(Kept)) << Where;
					NumSame += Expected == Kept;
				}
				++NumShaders;
			}
		});
	EXPECT_GT(NumShaders, 40); // there are that many classes in passes/
	EXPECT_GT(NumSame, 5);
}
