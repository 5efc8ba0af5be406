// What the pages offer for the engine, pasted as it stands: files into a plugin, the lines of `drydock settings plan`
// into an overlay, the article's view extension into a plugin. Each is built, runs, and gives the picture that its page
// says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "OverlayTestUtils.h"
#include "PasteTestUtils.h"
#include "Patch/PluginBuild.h"
#include "PostProcessSettings.h"
#include "TextTools.h"

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <sstream>

using namespace OverlayTest;
using namespace PasteTest;
using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

const std::string Docs = DRYDOCK_TEST_SOURCE_DIR "/docs/";
const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";
const std::string Plugins = DRYDOCK_TEST_SOURCE_DIR "/tests/plugins/";

/** Headers of the engine, as its public plugins include them. */
const std::set<std::string> EngineHeaders = {"GlobalShader.h", "PixelShaderUtils.h",
	"PostProcess/PostProcessMaterialInputs.h", "RHIStaticStates.h", "RenderGraphUtils.h", "SceneTexturesConfig.h",
	"SceneView.h", "SceneViewExtension.h", "ScreenPass.h", "ShaderParameterStruct.h", "/Engine/Private/Common.ush",
	"/Engine/Private/ScreenPass.ush", "/Engine/Private/DeferredShadingCommon.ush"};

/** The files that a page offers: a line "`PATH`:", and behind it a block. */
std::map<std::string, std::string> FindFiles(const std::string& Page)
{
	std::map<std::string, std::string> Files;
	const std::string Text = ReadWholeFile(Docs + Page);
	const std::string Mark = "`:\n\n```";
	for (size_t At = Text.find(Mark); At != Text.npos; At = Text.find(Mark, At + 1))
	{
		const size_t Line = Text.rfind('\n', At) + 1;
		const size_t First = Text.find('\n', At + Mark.size()) + 1;
		if (Text[Line] == '`')
		{
			Files[Text.substr(Line + 1, At - Line - 1)] = Text.substr(First, Text.find("```", First) - First);
		}
	}
	return Files;
}

void ExpectNamesOfTheEngine(const std::map<std::string, std::string>& Files)
{
	for (const auto& [File, Text] : Files)
	{
		for (const char* const Own : {"Drydock", "DRYDOCK", "MapPixelToInputUV", "/Project/"})
		{
			EXPECT_THAT(Text, Not(HasSubstr(Own))) << File;
		}
		std::istringstream Lines(Text);
		const std::string Begin = "#include \"";
		for (std::string Line; std::getline(Lines, Line);)
		{
			const std::string Header =
				Line.starts_with(Begin) ? Line.substr(Begin.size(), Line.size() - Begin.size() - 1) : "";
			const bool bOwn = Files.contains("Source/MyPatch/Private/" + Header);
			EXPECT_TRUE(Header.empty() || bOwn || EngineHeaders.contains(Header)) << File << ": " << Header;
		}
	}
}

/** A module that runs the passes of the page that PAGE names. Extension: the line that a page offers. */
std::string MakeModule(const std::string& Extension)
{
	return R"(
#include "DualKawaseBlur.h"
#include "Interfaces/IPluginManager.h"
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "REDPostProcess.h"
#include "ShaderCore.h"
#include "ToonShadowBlur.h"
#include "UnityBloom.h"

#include <cstdlib>
#include <string>

class FPages : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FPages::AddPasses));
		}
	}
	FScreenPassTexture AddPasses(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		const std::string Page = std::getenv("PAGE");
		FPostProcessSettings Settings;
		Settings.UnityBloomIntensity = 0.5f;
		Settings.UnityBloomSpread = 1.2f;
		Settings.UnityBloomThreshold = 0.3f;
		Settings.DiffusionFilterIntensity = 0.5f;
		Settings.DiffusionFilterLuminancePow = 2.0f;
		Settings.DiffusionFilterLuminanceThreshold = 0.1f;
		Settings.DiffusionFilterPower = 1.1f;
		return Page == "unity" ? AddUnityBloomPasses(GraphBuilder, View, Settings, SceneColor)
			   : Page == "red" ? AddREDDiffusionFilter(GraphBuilder, View, Settings, SceneColor)
			   : Page == "shadow"
				   ? AddToonShadowBlur(GraphBuilder, View, Inputs.SceneTextures.SceneTextures, SceneColor, SceneColor,
						 4.0f, FLinearColor::White)
				   : SceneColor;
	}
};

class FPagesModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		const FString Folder = IPluginManager::Get().FindPlugin(TEXT("MyPatch"))->GetBaseDir();
		AddShaderSourceDirectoryMapping(TEXT("/Plugin/MyPatch"), FPaths::Combine(Folder, TEXT("Shaders")));
		Pages = FSceneViewExtensions::NewExtension<FPages>();
		if (std::string(std::getenv("PAGE")) == "kawase")
		{
)" + Extension +
		   R"(		}
	}

private:
	TSharedPtr<FPages, ESPMode::ThreadSafe> Pages;
	TSharedPtr<FDualKawaseBlur, ESPMode::ThreadSafe> ViewExtension;
};

IMPLEMENT_MODULE(FPagesModule, MyPatch)
)";
}

/** Whether the pictures of two runs differ by 1e-6 at most. */
bool IsSamePicture(const FProgramFolder& Folder, const std::string& One, const std::string& Other)
{
	for (const auto& [Run, Out] : {std::pair(One, "one"), std::pair(Other, "other")})
	{
		const FOutcome Outcome = Folder.Call("run " + Run + " --out " + Out);
		EXPECT_EQ(0, Outcome.ExitCode) << Run << "\n" << Outcome.Printed;
	}
	return Folder.Call("diff one/final.exr other/final.exr --max 1e-6").ExitCode == 0;
}

/** Puts the plan's lines where the plan says, into an overlay that `drydock overlay new` made. */
class FPlanPaste
{
public:
	FPlanPaste(const FProgramFolder& InFolder, const std::string& Form)
		: Folder(InFolder)
		, Plan(nlohmann::json::parse(Folder.Call("settings plan BloomToonIntensity --json --form " + Form).Printed))
	{
	}

	/** The lines of the place in a file whose words contain Where. */
	std::string At(const std::string& File, const std::string& Where) const
	{
		for (const nlohmann::json& Place : Plan)
		{
			if (Place["file"] == File && Place["where"].get<std::string>().find(Where) != std::string::npos)
			{
				return Place["text"].get<std::string>() + "\n";
			}
		}
		ADD_FAILURE() << "the plan has no place " << File << ": " << Where;
		return "";
	}

	void PasteBefore(const std::string& File, const std::string& Where, const std::string& Mark) const
	{
		Edit(Folder, "Toon/" + File, [&](std::string& Text) { Replace(Text, Mark, At(File, Where) + Mark); });
	}

	void PasteShader() const
	{
		const std::string Shader = "Engine/Shaders/Private/PostProcessBloom.usf";
		const std::string Call = "BloomSetupCommon(UV, ViewportUV, GetExposureScaleMiddleGreyLumValue());\n";
		Folder.Write("Toon/" + Shader, ReadWholeFile(DRYDOCK_TEST_SOURCE_DIR "/passes/Shaders/PostProcessBloom.usf"));
		PasteBefore(Shader, "among the includes", "#include \"/Engine/Private/EyeAdaptationCommon.ush\"\n");
		PasteBefore(Shader, "globals, and a function", "#if COMPUTESHADER\n");
		Edit(Folder, "Toon/" + Shader,
			[&](std::string& Text)
			{
				Replace(Text, "BloomOutput[PixelPos] = " + Call,
					"float4 OutColor = " + Call + At(Shader, "BloomSetupCS, ") + "BloomOutput[PixelPos] = OutColor;\n");
				Replace(Text, "\tOutColor = " + Call, "\tOutColor = " + Call + At(Shader, "BloomSetupPS, "));
			});
	}

	void PasteCpp() const
	{
		PasteBefore(Renderer + "PostProcessBloomSetup.h", "FBloomSetupInputs", "};\n");
		const std::string Pass = Renderer + "PostProcessBloomSetup.cpp";
		PasteBefore(Pass, "FBloomSetupParameters", "END_SHADER_PARAMETER_STRUCT()\n");
		PasteBefore(Pass, "GetBloomSetupParameters", "\treturn Parameters;\n");
		const std::string Chain = Renderer + "PostProcessing.cpp";
		PasteBefore(Chain, "SetupPassInputs are filled", "DownsampleInput = AddBloomSetupPass");
		Edit(Folder, "Toon/" + Chain,
			[&](std::string& Text)
			{
				Replace(Text, "if (bBloomSetupRequiredEnabled)",
					"if (bBloomSetupRequiredEnabled\n" + At(Chain, "in the condition") + ")");
			});
		const std::string Property = FindBlocks(ReadWholeFile(Docs + "overlays.md"), "cpp").at(0);
		Folder.Write("Toon/" + SceneHeader, "struct FPostProcessSettings\n{\n" + At(SceneHeader, "override bits") +
												At(SceneHeader, "among the values") + Property + "};\n");
		Folder.Write("Toon/" + SceneSource, "FPostProcessSettings::FPostProcessSettings()\n{\n" +
												At(SceneSource, "FPostProcessSettings::FPostProcessSettings()") +
												"}\n");
		Folder.Write("Toon/" + SceneView, At(SceneView, "FSceneView::OverridePostProcessSettings"));
	}

private:
	const FProgramFolder& Folder;
	const nlohmann::json Plan;
};

} // namespace

TEST(PagePaste, FilesOfThePagesDrawWhatDrydockDraws)
{
	const FProgramFolder Folder("page_paste");
	std::map<std::string, std::string> Offered;
	for (const char* const Page : {"dual-kawase", "unity-bloom", "red-post-process", "toon-shadow-blur"})
	{
		const std::map<std::string, std::string> Found = FindFiles(std::string("articles/") + Page + ".md");
		EXPECT_EQ(3u, Found.size()) << Page;
		Offered.insert(Found.begin(), Found.end());
	}
	ExpectNamesOfTheEngine(Offered);
	ASSERT_EQ(0, Folder.Call("new MyPatch").ExitCode);
	std::filesystem::remove(Folder.Path / "MyPatch/Source/MyPatch/Private/MyPatchViewExtension.cpp");
	for (const auto& [File, Text] : Offered)
	{
		Folder.Write("MyPatch/" + File, Text);
	}
	Folder.Write("MyPatch/Source/MyPatch/Private/MyPatchModule.cpp",
		MakeModule(FindBlock(FindBlocks(ReadWholeFile(Docs + "articles/dual-kawase.md"), "cpp"), {"NewExtension"})));
	Drydock::FPluginBuild Build;
	Build.Folder = (Folder.Path / "MyPatch").string();
	Build.BuildFolder = (Folder.Path / "build").string();
	Build.bUnity = true;
	const std::string Library = Drydock::BuildPlugin(Build).Library;

	const std::string Frame = R"({"scene": {"file": ")" + Configs +
							  R"(scenes/toon_character_641x359.exr"}, "camera": {"Settings": {"BloomIntensity": 0}})";
	Folder.Write("frame.json", Frame + "}");
	Folder.Write("pasted.json", Frame + R"(, "plugins": [")" + Library + "\"]}");
	Folder.Write("kawase.json", Frame + R"(, "extensions": [{"type": "DualKawaseBlur", "pass": "MotionBlur"}]})");
	const std::map<std::string, std::string> Own = {
		{"kawase", "kawase.json"},
		{"unity", "frame.json --pp UnityBloomIntensity=0.5 --pp UnityBloomSpread=1.2 --pp UnityBloomThreshold=0.3"},
		{"red", "frame.json --pp DiffusionFilterIntensity=0.5 --pp DiffusionFilterLuminancePow=2 "
				"--pp DiffusionFilterLuminanceThreshold=0.1 --pp DiffusionFilterPower=1.1"},
	};
	for (const auto& [Page, Run] : Own)
	{
		setenv("PAGE", Page.c_str(), 1);
		EXPECT_TRUE(IsSamePicture(Folder, "pasted.json", Run)) << Page;
		EXPECT_FALSE(IsSamePicture(Folder, "pasted.json", "frame.json")) << Page;
	}
	setenv("PAGE", "shadow", 1);
	EXPECT_FALSE(IsSamePicture(Folder, "pasted.json", "frame.json"));
	unsetenv("PAGE");
}

TEST(PagePaste, LinesOfThePlanGiveBothFormsOfToonBloom)
{
	const FProgramFolder Folder("plan_paste");
	ASSERT_EQ(0, Folder.Call("overlay new Toon --pass BloomSetup").ExitCode);
	const FPlanPaste Printed(Folder, "printed");
	Printed.PasteCpp();
	Printed.PasteShader();
	const std::string Run = Configs + "toon_bloom.json ";
	const std::string Pasted = Run + "--overlay Toon --pp DuskTint=1,0,0,1";
	EXPECT_TRUE(IsSamePicture(Folder, Pasted, Run + "--set r.ToonBloom.AsPrinted=1"));
	EXPECT_EQ(Folder.Read("one/final.exr"), Folder.Read("other/final.exr"));
	EXPECT_FALSE(IsSamePicture(Folder, Pasted, Run)) << "as printed, edges are jagged";

	// drydock's form stores the masked colour, so both store all bits here.
	FPlanPaste(Folder, "corrected").PasteShader();
	const std::string Wide = " --storage float32 ";
	EXPECT_TRUE(IsSamePicture(Folder, Pasted + Wide, Run + Wide));
	EXPECT_FALSE(IsSamePicture(Folder, Pasted + Wide, Run + Wide + "--set r.ToonBloom.AsPrinted=1"));
	const std::string Compute = Wide + "--set r.PostProcessing.PreferCompute=1";
	EXPECT_TRUE(IsSamePicture(Folder, Pasted + Compute, Run + Compute));

	// The default acts in the patch, and here where it is named.
	const std::string Default = Drydock::FormatShortest(FPostProcessSettings().BloomToonIntensity);
	EXPECT_THAT(ReadWholeFile(Docs + "toon-bloom.md"), HasSubstr("default of " + Default + ":"));
	const std::string Unnamed = Configs + "neutral.json --pp BloomIntensity=4" + Wide;
	const std::string Named = Unnamed + "--pp BloomToonIntensity=" + Default;
	EXPECT_TRUE(IsSamePicture(Folder, Unnamed + "--overlay Toon", Named + " --overlay Toon"));
	EXPECT_EQ(Folder.Read("one/final.exr"), Folder.Read("other/final.exr"));
	EXPECT_FALSE(IsSamePicture(Folder, Unnamed + "--overlay Toon", Unnamed));
	EXPECT_TRUE(IsSamePicture(Folder, Unnamed, Unnamed + "--set r.ToonBloom=0"));
	EXPECT_TRUE(IsSamePicture(Folder, Named, Unnamed + "--overlay Toon"));
}

TEST(PagePaste, TheArticlesViewExtensionIsAPlugin)
{
	const std::vector<std::string> Blocks = ReadArticle("003_", "c++");
	if (Blocks.empty())
	{
		GTEST_SKIP() << "DRYDOCK_ARTICLES names no folder with this article";
	}
	const FProgramFolder Folder("article_extension");
	std::filesystem::copy(
		Plugins + "ArticleBlur", Folder.Path / "ArticleBlur", std::filesystem::copy_options::recursive);
	const std::string Source = "ArticleBlur/Source/ArticleBlur/";
	const std::string Printed = FindBlock(Blocks, {"class FDualKawaseBlurDCS", "IMPLEMENT_GLOBAL_SHADER"});
	std::string Passes = Printed;
	const std::string Unended = "TempTexture = Outexture->Desc.Texture\n";
	Replace(Passes, Unended, Unended.substr(0, Unended.size() - 1) + ";\n");
	Folder.Write(Source + "Private/DualKawaseBlur.cpp", Passes);
	Folder.Write(
		Source + "Public/DualKawaseBlur.h", FindBlock(Blocks, {"class GAMES202_API FDualKawaseBlur", "InUseGaussian"}));
	const FOutcome Built = Folder.Call("build ArticleBlur --out built");
	ASSERT_EQ(0, Built.ExitCode) << Built.Printed;
	Folder.WriteFrame("pasted.json", R"(, "plugins": ["built/cmake/libArticleBlur.so"])");
	Folder.WriteFrame("own.json", R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libArticleBlur.so"])");
	EXPECT_TRUE(IsSamePicture(Folder, "pasted.json", "own.json"));
	EXPECT_EQ(Folder.Read("one/final.exr"), Folder.Read("other/final.exr"));

	int NumChanged = 0;
	std::istringstream Before(Printed);
	std::istringstream After(Passes);
	for (std::string Old, New; std::getline(Before, Old) && std::getline(After, New);)
	{
		NumChanged += Old != New;
	}
	const auto NumAdded =
		std::count(Passes.begin(), Passes.end(), '\n') - std::count(Printed.begin(), Printed.end(), '\n');
	const std::string Page = ReadWholeFile(Docs + "articles/dual-kawase.md");
	EXPECT_THAT(Page, HasSubstr(std::to_string(NumChanged) + " line is changed"));
	EXPECT_THAT(Page, HasSubstr("and " + std::to_string(NumAdded) + " lines are added"));
}

TEST(PagePaste, TheArticlesCompositionGraphIsRefused)
{
	const std::vector<std::string> Blocks = ReadArticle("002_", "cpp");
	if (Blocks.empty())
	{
		GTEST_SKIP() << "DRYDOCK_ARTICLES names no folder with this article";
	}
	const FProgramFolder Folder("article_graph");
	Folder.WriteFrame("frame.json", "");
	const std::string Header = FindBlock(Blocks, {"class FRCPassREDPostProcess "});
	const std::string Chain = FindBlock(Blocks, {"AddREDPostProcess(FPostprocessContext"});
	const std::string Advice = "belongs to UE4's composition graph, which Unreal 5 does not have: write a function";
	Folder.Write("RED/" + Renderer + "REDPostProcess.h", Header);
	Folder.Write("RED/" + Renderer + "PostProcessing.cpp", Chain);
	const FOutcome Overlay = Folder.Call("run frame.json --overlay RED");
	EXPECT_EQ(2, Overlay.ExitCode);
	EXPECT_THAT(Overlay.Printed, HasSubstr("TRenderingCompositePassBase " + Advice));
	EXPECT_THAT(Overlay.Printed, HasSubstr("FRenderingCompositePass " + Advice));
	Folder.Write("Plugin/Source/Plugin/Plugin.Build.cs", "");
	Folder.Write("Plugin/Plugin.uplugin", "{}");
	Folder.Write("Plugin/Source/Plugin/Private/REDPostProcess.cpp", "#include \"CoreMinimal.h\"\n" + Header + Chain);
	const FOutcome Plugin = Folder.Call("build Plugin");
	EXPECT_EQ(2, Plugin.ExitCode);
	EXPECT_THAT(Plugin.Printed, HasSubstr(Advice));
}
