// What layers become, from lists of layers written by hand.
#include "Import/ImportGuess.h"

#include <gtest/gtest.h>

using namespace Drydock;

namespace
{

struct FLayerText
{
	std::string Name;
	int NumChannels = 3;
	size_t File = 0;
};

FImportLayers MakeLayers(const std::vector<FLayerText>& Texts, size_t NumFiles = 1)
{
	FImportLayers Layers;
	for (size_t File = 0; File < NumFiles; ++File)
	{
		Layers.Files.push_back({.Path = "file" + std::to_string(File) + ".exr"});
		Layers.Files.back().Parts.push_back({8, 4, {}});
	}
	for (const FLayerText& Text : Texts)
	{
		FImportLayer Layer{.File = Text.File, .Name = Text.Name, .Label = Text.Name, .Hint = Text.Name};
		Layer.Label = Text.Name.empty() ? Layers.Files[Text.File].Path : Text.Name;
		for (int Slot = 0; Slot < Text.NumChannels; ++Slot)
		{
			Layer.Channels.push_back(
				{(Text.Name.empty() ? "" : Text.Name + ".") + std::string("RGBA").substr(static_cast<size_t>(Slot), 1),
					Slot, Slot});
		}
		Layers.Layers.push_back(Layer);
	}
	return Layers;
}

/** "color=0 depth=2:1 ...": layer, and the first slot where it is not 0. */
std::string Describe(const FImportPlan& Plan)
{
	std::string Text;
	for (const FImportRow& Row : Plan.Rows)
	{
		Text += std::string(Text.empty() ? "" : " ") + Row.Target->Group + "=" + std::to_string(Row.Sources[0]->Layer);
		Text += Row.Sources[0]->Slot == 0 ? "" : ":" + std::to_string(Row.Sources[0]->Slot);
	}
	return Text;
}

struct FGuessed
{
	std::string Plan;
	std::string Messages; // numbers; of an error with the exit code
	std::string FirstMessage;
};

FGuessed Guess(const FImportLayers& Layers, const FImportAsked& Asked = {})
{
	std::vector<FDiagnostic> Diagnostics;
	FGuessed Guessed;
	std::string Exit;
	try
	{
		Guessed.Plan = Describe(GuessImport(Layers, Asked, Diagnostics));
	}
	catch (const FError& Error)
	{
		Diagnostics = Error.GetDiagnostics();
		Exit = "exit " + std::to_string(Error.GetExitCode());
	}
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		Guessed.Messages += std::to_string(Diagnostic.Code) + " ";
	}
	Guessed.Messages += Exit;
	Guessed.FirstMessage = Diagnostics.empty() ? "" : Diagnostics[0].Message;
	return Guessed;
}

FImportAsked Map(const std::vector<std::string>& Maps)
{
	FImportAsked Asked;
	Asked.Maps = Maps;
	return Asked;
}

} // namespace

TEST(ImportGuess, OfAMovieRenderQueueFile)
{
	const FGuessed Guessed = Guess(MakeLayers({{"", 4}, {"FinalImageMovieRenderQueue_WorldDepth", 4},
		{"FinalImageMovieRenderQueue_MotionVectors", 4}, {"FinalImageWorldNormal"}, {"FinalImageBaseColor"},
		{"FinalImagePreTonemapHDRColor"}, {"FinalImageDrydockIds"}, {"ActorHitProxyMask00", 4}}));
	EXPECT_EQ("color=5 depth=1 normal=3 velocity=2 basecolor=4 shadingmodel=6 customdepth=6:2 customstencil=6:1",
		Guessed.Plan);
	EXPECT_EQ("", Guessed.Messages); // the frame before the tonemapper is better than the final one, without a doubt
}

TEST(ImportGuess, OfABlenderFile)
{
	const FGuessed Guessed = Guess(MakeLayers({{"ViewLayer.Combined", 4}, {"ViewLayer.Depth", 1}, {"ViewLayer.Normal"},
		{"ViewLayer.Vector", 4}, {"ViewLayer.IndexOB", 1}, {"ViewLayer.IndexMA", 1}, {"ViewLayer.Mist", 1}}));
	EXPECT_EQ("color=0 depth=1 normal=2 velocity=3 shadingmodel=5 customstencil=4", Guessed.Plan);
	EXPECT_EQ("", Guessed.Messages);
}

TEST(ImportGuess, TwoOfARankAreADoubtThatIsSaid)
{
	const FGuessed Guessed = Guess(MakeLayers({{"A.Combined", 4}, {"B.Combined", 4}, {"B.Depth", 1}, {"A.Depth", 1}}));
	EXPECT_EQ("color=0 depth=3", Guessed.Plan); // depth of the view layer that colour is of
	EXPECT_EQ("1091 1091 ", Guessed.Messages);
	EXPECT_NE(std::string::npos, Guessed.FirstMessage.find("--map \"B.Combined=color\"")) << Guessed.FirstMessage;
}

TEST(ImportGuess, MapHasTheLastWord)
{
	const FImportLayers Layers = MakeLayers({{"", 4}, {"FinalImageWorldNormal"}, {"FinalImageOdd"}, {"Depth", 1}});
	EXPECT_EQ("color=0 depth=3 normal=2 basecolor=1",
		Guess(Layers, Map({"FinalImageOdd=normal", "FinalImageWorldNormal=basecolor"})).Plan);
	EXPECT_EQ("color=0 depth=2:1 normal=1", Guess(Layers, Map({"FinalImageOdd.G=depth.Z"})).Plan);
	EXPECT_EQ("color=0 depth=3", Guess(Layers, Map({"FinalImageWorldNormal=none"})).Plan);
	EXPECT_EQ("color=2 depth=3 normal=1", Guess(Layers, Map({"FinalImageOdd=color"})).Plan);
}

TEST(ImportGuess, MistakesOfMapAreToldTogetherEachWithTheNearestName)
{
	const FImportLayers Layers = MakeLayers({{"", 4}, {"FinalImageWorldNormal"}});
	const FGuessed Guessed =
		Guess(Layers, Map({"FinalImageWorldNormul=normal", "FinalImageWorldNormal=depht", "nothing", "=depth"}));
	EXPECT_EQ("1090 1090 1090 1090 exit 2", Guessed.Messages);
	EXPECT_NE(std::string::npos, Guessed.FirstMessage.find("did you mean FinalImageWorldNormal"))
		<< Guessed.FirstMessage;
	EXPECT_EQ("1090 exit 2", Guess(Layers, Map({"FinalImageWorldNormal.R=normal.X"})).Messages); // Y and Z are missing
}

TEST(ImportGuess, WithoutColourThereIsNoScene)
{
	const FGuessed Guessed = Guess(MakeLayers({{"FinalImageWorldNormal"}, {"Strange"}}));
	EXPECT_EQ("1095 exit 2", Guessed.Messages);
	EXPECT_NE(std::string::npos, Guessed.FirstMessage.find("FinalImageWorldNormal, Strange")) << Guessed.FirstMessage;
	EXPECT_EQ("1095 exit 2", Guess(FImportLayers()).Messages);
}

TEST(ImportGuess, LayersOfDifferentPicturesAreRefused)
{
	FImportLayers Layers = MakeLayers({{"", 4}, {"Depth", 1, 1}}, 2);
	Layers.Files[1].Parts[0] = {16, 4, {}};
	EXPECT_EQ("1096 exit 2", Guess(Layers).Messages);
	Layers.Files[1].Parts[0] = {4, 2, {2, 1, 8, 4}}; // a part of a picture of the same size
	EXPECT_EQ("", Guess(Layers).Messages);
}

TEST(ImportGuess, NothingIsLeftOutInSilence)
{
	std::vector<FDiagnostic> Diagnostics;
	const FImportLayers Layers = MakeLayers({{"", 4}, {"ViewLayer.UV"}, {"ViewLayer.Mist", 1}, {"CryptoObject00", 4},
		{"Normal", 2}, {"FinalImagePostTonemapHDRColor"}});
	const FImportPlan Plan = GuessImport(Layers, {}, Diagnostics);
	EXPECT_EQ("color=0", Describe(Plan));
	EXPECT_EQ(5u, Plan.LeftOut.size());
	for (const FImportLeftOut& LeftOut : Plan.LeftOut)
	{
		EXPECT_FALSE(LeftOut.Why.empty()) << Layers.Layers[LeftOut.Layer].Name;
	}
}

TEST(ImportGuess, AskedMistIsDepth)
{
	FImportAsked Asked;
	Asked.Mist = FImportMist{1.0, 20.0};
	std::vector<FDiagnostic> Diagnostics;
	const FImportPlan Plan = GuessImport(MakeLayers({{"", 4}, {"ViewLayer.Mist", 1}}), Asked, Diagnostics);
	ASSERT_NE(nullptr, Plan.Find("depth"));
	EXPECT_EQ(EImportDepth::Mist, Plan.Find("depth")->Encoding.Depth);
}

TEST(ImportGuess, ConventionsFollowTheOrigin)
{
	std::vector<FDiagnostic> Diagnostics;
	const FImportPlan Unreal = GuessImport(
		MakeLayers({{"", 4}, {"FinalImageMovieRenderQueue_WorldDepth"}, {"FinalImageWorldNormal"}}), {}, Diagnostics);
	EXPECT_EQ("cm", Unreal.Find("depth")->Encoding.Unit);
	EXPECT_EQ(EImportNormalSpace::Unreal, Unreal.Find("normal")->Encoding.NormalSpace);
	const FImportPlan Blender = GuessImport(
		MakeLayers({{"ViewLayer.Combined", 4}, {"ViewLayer.Depth", 1}, {"ViewLayer.Vector", 4}, {"ViewLayer.Normal"}}),
		{}, Diagnostics);
	EXPECT_EQ("m", Blender.Find("depth")->Encoding.Unit);
	EXPECT_EQ(EImportNormalSpace::World, Blender.Find("normal")->Encoding.NormalSpace);
	EXPECT_EQ(EImportVelocity::Blender, Blender.Find("velocity")->Encoding.Velocity);
	// A file that says nothing follows the others.
	FImportLayers Mixture = MakeLayers({{"FinalImagePreTonemapHDRColor", 4}, {"depth", 1, 1}}, 2);
	EXPECT_EQ("cm", GuessImport(Mixture, {}, Diagnostics).Find("depth")->Encoding.Unit);
	FImportAsked Metres;
	Metres.Unit = "m";
	EXPECT_EQ("m", GuessImport(Mixture, Metres, Diagnostics).Find("depth")->Encoding.Unit);
}
