// Every shipped shader through glslang in its kept process and through glslangValidator: the same words.
#include <gtest/gtest.h>

#include "ShaderCompilation.h"
#include "ShaderFrontEnd.h"
#include "ShaderSource.h"
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

} // namespace

TEST(FrontEndBits, AreThoseOfGlslangValidatorForEveryShippedShader)
{
	const FTemporaryFolder Folder;
	const std::string Validator = Folder.Path + "/glslangValidator";
	std::ofstream(Validator) << Script;
	std::filesystem::permissions(Validator, std::filesystem::perms::owner_all);
	int NumShaders = 0;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			for (const int32 Id : ChoosePermutations(Type))
			{
				FShaderCompileRequest Request =
					MakeShaderCompileRequest(FShaderRef(Type.FindOrCreateShader(Id)), Type.GetRootParametersMetadata());
				if (!Request.VirtualPath.starts_with("/Engine/"))
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
					EXPECT_EQ(Expected, Kept) << Type.GetName() << ", permutation " << Id << ", " << bKeepFunctions;
				}
				++NumShaders;
			}
		});
	EXPECT_GT(NumShaders, 40); // there are that many classes in passes/
}
