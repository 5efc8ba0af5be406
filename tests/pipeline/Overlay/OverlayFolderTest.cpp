// What is found in an overlay's folder, and what a mistake in it is answered with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Overlay/OverlayErrors.h"
#include "Overlay/OverlayFolder.h"
#include "OverlayTestUtils.h"
#include "pipeline/ProgramTestUtils.h"

using namespace Drydock;
using namespace OverlayTest;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace
{

const std::string Block = R"(
void AddPostProcessingPasses()
{
	if (Other) { Use(bBloomSetupRequiredEnabled); }
	// if (bBloomSetupRequiredEnabled) { AddBloomSetupPass(); }
	if (bBloomSetupRequiredEnabled)
	{
		Picture = AddBloomSetupPass(GraphBuilder, View, { "}" });
	}
	if (bBloomSetupRequiredEnabled) { SomethingElse(); }
}
)";

class OverlayFolder : public testing::Test
{
protected:
	FOverlayFolder Read() { return ReadOverlayFolder(Folder.Path.string(), Diagnostics); }

	/** Number and text of the first message, with its line. */
	std::tuple<int, int, std::string> GetFirst()
	{
		Read();
		return Diagnostics.empty() ? std::tuple(0, 0, std::string())
								   : std::tuple(Diagnostics[0].Code, Diagnostics[0].Line, Diagnostics[0].Message);
	}

	ProgramTest::FProgramFolder Folder{"overlay_folder"};
	std::vector<FDiagnostic> Diagnostics;
};

} // namespace

TEST_F(OverlayFolder, FilesAreKnownByTheirPlacesInTheEnginesTree)
{
	Folder.Write("Engine/Shaders/Private/PostProcessBloom.usf", "");
	Folder.Write("Engine/Shaders/Public/Mine.ush", "");
	Folder.Write(Renderer + "PostProcessTonemap.cpp", "#include \"X.h\"\nFScreenPassTexture AddTonemapPass(int) {}\n");
	Folder.Write(Renderer + "PostProcessTonemap.h", "");
	Folder.Write(Renderer + "PostProcessing.cpp", Block);
	Folder.Write("Engine/Plugins/Other.cpp", "");
	Folder.Write("notes.txt", "");
	const FOverlayFolder Found = Read();
	EXPECT_THAT(Diagnostics, IsEmpty());
	EXPECT_THAT(Found.Shaders, ElementsAre("/Engine/Private/PostProcessBloom.usf", "/Engine/Public/Mine.ush"));
	EXPECT_THAT(Found.Sources, ElementsAre(HasSubstr("PostProcessTonemap.cpp")));
	ASSERT_EQ(1u, Found.Passes.size());
	EXPECT_STREQ("AddTonemapPass", Found.Passes[0].Function->Name);
	EXPECT_EQ(2, Found.Passes[0].Line);
	EXPECT_THAT(Found.IncludeFolders, ElementsAre(HasSubstr("Private"), HasSubstr("Private/PostProcess")));
	EXPECT_THAT(Found.Unused,
		ElementsAre(HasSubstr("Engine/Plugins/Other.cpp (C++ is read below Engine/Source/Runtime/Renderer/Private)")));
	ASSERT_EQ(1u, Found.Places.size());
	EXPECT_EQ(6, Found.Places[0].Line);
	EXPECT_TRUE(Found.Places[0].Text.starts_with("if (bBloomSetupRequiredEnabled)\n\t{"));
	EXPECT_TRUE(Found.Places[0].Text.ends_with("{ \"}\" });\n\t}"));
}

TEST_F(OverlayFolder, AFolderWithoutAnOverlayIsAnError)
{
	EXPECT_THAT(GetFirst(), testing::FieldsAre(ErrorOverlayFolder, 0, HasSubstr("has no file in a folder Engine")));
	Folder.Write("Engine/Readme.md", "");
	Diagnostics.clear();
	EXPECT_THAT(GetFirst(), testing::FieldsAre(ErrorOverlayFolder, 0, HasSubstr("replaces nothing")));
	Diagnostics.clear();
	ReadOverlayFolder("/nowhere/at/all", Diagnostics);
	EXPECT_EQ(ErrorOverlayFolder, Diagnostics.at(0).Code);
}

TEST_F(OverlayFolder, AChainFileNeedsOneBlockOfAPlace)
{
	Folder.Write(Renderer + "PostProcessing.cpp", "void F()\n{\n\tif (bOther) { AddBloomSetupPass(); }\n}\n");
	EXPECT_THAT(GetFirst(),
		testing::FieldsAre(ErrorOverlayPlace, 0, HasSubstr("expected if (bBloomSetupRequiredEnabled) { ... }")));
	Folder.Write(Renderer + "PostProcessing.cpp", Block + Block);
	Diagnostics.clear();
	EXPECT_THAT(GetFirst(), testing::FieldsAre(ErrorOverlayPlace, 17, HasSubstr("has 2 blocks")));
}

TEST_F(OverlayFolder, ClassesOfTheCompositionGraphAreRefused)
{
	Folder.Write(Renderer + "Glow.h",
		"// not as FRenderingCompositePass\n\nclass FGlow : public TRenderingCompositePassBase<1, 1>\n{\n};\n");
	EXPECT_THAT(GetFirst(),
		testing::FieldsAre(ErrorOverlayFolder, 3,
			HasSubstr("TRenderingCompositePassBase belongs to UE4's composition graph, which Unreal 5 does not have: "
					  "write a function that adds the pass with an FRDGBuilder and takes and returns an "
					  "FScreenPassTexture")));
}

TEST_F(OverlayFolder, TextThatEndsInTheMiddleIsRead)
{
	for (size_t Length = 0; Length < Block.size(); Length += 7)
	{
		Folder.Write(Renderer + "PostProcessing.cpp", Block.substr(0, Length));
		Folder.Write(SceneHeader, DuskHeader.substr(0, Length));
		Read();
	}
}
