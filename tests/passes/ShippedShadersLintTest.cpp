// The portability lint finds nothing in the shaders that drydock ships, but what they allow themselves.
#include <gtest/gtest.h>

#include "Shader.h"
#include "ShaderCompilation.h"
#include "ShaderDirectories.h"
#include "ShaderLint.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace
{

using namespace Drydock;
namespace fs = std::filesystem;

constexpr size_t MostPermutations = 24; // of a class: the tonemapper has thousands

/** All; of more than the most, evenly drawn ones with the first and the last. */
std::vector<int32> ListPermutations(const FShaderType& Type)
{
	std::vector<int32> Ids;
	for (int32 Id = 0; Id < Type.GetPermutationCount(); ++Id)
	{
		if (Type.ShouldCompilePermutation(Id))
		{
			Ids.push_back(Id);
		}
	}
	if (Ids.size() <= MostPermutations)
	{
		return Ids;
	}
	std::vector<int32> Drawn;
	for (size_t i = 0; i < MostPermutations; ++i)
	{
		Drawn.push_back(Ids[i * (Ids.size() - 1) / (MostPermutations - 1)]);
	}
	return Drawn;
}

std::set<fs::path> ListShippedFiles()
{
	std::set<fs::path> Files;
	for (const char* const Folder : {"/passes/Shaders", "/rdg/graph/Shaders"})
	{
		for (const fs::directory_entry& Entry :
			fs::recursive_directory_iterator(DRYDOCK_TEST_SOURCE_DIR + std::string(Folder)))
		{
			if (Entry.path().extension() == ".usf")
			{
				Files.insert(fs::canonical(Entry.path()));
			}
		}
	}
	return Files;
}

void ExpectClean(const FShaderCompileRequest& Request, const std::string& Name)
{
	std::vector<FDiagnostic> Refused;
	for (const FLintFinding& Finding : LintShader(Request, 0xFF, &Refused))
	{
		ADD_FAILURE() << Name << ": " << Finding.File << ":" << Finding.Line << ": " << Finding.What << " ["
					  << Finding.Rule->Id << "]";
	}
	EXPECT_TRUE(Refused.empty()) << Name << ": " << Refused[0].Message;
}

} // namespace

TEST(ShippedShaders, AreCleanOfWhatTheLintFinds)
{
	MakeShaderCompileRequest("", "", EShaderStage::Compute); // maps their folders
	const std::set<fs::path> Shipped = ListShippedFiles();
	std::set<fs::path> Looked;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			std::error_code Error;
			const fs::path File = fs::canonical(FindShaderFile(Type.GetShaderFilename()), Error);
			if (!Shipped.count(File))
			{
				return;
			}
			Looked.insert(File);
			for (const int32 Id : ListPermutations(Type))
			{
				const FShaderRef Shader(Type.FindOrCreateShader(Id));
				ExpectClean(MakeShaderCompileRequest(Shader, Shader.GetRootParametersMetadata()),
					std::string(Type.GetName()) + ", permutation " + std::to_string(Id));
			}
		});
	for (const fs::path& File : Shipped)
	{
		if (!Looked.count(File)) // plugins name it, or include it
		{
			const std::string Path = "/Engine/Private/" + File.filename().string();
			const std::vector<FShaderEntry> Entries =
				FindShaderEntries(MakeShaderCompileRequest(Path, "", EShaderStage::Compute));
			EXPECT_FALSE(Entries.empty()) << Path;
			for (const FShaderEntry& Entry : Entries)
			{
				ExpectClean(MakeShaderCompileRequest(Path, Entry.Name, Entry.Stage), Path);
			}
		}
	}
}
