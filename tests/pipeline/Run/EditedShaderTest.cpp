// One line of every shader that ships, edited in a copy of the shaders' folders, as in another checkout: the frame
// shows the edit, whether a hand-written kernel knows the shader or not. tests/outside/EditedShaders.py does the same
// to an installation.
#include <gtest/gtest.h>

#include "ContentHash.h"
#include "DispatchReuse.h"
#include "rdg/graph/Graph/GraphTestBuilder.h"
#include "Run/Run.h"
#include "SameBits.h"
#include "ScreenPass.h"
#include "ShaderCompilation.h"
#include "ShaderCore.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"
#include "Study/StudyRun.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

namespace
{

using namespace Drydock;
namespace fs = std::filesystem;

const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

/** A row of edited_shaders.tsv. */
struct FEdit
{
	std::string File;
	std::string Config; // "-": OfItsOwn shows the file
	std::string From;
	std::string To;
};

std::vector<FEdit> ReadEdits()
{
	std::vector<FEdit> Edits;
	std::ifstream Table(Root + "tests/outside/edited_shaders.tsv");
	for (std::string Line; std::getline(Table, Line);)
	{
		FEdit Edit;
		std::istringstream Row(Line);
		std::getline(Row, Edit.File, '\t') && std::getline(Row, Edit.Config, '\t') &&
			std::getline(Row, Edit.From, '\t') && std::getline(Row, Edit.To, '\t');
		if (Line[0] != '#')
		{
			Edits.push_back(Edit);
		}
	}
	return Edits;
}

/** For its scope drydock reads the shaders from copies of its folders. */
class FCopiedShaders
{
public:
	FCopiedShaders()
	{
		fs::remove_all(Folder);
		for (const char* const Shaders : {"passes/Shaders", "rdg/graph/Shaders"})
		{
			fs::create_directories(Folder / Shaders);
			fs::copy(Root + Shaders, Folder / Shaders, fs::copy_options::recursive);
		}
		AddShaderSourceDirectoryMapping(TEXT("/Engine"), FString((Folder / "rdg/graph/Shaders/Engine").string()));
		AddShaderSourceDirectoryMapping(TEXT("/Engine/Private"), FString((Folder / "passes/Shaders").string()));
		AddShaderSourceDirectoryMapping(TEXT("/Drydock"), FString((Folder / "rdg/graph/Shaders/Drydock").string()));
		AddShaderSourceDirectoryMapping(
			TEXT("/Drydock/Private"), FString((Folder / "passes/Shaders/Drydock").string()));
		AddShaderSourceDirectoryMapping(TEXT("/Project"), FString((Folder / "passes/Shaders").string()));
		ForgetShaders();
	}

	~FCopiedShaders()
	{
		ForgetShaderDirectories(NumDirectories);
		ForgetShaders();
		fs::remove_all(Folder);
	}

	/** The first place of From becomes To; false: there is none. */
	bool Replace(const std::string& File, const std::string& From, const std::string& To)
	{
		std::stringstream Text;
		Text << std::ifstream(Folder / File).rdbuf();
		std::string Edited = Text.str();
		const size_t At = Edited.find(From);
		if (At == std::string::npos)
		{
			return false;
		}
		std::ofstream(Folder / File) << Edited.replace(At, From.size(), To);
		ForgetShaders();
		return true;
	}

private:
	const size_t NumDirectories = AllShaderSourceDirectoryMappings().Num() > 0 ? CountShaderDirectories() : 0;
	const fs::path Folder = fs::path(testing::TempDir()) / ("drydock_edited_" + std::to_string(getpid()));
};

FRunResult RunShipped(const std::string& Config, const std::shared_ptr<FReuseCache>& Cache = nullptr)
{
	FRunOptions Options;
	Options.ReuseCache = Cache;
	Options.ConfigFile = Root + "configs/" + Config + ".json";
	return RunConfig(Options);
}

/** The error of the blur of four taps. */
std::string ShowFourTaps()
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/test_study.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, "study": {"axes": [
		{"name": "algorithm", "values": ["Kawase"]}, {"name": "sigma", "values": [2]}], "repetitions": 1,
		"region": [236, 196, 284, 236]}})";
	return std::to_string(RunStudy(Options).Variants.at(0).Error.Max);
}

/** A texel of a texture that was drawn into another. */
std::string ShowDrawnTexture()
{
	FGraphTest Graph;
	const FRDGTextureRef Texture = Graph.Texture("From");
	const FRDGTextureRef Drawn = Graph.Texture("X");
	Graph.Pass("Fill").Renders("From").Does([Texture](FRHICommandListImmediate&)
		{ Texture->GetRHI()->WriteTexel(0, 0, FLinearColor(1.0f, 0.0f, 0.0f, 0.0f)); });
	AddDrawTexturePass(*Graph.Builder, FScreenPassViewInfo(), FScreenPassTexture(Texture, FIntRect(0, 0, 2, 2)),
		FScreenPassRenderTarget(Drawn, FIntRect(0, 0, 4, 4), ERenderTargetLoadAction::EClear));
	Graph.Extract("X");
	Graph.Run();
	return std::to_string(Graph.Pooled.at("X")->GetRHI()->ReadTexel(0, 0).R);
}

/** A pixel of the scene's colour after temporal antialiasing. */
std::string ShowTemporalAA()
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/test_temporal_aa.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/moving_camera.0001.exr"}, "cvars": {"r.AntiAliasingMethod": 2}})";
	return std::to_string(RunConfig(Options).SceneLinear.Get(160, 90, 1));
}

/** No pass has it; plugins include it. */
std::string ShowCombineLUTs()
{
	const std::string File = "/Engine/Private/PostProcessCombineLUTs.usf";
	return HashBytes(FlattenShader(MakeShaderCompileRequest(File, "MainPS", EShaderStage::Pixel)).Text);
}

const std::map<std::string, std::function<std::string()>> OfItsOwn = {
	{"passes/Shaders/Drydock/FourTapBlur.usf", &ShowFourTaps},
	{"passes/Shaders/Drydock/TemporalAA.usf", &ShowTemporalAA},
	{"passes/Shaders/PostProcessCombineLUTs.usf", &ShowCombineLUTs},
	{"rdg/graph/Shaders/Engine/Private/ScreenPass.usf", &ShowDrawnTexture},
};

bool HasNote(const FRunResult& Result, const std::string& File)
{
	const std::string Name = fs::path(File).filename().string();
	return std::any_of(Result.Diagnostics.begin(), Result.Diagnostics.end(),
		[&](const FDiagnostic& Each) { return Each.Code == 6080 && fs::path(Each.File).filename() == Name; });
}

bool HasNativePass(const FRunResult& Result, const std::string& File)
{
	const std::string Name = "/" + fs::path(File).filename().string();
	std::set<std::string> Classes;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			if (std::string(Type.GetShaderFilename()).ends_with(Name))
			{
				Classes.insert(Type.GetName());
			}
		});
	return std::any_of(Result.Passes.begin(), Result.Passes.end(),
		[&](const FRunPass& Pass) {
			return EnumHasAnyFlags(Pass.Counters.Ran, EShaderRun::NativeKernel) &&
				   Classes.contains(Pass.Counters.Shader);
		});
}

} // namespace

TEST(EditedShader, TheTableHasEveryShaderThatShips)
{
	std::set<std::string> Edited;
	for (const FEdit& Edit : ReadEdits())
	{
		Edited.insert(Edit.File);
		EXPECT_EQ(Edit.Config == "-", OfItsOwn.contains(Edit.File)) << Edit.File;
	}
	for (const char* const Folder : {"passes/Shaders", "rdg/graph/Shaders"})
	{
		for (const auto& Entry : fs::recursive_directory_iterator(Root + Folder))
		{
			const std::string File = fs::relative(Entry.path(), Root).generic_string();
			EXPECT_TRUE(Entry.path().extension() != ".usf" || Edited.contains(File))
				<< File << " needs a row in tests/outside/edited_shaders.tsv";
		}
	}
}

TEST(EditedShader, IsSeenInTheFrame)
{
	FCopiedShaders Copy;
	std::map<std::string, FRunResult> Plain;
	const auto Cache = std::make_shared<FReuseCache>(); // of unedited and edited frames
	for (const FEdit& Edit : ReadEdits())
	{
		SCOPED_TRACE(Edit.File);
		if (Edit.Config == "-")
		{
			const std::string Before = OfItsOwn.at(Edit.File)();
			ASSERT_TRUE(Copy.Replace(Edit.File, Edit.From, Edit.To));
			EXPECT_NE(Before, OfItsOwn.at(Edit.File)());
		}
		else
		{
			if (!Plain.contains(Edit.Config))
			{
				Plain.emplace(Edit.Config, RunShipped(Edit.Config, Cache));
			}
			const FRunResult& Before = Plain.at(Edit.Config);
			ASSERT_TRUE(Copy.Replace(Edit.File, Edit.From, Edit.To));
			const FRunResult After = RunShipped(Edit.Config);
			EXPECT_FALSE(SameBits::AreSameBits(Before.Final, After.Final));
			EXPECT_TRUE(SameBits::AreSameBits(After.Final, RunShipped(Edit.Config, Cache).Final));
			EXPECT_FALSE(HasNote(Before, Edit.File));
			EXPECT_FALSE(HasNativePass(After, Edit.File));
			EXPECT_EQ(HasNativePass(Before, Edit.File), HasNote(After, Edit.File));
		}
		ASSERT_TRUE(Copy.Replace(Edit.File, Edit.To, Edit.From));
	}
}
