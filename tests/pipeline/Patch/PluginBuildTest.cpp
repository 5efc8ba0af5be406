// `drydock build`: what is found in a plugin's folder, what is left out, and what a mistake is answered with. One
// plugin is built for real; whether plugins run is for PluginStylesTest. A little past 500 lines: the cases share one
// plugin's folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "DiagnosticList.h"
#include "Diagnostics.h"
#include "Patch/PatchErrors.h"
#include "Patch/PluginBuild.h"
#include "Patch/PluginBuildErrors.h"
#include "Text/OutputErrors.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

/** A plugin in a folder that goes away. */
class PluginBuild : public testing::Test
{
protected:
	PluginBuild()
		: Root(Files::temp_directory_path() / ("drydock_plugin_build_" + std::to_string(getpid())))
	{
		Files::remove_all(Root);
		Write("Plugins/Tint/Tint.uplugin", R"({ // comments and commas too many do no harm
			"EngineVersion": "5.3.0",
			"Modules": [
				{ "Name": "Tint", "Type": "Runtime", "LoadingPhase": "PostConfigInit" },
				{ "Name": "TintTools", "Type": "Editor", },
			] })");
		Write("Plugins/Tint/Source/Tint/Tint.Build.cs", R"(public class Tint : ModuleRules {
			public Tint() { PrivateDefinitions.Add("TINT_ANSWER=42"); PublicIncludePaths.Add("Deep/Inside"); } })");
		Write("Plugins/Tint/Source/Tint/Deep/Inside/Deep.h", "inline int Deep() { return TINT_ANSWER; }\n");
	}
	~PluginBuild() override { Files::remove_all(Root); }

	void Write(const std::string& Path, const std::string& Text) const
	{
		Files::create_directories((Root / Path).parent_path());
		std::ofstream(Root / Path) << Text;
	}
	FPluginBuild Describe() const
	{
		FPluginBuild Build;
		Build.Folder = (Root / "Plugins/Tint").string();
		Build.BuildFolder = (Root / "build").string();
		return Build;
	}
	/** Number and text of the message that ends it. */
	static std::pair<int, std::string> Refuse(const FPluginBuild& Build)
	{
		try
		{
			BuildPlugin(Build);
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitUsage, Error.GetExitCode());
			return {Error.GetDiagnostics().front().Code, Error.GetDiagnostics().front().Message};
		}
		return {};
	}

	Files::path Root;
};

TEST_F(PluginBuild, IsFoundBuiltAndLoaded)
{
	Write("Plugins/Tint/Source/TintTools/TintTools.Build.cs", "");
	Write("Plugins/Tint/Source/TintTools/Private/Tools.cpp", "#error an editor's module\n");
	Write("Plugins/Tint/Source/Tint/Private/TintPanel.cpp", "#include \"Widgets/SPanel.h\"\n");
	Write("Plugins/Tint/Source/Tint/Private/TintSheet.h", "#include \"Widgets/STable.h\"\n");
	Write("Plugins/Tint/Source/Tint/Private/TintSheet.cpp", "#include \"TintSheet.h\"\n");
	Write("Plugins/Tint/Source/Tint/Private/Old.cpp", "#error left out by its name\n");
	Write("Plugins/Tint/Source/Tint/Public/TintActor.h", R"(#pragma once
#include "TintActor.generated.h"
// Declared by the generated header: AActor and UWorldSubsystem come without an include.
UCLASS()
class UTintSubsystem : public UWorldSubsystem
{
	GENERATED_BODY()
	TWeakObjectPtr<ATintActor> Actor;
};
UCLASS()
class ATintActor : public AActor
{
	GENERATED_BODY()
};
)");
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", R"(#include "tintactor.h"
#include "Deep.h"
#include "PostProcess\PostProcessMaterial.h"
#include "CompGeom/Delaunay2.h"
#if WITH_EDITOR
#include "Editor.h"
#endif
extern "C" int TintAnswer() { return Deep(); }
extern "C" const char* TintFolder() { static const FString Folder = FPaths::ProjectPluginsDir(); return *Folder; }
IMPLEMENT_MODULE(FDefaultModuleImpl, Tint)
)");
	FPluginBuild Build = Describe();
	Build.Excludes = {"Source/Tint/Private/Old.*"};
	const FBuiltPlugin Built = BuildPlugin(Build);

	EXPECT_EQ("Tint", Built.Name);
	EXPECT_EQ(3, Built.EngineMinor);
	EXPECT_THAT(Built.Notes, testing::Contains("left out module TintTools: it is of type Editor"));
	EXPECT_THAT(
		Built.Notes, testing::Contains("left out Source/Tint/Private/TintPanel.cpp: it includes Widgets/SPanel.h, "
									   "and there is no editor and no Slate"));
	EXPECT_THAT(Built.Notes,
		testing::Contains("left out Source/Tint/Private/TintSheet.cpp: it includes TintSheet.h, which includes "
						  "Widgets/STable.h, and there is no editor and no Slate"));
	EXPECT_THAT(
		Built.Notes, testing::Contains("left out Source/Tint/Private/Old.cpp: EXCLUDE Source/Tint/Private/Old.*"));
	EXPECT_THAT(Built.Notes,
		testing::Contains(testing::StartsWith("there is no CompGeom/Delaunay2.h here, it is taken as empty")));
	void* const Library = dlopen(Built.Library.c_str(), RTLD_NOW | RTLD_LOCAL);
	ASSERT_NE(nullptr, Library) << dlerror();
	EXPECT_EQ(42, reinterpret_cast<int (*)()>(dlsym(Library, "TintAnswer"))());
	EXPECT_EQ((Root / "Plugins").string() + "/", reinterpret_cast<const char* (*)()>(dlsym(Library, "TintFolder"))());
	dlclose(Library);
	EXPECT_FALSE(Files::exists(Root / "Plugins/Tint/build"));

	// Only headers that were made once and are not made now go.
	const Files::path Absent = Root / "build/cmake/Tint.generated/absent";
	EXPECT_TRUE(Files::exists(Absent / "CompGeom/Delaunay2.h"));
	std::ofstream(Absent / "mine.h") << "mine";
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "#include \"tintactor.h\"\n");
	BuildPlugin(Build);
	EXPECT_FALSE(Files::exists(Absent / "CompGeom/Delaunay2.h"));
	EXPECT_TRUE(Files::exists(Absent / "mine.h"));
}

// Its generated header comes with it, and its variables are its own: both plugins see the same one.
TEST_F(PluginBuild, AHeaderOfANeededPluginIsFoundWithItsClasses)
{
	Write("Plugins/Tint/Source/Tint/Public/TintSettings.h", R"(#pragma once
#include "TintSettings.generated.h"
UCLASS()
class TINT_API UTintSettings : public UObject
{
	GENERATED_BODY()
public:
	int32 Answer = 42;
};
extern TINT_API int32 GTintHost;
)");
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp",
		"#include \"TintSettings.h\"\nint32 GTintHost = 3;\nextern \"C\" int TintHost() { return GTintHost; }\n");
	Write("Plugins/User/User.uplugin", R"({"Plugins": [{"Name": "Tint", "Enabled": true}]})");
	Write("Plugins/User/Source/User/User.Build.cs", "");
	Write("Plugins/User/Source/User/Private/User.cpp", R"(#include "TintSettings.h"
extern "C" int UserAnswer() { GTintHost += 4; return GetDefault<UTintSettings>()->Answer; }
)");
	FPluginBuild Build = Describe();
	Build.Folder = (Root / "Plugins/User").string();
	const FBuiltPlugin Built = BuildPlugin(Build);
	void* const Library = dlopen(Built.Library.c_str(), RTLD_NOW | RTLD_LOCAL);
	ASSERT_NE(nullptr, Library) << dlerror();
	EXPECT_EQ(42, reinterpret_cast<int (*)()>(dlsym(Library, "UserAnswer"))());
	EXPECT_EQ(7, reinterpret_cast<int (*)()>(dlsym(Library, "TintHost"))());
	dlclose(Library);
}

TEST_F(PluginBuild, MistakesAreNumbered)
{
	FPluginBuild Build = Describe();
	Build.Folder = (Root / "Nowhere").string();
	EXPECT_EQ(ErrorNoPlugin, Refuse(Build).first);

	Build = Describe();
	Build.Folder = (Root / "Plugins").string();
	Files::remove_all(Root / "Plugins/Tint");
	const auto [Number, Message] = Refuse(Build);
	EXPECT_EQ(ErrorNoPlugin, Number);
	EXPECT_THAT(Message, testing::HasSubstr("no sources found"));
}

TEST_F(PluginBuild, WhatIsKnownToBeOtherwiseHasItsWayRound)
{
	const std::string Source = "Plugins/Tint/Source/Tint/Private/Tint.cpp";
	Write(Source, "struct FGlow : TRenderingCompositePassBase<1, 1>\n{\n};\n");
	const auto [Number, Message] = Refuse(Describe());
	EXPECT_EQ(ErrorPluginNotCompiled, Number);
	EXPECT_THAT(
		Message, testing::HasSubstr("TRenderingCompositePassBase belongs to UE4's composition graph, which Unreal 5 "
									"does not have: write a function that adds the pass with an FRDGBuilder"));
	Write(Source, "#include \"RenderGraphUtils.h\"\nFRHITexture* F(FRDGTexture* Texture) { return Texture; }\n");
	EXPECT_THAT(Refuse(Describe()).second,
		testing::HasSubstr("a texture of the graph is a parameter by SHADER_PARAMETER_RDG_TEXTURE"));
	Write(Source, "void F() { Nothing(); }\n");
	EXPECT_THAT(Refuse(Describe()).second, testing::Not(testing::AnyOf(testing::HasSubstr("drydock does not have"),
											   testing::HasSubstr("composition graph"))));
}

// Held to a version, a plugin is refused what that engine does not have.
TEST_F(PluginBuild, NamesOfOtherVersionsAreRefusedWhereAVersionIsNamed)
{
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", R"(#include "Misc/CoreDelegates.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "SceneViewExtension.h"
struct FTint : FSceneViewExtensionBase
{
	FTint(const FAutoRegister& Register) : FSceneViewExtensionBase(Register) {}
	virtual ESceneViewExtensionFlags GetFlags() const override { return ESceneViewExtensionFlags::None; }
};
void Tint()
{
	FSceneViewExtensions::NewExtension<FTint>();
	FCoreDelegates::OnPostEngineInit.Clear();
}
)");
	FPluginBuild Build = Describe();
	Build.EngineMinor = 4;
	Build.EngineNames = 2;
	EXPECT_THAT(Refuse(Build).second,
		testing::HasSubstr("engine 5.4 does not have ISceneViewExtension::GetFlags, which is there from 5.7 on"));
	Build.EngineMinor = 3;
	EXPECT_THAT(Refuse(Build).second, testing::Not(testing::HasSubstr("CopyFromSlice"))); // of drydock's own header
	Build.EngineNames = 0;
	EXPECT_THAT(BuildPlugin(Build).Notes, testing::Each(testing::Not(testing::HasSubstr("engine 5."))));
	Build.EngineMinor = 8;
	Build.EngineNames = 2;
	EXPECT_THAT(BuildPlugin(Build).Notes,
		testing::Contains(testing::HasSubstr("Tint.cpp:12: engine 5.8 deprecates FCoreDelegates::OnPostEngineInit: use "
											 "FCoreDelegates::GetOnPostEngineInit()")));
}

// Of two sources that do not compile, a module of the editor, and an engine's header that is not here.
TEST_F(PluginBuild, AllThatIsMissingIsToldAtOnce)
{
	Write("Plugins/Tint/Source/TintTools/TintTools.Build.cs", "");
	Write("Plugins/Tint/Source/Tint/Private/A.cpp",
		"#include \"CompGeom/Delaunay2.h\"\n#include \"SceneView.h\"\n"
		"int A(const FSceneView& View) { return View.NoSuchMember; }\nvoid C() { FDelaunay2 D; }\n");
	Write("Plugins/Tint/Source/Tint/Private/B.cpp",
		"#include \"SceneView.h\"\nint B(const FSceneView& View) { return View.NoSuchMember; }\n"
		"FLinearColour F();\nvoid D() { FDelaunay2 D; }\n");
	for (const char* const Compiler : {"g++", "clang++"})
	{
		if (std::system(("which " + std::string(Compiler) + " >/dev/null").c_str()) != 0)
		{
			continue;
		}
		SCOPED_TRACE(Compiler);
		Files::remove_all(Root / "build");
		FPluginBuild Build = Describe();
		Build.Compiler = Compiler;
		const auto [Number, Message] = Refuse(Build);
		EXPECT_EQ(ErrorPluginNotCompiled, Number);
		const auto Row =
			[](const char* Name, const char* Kind, const char* Uses, const char* Place, const char* Instead)
		{
			return testing::ContainsRegex(std::string("\n  ") + Name + " +" + Kind + " +" + Uses +
										  " +Source/Tint/Private/" + Place + Instead + "\n");
		};
		EXPECT_THAT(Message, testing::HasSubstr("does not compile: 3 names are missing here\n"));
		EXPECT_THAT(Message, Row("FSceneView::NoSuchMember", "member", "2", "A.cpp:3", ""));
		EXPECT_THAT(Message, Row("FDelaunay2", "(name|type)", "2", "A.cpp:4",
								 " +neither drydock nor the plugin has CompGeom/Delaunay2.h"));
		EXPECT_THAT(Message, Row("FLinearColour", "type", "1", "B.cpp:3", " +did you mean FLinearColor[?]"));
		EXPECT_THAT(Message, testing::HasSubstr("\n  left out module TintTools: it is of type Editor\n"));
	}
}

// An actor of a class that is not here, an .inl that is not here, many names, an engine too old.
TEST_F(PluginBuild, AMissingBaseClassIsTheFirstRowOfAWholeTable)
{
	Write("Plugins/Tint/Tint.uplugin",
		R"({"EngineVersion": "4.26.0", "Modules": [{"Name": "Tint", "Type": "Runtime"}]})");
	Write("Plugins/Tint/Source/Tint/Public/TintThing.h", R"(#pragma once
#include "TintThing.generated.h"
UCLASS()
class ATintThing : public ANoSuchActor
{
	GENERATED_BODY()
	ATintThing();
	void BeginPlay() override;
};
)");
	Write("Plugins/Tint/Source/Tint/Private/A.cpp", R"(#include "TintThing.h"
#include "NoSuchActor.inl"
ATintThing::ATintThing()
{
	PrimaryActorTick.bCanEverTick = true;
}
void ATintThing::BeginPlay()
{
	Super::BeginPlay();
	GetWorld();
}
)");
	std::string Many;
	for (int Index = 0; Index < 60; ++Index)
	{
		Many +=
			"int F" + std::to_string(Index) + "() { return FNoSuchNameOfThePlugin" + std::to_string(Index) + "(); }\n";
	}
	Write("Plugins/Tint/Source/Tint/Private/B.cpp", Many);
	for (const char* const Compiler : {"g++", "clang++"})
	{
		if (std::system(("which " + std::string(Compiler) + " >/dev/null").c_str()) != 0)
		{
			continue;
		}
		SCOPED_TRACE(Compiler);
		Files::remove_all(Root / "build");
		FPluginBuild Build = Describe();
		Build.Compiler = Compiler;
		const std::string Message = SummarizeDiagnostics({{.Message = Refuse(Build).second}}).front().Message;
		EXPECT_THAT(Message,
			testing::StartsWith("it is for engine 4.26, and drydock knows 5.1 to 5.8; does not compile: 61 names are "
								"missing here\n"));
		EXPECT_THAT(
			Message, testing::ContainsRegex(
						 "first place *\n  ANoSuchActor +base class +[12]  Source/Tint/Public/TintThing.h:[45]  "
						 "neither drydock nor the plugin has NoSuchActor.inl\n"));
		EXPECT_THAT(Message, testing::HasSubstr("\n  FNoSuchNameOfThePlugin59 "));
		EXPECT_THAT(
			Message, testing::ContainsRegex("more errors, which may follow from the missing base classes: .*GetWorld"));
		EXPECT_THAT(Message, testing::HasSubstr("full log: "));
	}
}

TEST_F(PluginBuild, ADeveloperModuleIsBuiltWhereItIsTheOnlyOne)
{
	Write("Plugins/Tint/Tint.uplugin",
		R"({"Modules": [{"Name": "Tint", "Type": "Developer"}, {"Name": "TintTools", "Type": "Editor"}]})");
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "extern \"C\" int TintAnswer() { return TINT_ANSWER; }\n");
	Write("Plugins/Tint/Source/TintTools/TintTools.Build.cs", "");
	EXPECT_THAT(BuildPlugin(Describe()).Notes, testing::ElementsAre("left out module TintTools: it is of type Editor"));

	Write("Plugins/Tint/Source/Game/Game.Build.cs", "");
	Write("Plugins/Tint/Source/Game/Private/Game.cpp", "\n");
	EXPECT_THAT(BuildPlugin(Describe()).Notes,
		testing::Contains("left out module Game: neither the .uplugin nor another module names it"));

	Write("Plugins/Tint/Source/Tint/Tint.Build.cs", R"(PublicDependencyModuleNames.AddRange(new string[] { "Core",
		"Game" }); PrivateDefinitions.Add("TINT_ANSWER=42");)");
	EXPECT_THAT(BuildPlugin(Describe()).Notes,
		testing::Contains("left out module Tint: it is of type Developer, and the plugin has others"));

	Write("Plugins/Tint/Tint.uplugin",
		R"({"Modules": [{"Name": "Tint", "Type": "Editor"}, {"Name": "Game", "Type": "Program"}]})");
	const auto [Number, Message] = Refuse(Describe());
	EXPECT_EQ(ErrorNoPlugin, Number);
	EXPECT_THAT(
		Message, testing::HasSubstr("left out module Game: it is of type Program; left out module Tint: it is of "
									"type Editor"));
}

TEST_F(PluginBuild, TheCaseOfFoldersDoesNotMatter)
{
	Write("Plugins/Tint/Source/Tint/Public/Deep/Colour.h", "#pragma once\ninline int GetColour() { return 7; }\n");
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", R"(#include "SubSystems/EngineSubsystem.h"
#include "sceneviewextension.h"
#include "deep/colour.h"
#include "Deep\COLOUR.h"
#include "../../../../../../../Source/Runtime/Renderer/Public/ScreenPass.h"
#include <string.h>
class UProbe : public UEngineSubsystem {};
extern "C" int TintAnswer() { return GetColour() + int(strlen("x")) + int(sizeof(FSceneViewExtensionBase) > 0) - int(sizeof(FScreenPassTexture) == 0); }
)");
	const FBuiltPlugin Built = BuildPlugin(Describe());
	EXPECT_THAT(Built.Notes, testing::Not(testing::Contains(testing::HasSubstr("there is no"))));
	void* const Library = dlopen(Built.Library.c_str(), RTLD_NOW | RTLD_LOCAL);
	ASSERT_NE(nullptr, Library) << dlerror();
	EXPECT_EQ(9, reinterpret_cast<int (*)()>(dlsym(Library, "TintAnswer"))());
	dlclose(Library);
}

TEST_F(PluginBuild, AProjectOfSomebodyElsesIsNotReplaced)
{
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "\n");
	Write("build/CMakeLists.txt", "project(Mine)\n");
	const auto [Number, Message] = Refuse(Describe());
	EXPECT_EQ(ErrorForeignContent, Number);
	EXPECT_EQ("drydock did not write this, and outputs would take its place: move it away, or name another folder with "
			  "--out",
		Message);
	std::ifstream Project(Root / "build/CMakeLists.txt");
	EXPECT_EQ("project(Mine)\n", std::string(std::istreambuf_iterator<char>(Project), {}));
	EXPECT_FALSE(Files::exists(Root / "build/cmake"));
}

TEST_F(PluginBuild, FilesOfOthersInTheBuildFolderStay)
{
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "\n");
	for (const char* const Name : {"build.log", "cmake/notes.txt"})
	{
		Write(std::string("build/") + Name, "mine\n");
		EXPECT_EQ(ErrorForeignContent, Refuse(Describe()).first) << Name;
		std::ifstream File(Root / "build" / Name);
		EXPECT_EQ("mine\n", std::string(std::istreambuf_iterator<char>(File), {}));
		EXPECT_FALSE(Files::exists(Root / "build/CMakeLists.txt"));
		Files::remove_all(Root / "build");
	}
}

TEST_F(PluginBuild, WhatIsNoFileIsNotRead)
{
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "\n");
	const std::vector<std::string> Names = {
		"Tint.uplugin", "Source/Tint/Tint.Build.cs", "Source/Tint/Private/Tint.cpp"};
	for (const std::string& Name : Names)
	{
		const Files::path File = Root / "Plugins/Tint" / Name;
		Files::rename(File, Root / "kept");
		const auto ExpectRefused = [&]
		{
			const auto [Number, Message] = Refuse(Describe());
			EXPECT_EQ(ErrorPluginNotConfigured, Number);
			EXPECT_THAT(Message, testing::HasSubstr("only files of at most 16 MB are read: " + File.string()));
			Files::remove(File);
		};
		ASSERT_EQ(0, mkfifo(File.c_str(), 0600));
		ExpectRefused();
		Files::create_symlink("/dev/zero", File);
		ExpectRefused();
		std::ofstream(File) << "x";
		Files::resize_file(File, (16 << 20) + 1);
		ExpectRefused();
		Files::rename(Root / "kept", File);
	}
}

TEST_F(PluginBuild, WhatCMakeTakesForItsOwnIsRefusedByName)
{
	for (const char* const Part : {"\\", ";", "\"", "[[", "]", "*", "?", "|", "\n", "${HOME}", "$<1:x>"})
	{
		const std::string Odd = std::string("a") + Part + "b";
		FPluginBuild Build = Describe();
		Build.Folder = (Root / Odd / "Tint").string();
		Files::create_directories(Build.Folder);
		const auto [Number, Message] = Refuse(Build);
		EXPECT_EQ(ErrorNoPlugin, Number) << Odd;
		EXPECT_THAT(Message, testing::HasSubstr("which CMake takes for its own"));

		Build = Describe();
		Build.BuildFolder = (Root / Odd).string();
		EXPECT_EQ(ErrorNoPlugin, Refuse(Build).first) << Odd;

		Write("Plugins/Tint/Source/Tint/Private/" + Odd + ".cpp", "\n");
		EXPECT_EQ(ErrorNoPlugin, Refuse(Describe()).first) << Odd;
		Files::remove(Root / "Plugins/Tint/Source/Tint/Private" / (Odd + ".cpp"));
	}
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "\n");
	Write("Plugins/Tint/Source/Tint/Tint.Build.cs", R"(PublicDefinitions.Add("A=$<1:x>");)");
	const auto [Number, Message] = Refuse(Describe());
	EXPECT_EQ(ErrorNoPlugin, Number);
	EXPECT_THAT(Message, testing::HasSubstr("A=$<1:x>"));
}

TEST_F(PluginBuild, ANameIsOneBeforeCMakeReadsIt)
{
	for (const char* const Name : {"x) message(FATAL_ERROR here", "****x", "", "class", "a b"})
	{
		FPluginBuild Build = Describe();
		Build.Name = Name;
		const auto [Number, Message] = Refuse(Build);
		EXPECT_EQ(*Name == '\0' ? +ErrorNoPlugin : +ErrorPatchName, Number) << Name << Message; // else the .uplugin's
	}
	EXPECT_TRUE(Files::exists(Root / "build/build.log"));
}

TEST_F(PluginBuild, AnExcludeThatMatchesNothingIsAMistake)
{
	Write("Plugins/Tint/Source/Tint/Private/Tint.cpp", "\n");
	FPluginBuild Build = Describe();
	Build.Excludes = {"Nobody.cpp"};
	const auto [Number, Message] = Refuse(Build);
	EXPECT_EQ(ErrorPluginNotConfigured, Number);
	EXPECT_THAT(Message, testing::HasSubstr("EXCLUDE Nobody.cpp matches nothing"));
}

TEST_F(PluginBuild, EngineIsThatOfTheDescription)
{
	EXPECT_EQ(3, FindEngineMinor((Root / "Plugins/Tint").string()));
	Write("Plugins/Tint/Tint.uplugin", "{}");
	EXPECT_EQ(0, FindEngineMinor((Root / "Plugins/Tint").string()));
	Write("Game.uproject", R"({ "EngineAssociation": "5.6" })");
	EXPECT_EQ(6, FindEngineMinor((Root / "Plugins/Tint").string()));
	const std::string Blanks(1000000, ' ');
	Write("Game.uproject", "{ \"EngineVersion\" : 5, \"EngineAssociation\"" + Blanks + ":" + Blanks + "\"5.27.1\" }");
	EXPECT_EQ(27, FindEngineMinor((Root / "Plugins/Tint").string()));
	Write("Game.uproject", "{ \"EngineVersion\": \"5.");
	EXPECT_EQ(0, FindEngineMinor((Root / "Plugins/Tint").string()));
}

} // namespace
