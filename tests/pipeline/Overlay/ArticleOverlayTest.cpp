// The article on toon bloom, pasted as it stands into an overlay: its struct, its fill, its call and its shader, where
// it says. The picture is that of drydock's own as-printed form, bit for bit. DRYDOCK_ARTICLES: the folder of the
// articles' texts; without it the test is skipped, because the project holds nothing of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "OverlayTestUtils.h"
#include "PasteTestUtils.h"

using namespace OverlayTest;
using namespace PasteTest;
using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;

TEST(ArticleOverlay, ToonBloomPastesAndHasTheBitsOfTheAsPrintedForm)
{
	const std::vector<std::string> Blocks = ReadArticle("000_", "text");
	if (Blocks.empty())
	{
		GTEST_SKIP() << "DRYDOCK_ARTICLES names no folder with this article";
	}
	const FProgramFolder Folder("article_overlay");
	ASSERT_EQ(0, Folder.Call("overlay new Toon --pass BloomSetup").ExitCode);

	Edit(Folder, "Toon/" + Renderer + "PostProcessBloomSetup.h",
		[&](std::string& Text)
		{
			const std::string Member = FindBlock(Blocks, {"// [Required]", "float ToonIntensity = 0.0f;"});
			std::string Inputs = FindBlock(Blocks, {"struct FBloomSetupInputs"});
			Inputs.insert(Inputs.rfind("};"), "\n" + Member);
			Replace(Text, Between(Text, "struct FBloomSetupInputs", "\n};\n"), Inputs);
		});
	Edit(Folder, "Toon/" + Renderer + "PostProcessBloomSetup.cpp",
		[&](std::string& Text)
		{
			const std::string Block = FindBlock(Blocks, {"SHADER_PARAMETER(float, ToonIntensity)"});
			const std::string Fill = Between(Block, "FBloomSetupParameters GetBloomSetupParameters(", "\n}\n");
			const std::string Check = Between(Block, "check(Inputs.ToonIntensity", ";");
			// The one line that is added: the article leaves out the end of its struct.
			const std::string Struct =
				Block.substr(0, Block.find("FBloomSetupParameters GetBloom")) + "END_SHADER_PARAMETER_STRUCT()\n";
			Replace(Text,
				Between(Text, "BEGIN_SHADER_PARAMETER_STRUCT(FBloomSetupParameters", "END_SHADER_PARAMETER_STRUCT()\n"),
				Struct);
			Replace(Text, Between(Text, "FBloomSetupParameters GetBloomSetupParameters(", "\n}\n"), Fill);
			Replace(Text, "\tcheck(Inputs.EyeAdaptationBuffer);\n",
				"\tcheck(Inputs.EyeAdaptationBuffer);\n\t" + Check + "\n");
		});
	Edit(Folder, "Toon/" + Renderer + "PostProcessing.cpp",
		[&](std::string& Text)
		{
			Replace(Text, Between(Text, "\tif (bBloomSetupRequiredEnabled)", "\n\t}\n"),
				FindBlock(Blocks, {"if (bBloomSetupRequiredEnabled)", "SetupPassInputs.ToonIntensity"}));
		});
	Edit(Folder, "Toon/Engine/Shaders/Private/PostProcessBloom.usf",
		[&](std::string& Text)
		{
			Replace(Text, Between(Text, "void BloomSetupPS(", "\n}\n"),
				FindBlock(Blocks, {"void BloomSetupPS(", "ToonIntensity *"}));
			Replace(Text, "float BloomThreshold;\n",
				"float BloomThreshold;\n" + FindBlock(Blocks, {"float ToonIntensity;"}));
		});

	// The setting is there already, so these change nothing; they are read all the same.
	Folder.Write("Toon/" + SceneHeader, FindBlock(Blocks, {"uint8 bOverride_BloomToonIntensity:1;"}));
	Folder.Write("Toon/" + SceneSource, FindBlock(Blocks, {"ExportToPostProcessSettings"}));
	Folder.Write("Toon/" + SceneView, FindBlock(Blocks, {"LERP_PP(BloomToonIntensity)"}));

	const std::string Run = "run " DRYDOCK_TEST_SOURCE_DIR "/configs/toon_bloom.json --pp BloomThreshold=0.5 ";
	std::string Last;
	for (const std::string Factor : {"0.1", "1", "3"})
	{
		const std::string Setting = "--pp BloomToonIntensity=" + Factor;
		const FOutcome Printed = Folder.Call(Run + "--set r.ToonBloom.AsPrinted=1 --out printed " + Setting);
		const FOutcome Pasted = Folder.Call(Run + "--overlay Toon --out pasted " + Setting);
		ASSERT_EQ(0, Printed.ExitCode) << Printed.Printed;
		ASSERT_EQ(0, Pasted.ExitCode) << Pasted.Printed;
		EXPECT_EQ(Folder.Read("printed/final.exr"), Folder.Read("pasted/final.exr")) << Factor;
		EXPECT_NE(Last, Folder.Read("pasted/final.exr")) << "the slider acts";
		Last = Folder.Read("pasted/final.exr");
	}
}
