// Overlays from the command line: made, run, edited, stacked, compared and refused; what they replace acts in the frame
// and is gone in the next run without them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Overlay/OverlayFiles.h"
#include "OverlayTestUtils.h"
#include "pipeline/ProgramTestUtils.h"

using namespace OverlayTest;
using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** A downsampling pass that draws one colour, which added settings choose. */
const std::string DuskPass = R"(
#include "PostProcess/PostProcessDownsample.h"
#include "PixelShaderUtils.h"
#include "SceneRendering.h"

class FDuskPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDuskPS);
	SHADER_USE_PARAMETER_STRUCT(FDuskPS, FGlobalShader);
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FLinearColor, Tint)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FDuskPS, "/Engine/Private/Dusk.usf", "MainPS", SF_Pixel);

FScreenPassTexture AddDownsamplePass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDownsamplePassInputs& Inputs)
{
	FRDGTextureDesc Desc = Inputs.SceneColor.Texture->Desc;
	Desc.Reset();
	Desc.Extent = FIntPoint::DivideAndRoundUp(Desc.Extent, 2);
	Desc.Flags = TexCreate_ShaderResource | TexCreate_RenderTargetable;
	const FIntRect Rect = FIntRect::DivideAndRoundUp(Inputs.SceneColor.ViewRect, 2);
	FScreenPassRenderTarget Output(
		GraphBuilder.CreateTexture(Desc, Inputs.Name), Rect, ERenderTargetLoadAction::ENoAction);
	auto* PassParameters = GraphBuilder.AllocParameters<FDuskPS::FParameters>();
	const FLinearColor Tint = View.FinalPostProcessSettings.DuskTint;
	PassParameters->Tint = View.FinalPostProcessSettings.DuskMode == EDuskMode::Cold
		? FLinearColor(0, 0, View.FinalPostProcessSettings.DuskTint.B)
		: Tint * View.FinalPostProcessSettings.DuskAmount;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	TShaderMapRef<FDuskPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, View.ShaderMap, RDG_EVENT_NAME("Dusk"), PixelShader, PassParameters, Rect);
	return FScreenPassTexture(Output);
}
)";

const std::string DuskShader = "#include \"/Engine/Private/Common.ush\"\nfloat4 Tint;\n"
							   "void MainPS(float4 P : SV_POSITION, out float4 O : SV_Target0) { O = Tint; }\n";

void WriteDusk(const FProgramFolder& Folder)
{
	Folder.Write("Dusk/" + SceneHeader, DuskHeader);
	Folder.Write("Dusk/" + SceneSource, DuskSource);
	Folder.Write("Dusk/" + SceneView, DuskView);
	Folder.Write("Dusk/" + Renderer + "PostProcessDownsample.cpp", DuskPass);
	Folder.Write("Dusk/Engine/Shaders/Private/Dusk.usf", DuskShader);
}

/** The picture that a run of frame.json writes. */
std::string GetPicture(const FProgramFolder& Folder, const std::string& Arguments)
{
	const FOutcome Run = Folder.Call("run frame.json --out out " + Arguments);
	EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
	return Folder.Read("out/final.exr");
}

} // namespace

TEST(OverlayRun, SettingsAndPassesOfAnOverlayActInChainAndVolumes)
{
	const FProgramFolder Folder("overlay_run");
	Folder.WriteFrame("frame.json", R"(, "camera": {"Settings": {"BloomIntensity": 1, "BloomThreshold": -1}})");
	Folder.WriteFrame("cold.json", R"(, "overlay": "Dusk", "camera": {"Settings": {"BloomIntensity": 1}},
		"volumes": [{"bUnbound": true, "Settings": {"DuskMode": "Cold", "DuskTint": [0, 0, 4, 0]}}])");
	WriteDusk(Folder);
	const std::string Plain = GetPicture(Folder, "");
	const std::string Dusk = GetPicture(Folder, "--overlay Dusk");
	EXPECT_NE(Plain, Dusk);
	EXPECT_NE(Dusk, GetPicture(Folder, "--overlay Dusk --pp DuskAmount=0.5"));
	EXPECT_NE(Dusk, GetPicture(Folder, "--overlay Dusk --pp DuskMode=Cold"));
	EXPECT_EQ(Dusk, GetPicture(Folder, "--overlay Dusk --pp DuskMode=Warm"));
	EXPECT_EQ(Plain, GetPicture(Folder, ""));

	const FOutcome Cold = Folder.Call("run cold.json");
	EXPECT_EQ(0, Cold.ExitCode) << Cold.Printed;
	EXPECT_THAT(Cold.Printed, HasSubstr("the overlay Dusk stands in for /Engine/Private/Dusk.usf, AddDownsamplePass, "
										"DuskTint, DuskMode, DuskAmount"));
	const FOutcome Blend = Folder.Call("blend cold.json");
	EXPECT_THAT(Blend.Printed, HasSubstr("DuskMode"));
	const FOutcome Misspelt = Folder.Call("run cold.json --pp DuskMod=1");
	EXPECT_EQ(2, Misspelt.ExitCode);
	EXPECT_THAT(Misspelt.Printed, HasSubstr("did you mean DuskMode?"));

	Folder.Write("Dusk/" + Renderer + "PostProcessDownsample.cpp", DuskPass + "int Broken(\n");
	const FOutcome Broken = Folder.Call("run cold.json");
	EXPECT_EQ(2, Broken.ExitCode);
	EXPECT_THAT(Broken.Printed, HasSubstr("PostProcessDownsample.cpp"));
}

TEST(OverlayRun, ANewOverlayGivesTheSameBitsUntilItIsEdited)
{
	const FProgramFolder Folder("overlay_new");
	Folder.WriteFrame("frame.json", R"(, "camera": {"Settings": {"BloomIntensity": 1, "BloomThreshold": 0.25,
		"LocalExposureHighlightContrastScale": 0.6}})");
	const FOutcome New = Folder.Call("overlay new MyPatch --pass BloomSetup");
	ASSERT_EQ(0, New.ExitCode) << New.Printed;
	const FOutcome Own = Folder.Call("run MyPatch/MyPatch.json --out own");
	EXPECT_EQ(0, Own.ExitCode) << Own.Printed;
	const std::string Plain = GetPicture(Folder, "");
	EXPECT_EQ(Plain, GetPicture(Folder, "--overlay MyPatch"));
	EXPECT_EQ(Plain, GetPicture(Folder, "--overlay MyPatch --set r.PostProcessing.PreferCompute=1"));
	EXPECT_THAT(Folder.Call("overlay diff MyPatch").Printed, HasSubstr("no line has changed"));

	// The block of the chain alone: half of the threshold.
	const std::string Chain = "MyPatch/" + Renderer + "PostProcessing.cpp";
	std::string Text = Folder.Read(Chain);
	const std::string Line = "SetupPassInputs.Threshold = BloomThreshold;";
	ASSERT_NE(std::string::npos, Text.find(Line));
	Folder.Write(
		Chain, Text.replace(Text.find(Line), Line.size(), "SetupPassInputs.Threshold = 0.5f * BloomThreshold;"));
	const std::string Half = GetPicture(Folder, "--overlay MyPatch");
	EXPECT_EQ(Half, GetPicture(Folder, "--pp BloomThreshold=0.125"));
	const std::string Difference = Folder.Call("overlay diff MyPatch").Printed;
	EXPECT_THAT(Difference, HasSubstr("@@ void AddPostProcessingPasses @@\n-\t\tSetupPassInputs.Threshold = Bloom"));
	EXPECT_THAT(Difference, Not(HasSubstr("drydock's own, which")));

	// A shader alone.
	const std::string Shader = "Only/Engine/Shaders/Private/PostProcessBloom.usf";
	Text = Folder.Read("MyPatch/Engine/Shaders/Private/PostProcessBloom.usf");
	Folder.Write(Shader, Text + "// a comment changes the text, and nothing else\n");
	EXPECT_EQ(Plain, GetPicture(Folder, "--overlay Only"));
	Text.replace(Text.find("View.PreExposure, 0.0f"), 16, "2.0f * View.PreExposure");
	Folder.Write(Shader, Text);
	EXPECT_NE(Plain, GetPicture(Folder, "--overlay Only --no-plugins"));
	EXPECT_EQ(Plain, GetPicture(Folder, ""));

	const FOutcome Refused = Folder.Call("run frame.json --overlay MyPatch --no-plugins");
	EXPECT_EQ(2, Refused.ExitCode);
	EXPECT_THAT(Refused.Printed, HasSubstr("DD1134"));
	const FOutcome Clash = Folder.Call("run frame.json --overlay MyPatch --overlay Only");
	EXPECT_EQ(2, Clash.ExitCode);
	EXPECT_THAT(Clash.Printed, HasSubstr("both replace /Engine/Private/PostProcessBloom.usf; one must stand over"));
	Folder.WriteFrame("stack.json", R"(, "camera": {"Settings": {"BloomIntensity": 1, "BloomThreshold": 0.25}},
		"overlay": [{"folder": "Only", "over": "MyPatch"}, "MyPatch"])");
	const FOutcome Stack = Folder.Call("run stack.json");
	EXPECT_EQ(0, Stack.ExitCode) << Stack.Printed;
	EXPECT_THAT(Stack.Printed, HasSubstr("/Engine/Private/PostProcessBloom.usf (Only stands over it)"));
}

TEST(OverlayRun, ANewOverlaysConfigCallsItsPass)
{
	const FProgramFolder Folder("overlay_passes");
	const std::vector<std::string> Passes = Drydock::ListOverlayPasses();
	ASSERT_GE(Passes.size(), 13u);
	for (const std::string& Pass : Passes)
	{
		ASSERT_EQ(0, Folder.Call("overlay new Of" + Pass + " --pass " + Pass).ExitCode);
		const FOutcome Run = Folder.Call("run Of" + Pass + "/Of" + Pass + ".json");
		EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
		EXPECT_THAT(Run.Printed, HasSubstr("the overlay Of" + Pass + " stands in for /Engine/Private/"));
		EXPECT_THAT(Run.Printed, Not(HasSubstr("DD1135")));
		EXPECT_THAT(Run.Printed, Not(HasSubstr("DD1137"))) << Pass;
	}
}

TEST(OverlayRun, ADifferenceIsWhatAPersonCarriesOver)
{
	const FProgramFolder Folder("overlay_diff");
	ASSERT_EQ(0, Folder.Call("overlay new MyPatch --pass BloomSetup").ExitCode);
	const std::string File = "MyPatch/" + Renderer + "PostProcessBloomSetup.cpp";
	const std::string Text = Folder.Read(File);

	// The ends of lines and the mark of an editor do not count as changes.
	std::string Windows = "\xef\xbb\xbf" + Text;
	for (size_t At = Windows.find('\n'); At != std::string::npos; At = Windows.find('\n', At + 2))
	{
		Windows.replace(At, 1, "\r\n");
	}
	Folder.Write(File, Windows);
	EXPECT_THAT(Folder.Call("overlay diff MyPatch").Printed, HasSubstr("# no line has changed\n"));

	// A comment that names drydock is not its code; a struct of parameters has a name.
	std::string Edited = Text;
	const std::string Member = "\tSHADER_PARAMETER(float, BloomThreshold)\n";
	Edited.insert(Edited.find(Member), "\tSHADER_PARAMETER(float, Dusk) // drydock's own scale\n");
	Folder.Write(File, Edited);
	Folder.Write("MyPatch/" + SceneSource, "\tDuskAmount = 0.25f;\r\n");
	const std::string Printed = Folder.Call("overlay diff MyPatch").Printed;
	EXPECT_THAT(Printed, HasSubstr("@@ struct FBloomSetupParameters @@\n+\tSHADER_PARAMETER(float, Dusk) // dry"));
	EXPECT_THAT(Printed, HasSubstr("+++ " + SceneSource + "\n@@ new to drydock @@\n+\tDuskAmount = 0.25f;\n"));
	EXPECT_THAT(Printed, Not(HasSubstr("no line has changed")));
	EXPECT_EQ(2, Folder.Call("overlay diff MyPatch --engine 9.9").ExitCode);
	EXPECT_THAT(Folder.Call("overlay diff MyPatch --engine 9.9").Printed, HasSubstr("5.4"));
	EXPECT_THAT(Folder.Call("overlay diff MyPatch --engine 5.6").Printed, HasSubstr("for engine 5.6"));
}

TEST(OverlayRun, MistakesAreNamed)
{
	const FProgramFolder Folder("overlay_mistakes");
	Folder.WriteFrame("frame.json", "");
	const FOutcome Pass = Folder.Call("overlay new MyPatch --pass BloomSetups");
	EXPECT_EQ(2, Pass.ExitCode);
	EXPECT_THAT(Pass.Printed, HasSubstr("did you mean BloomSetup?"));
	EXPECT_THAT(
		Folder.Call("overlay new MyPatch --pass AddBloomSetupPass").Printed, HasSubstr("did you mean BloomSetup?"));
	EXPECT_THAT(Folder.Call("overlay new --help").Printed, Not(HasSubstr("DiaphragmDOF")));
	const FOutcome Cpu = Folder.Call("overlay new MyPatch --pass Histogram");
	EXPECT_EQ(2, Cpu.ExitCode);
	EXPECT_THAT(Cpu.Printed, HasSubstr("has no file of it in the engine's form"));
	const FOutcome Missing = Folder.Call("run frame.json --overlay Nowhere");
	EXPECT_EQ(2, Missing.ExitCode);
	EXPECT_THAT(Missing.Printed, HasSubstr("DD1130"));
	EXPECT_THAT(
		Folder.Call("run frame.json --overlay ''").Printed, HasSubstr("an overlay needs the name of its folder"));

	// The config's words.
	const std::pair<const char*, const char*> Wrong[] = {
		{"7", "at /overlay: expected a folder's name, or an array of them, found a number"},
		{R"({"folder": "Dusk", "ovr": "x"})", "at /overlay/ovr: unknown key \"ovr\"; did you mean over?"},
		{R"(["Dusk", "Other", 3])", "at /overlay/2: expected a folder's name"},
		{R"(["Dusk", "Dusk/"])", "the overlay Dusk/ is named twice"},
		{R"(["Dusk", {"folder": "Other", "over": "Duks"}])", "no overlay \"Duks\" that Other could stand over"},
		{R"([{"folder": "Dusk", "over": "Other"}, {"folder": "Other", "over": "Dusk"}])", "stand over each other"},
	};
	for (const auto& [Overlay, Message] : Wrong)
	{
		Folder.WriteFrame("wrong.json", std::string(R"(, "overlay": )") + Overlay);
		const FOutcome Run = Folder.Call("run wrong.json");
		EXPECT_EQ(2, Run.ExitCode) << Overlay;
		EXPECT_THAT(Run.Printed, HasSubstr(Message));
	}
}
