// Shipped shaders are as portable as drydock asks of others': the lint finds nothing but what is listed here, with why.
#include <gtest/gtest.h>

#include "GlobalShader.h"
#include "ShaderCompilation.h"
#include "ShaderLint.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace
{

using namespace Drydock;

/** "file: rule" of what is meant so. */
const std::map<std::string, std::string>& GetMeantSo()
{
	static const std::map<std::string, std::string> MeantSo = {
		{"/Project/DualKawaseBlur.usf: threads-512", "its article has groups of 32 x 32 threads"},
	};
	return MeantSo;
}

TEST(ShippedShadersLint, FindsNothingThatIsNotMeantSo)
{
	constexpr int32 MostPermutations = 8; // of a class, from the first to the last
	std::set<std::string> Found;
	size_t NumLooked = 0;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			const std::string File = Type.GetShaderFilename();
			if (!File.starts_with("/Engine/") && !File.starts_with("/Project/"))
			{
				return;
			}
			const int32 Step = std::max(1, Type.GetPermutationCount() / MostPermutations);
			for (int32 Id = 0; Id < Type.GetPermutationCount(); Id += Step)
			{
				if (!Type.ShouldCompilePermutation(Id))
				{
					continue;
				}
				const FShaderRef Shader(Type.FindOrCreateShader(Id));
				++NumLooked;
				for (const FLintFinding& Finding :
					LintShader(MakeShaderCompileRequest(Shader, Shader.GetRootParametersMetadata()), 0xFF))
				{
					Found.insert(Finding.File + ": " + Finding.Rule->Id);
				}
			}
		});
	EXPECT_LT(50u, NumLooked);
	std::set<std::string> Expected;
	for (const auto& [What, Why] : GetMeantSo())
	{
		Expected.insert(What);
	}
	EXPECT_EQ(Expected, Found);
}

} // namespace
