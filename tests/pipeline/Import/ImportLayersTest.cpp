// Layers as files name them. Names: docs/your-frame.md says whose they are and where they are documented.
#include "pipeline/Import/ImportTestUtils.h"

#include "SceneFile/SceneTexturePacking.h"

#include <algorithm>
#include <fstream>

using namespace Drydock;
using namespace ImportTest;

namespace
{

std::vector<std::string> GetNames(const FImportLayers& Layers)
{
	std::vector<std::string> Names;
	for (const FImportLayer& Layer : Layers.Layers)
	{
		std::string Name = Layer.Label + ":";
		for (const FImportChannel& Channel : Layer.Channels)
		{
			Name += std::to_string(Channel.Slot);
		}
		Names.push_back(Name);
	}
	std::sort(Names.begin(), Names.end());
	return Names;
}

std::string GetGroup(const std::string& Name)
{
	const FImportNameRule* const Rule = FindImportNameRule(Name);
	return Rule == nullptr ? "none" : Rule->Group;
}

} // namespace

TEST(ImportChannelName, IsALayerAndAComponent)
{
	EXPECT_EQ((FImportChannelName{"", 0}), SplitChannelName("R"));
	EXPECT_EQ((FImportChannelName{"FinalImageWorldNormal", 1}), SplitChannelName("FinalImageWorldNormal.G"));
	EXPECT_EQ((FImportChannelName{"View Layer.Depth", 2}), SplitChannelName("View Layer.Depth.Z"));
	EXPECT_EQ((FImportChannelName{"ViewLayer.Depth", 1}), SplitChannelName("ViewLayer.Depth.V"));
	EXPECT_EQ((FImportChannelName{"ViewLayer.CryptoObject00", 3}), SplitChannelName("ViewLayer.CryptoObject00.a"));
	EXPECT_EQ((FImportChannelName{"Z", 0}), SplitChannelName("Z"));
	EXPECT_EQ((FImportChannelName{"metallic", -1}), SplitChannelName("metallic"));
	EXPECT_EQ((FImportChannelName{"", -1}), SplitChannelName(""));
}

TEST(ImportChannelName, GarbageOfUnreal53OnLinuxIsCut)
{
	EXPECT_EQ((FImportChannelName{"ActorHitProxyMask00", 0}), SplitChannelName("ActorHitProxyMask00.R\x01\xff.B"));
	EXPECT_EQ((FImportChannelName{"FinalImageWorldNormal", 2}), SplitChannelName("FinalImageWorldNormal.Bqz17"));
	EXPECT_EQ((FImportChannelName{"Other.Bqz17", -1}), SplitChannelName("Other.Bqz17"));
}

TEST(ImportNameRule, UnrealsNames)
{
	EXPECT_EQ("depth", GetGroup("FinalImageMovieRenderQueue_WorldDepth"));
	EXPECT_EQ("velocity", GetGroup("FinalImageMovieRenderQueue_MotionVectors"));
	EXPECT_EQ("normal", GetGroup("FinalImageWorldNormal"));
	EXPECT_EQ("basecolor", GetGroup("FinalImageBaseColor"));
	EXPECT_EQ("color", GetGroup("FinalImagePreTonemapHDRColor"));
	EXPECT_EQ("color", GetGroup("FinalImage"));
	EXPECT_EQ("normal", GetGroup("FinalImageWorldNormal_CineCameraActor2"));
	EXPECT_EQ("customdepth", GetGroup("FinalImageCustomDepth"));
	EXPECT_EQ("customstencil", GetGroup("FinalImageCustomStencil"));
	EXPECT_EQ("translucency", GetGroup("FinalImageSeparateTranslucencyRGB"));
	EXPECT_EQ("depth", GetGroup("FinalImageSceneDepthWorldUnits"));
	EXPECT_EQ("", GetGroup("FinalImagePostTonemapHDRColor"));
	EXPECT_EQ("", GetGroup("ActorHitProxyMask01"));
	EXPECT_EQ("none", GetGroup("FinalImageSubsurfaceColor"));
	EXPECT_EQ("none", GetGroup("FinalImageOpacity"));
}

TEST(ImportNameRule, BlendersNames)
{
	EXPECT_EQ("color", GetGroup("ViewLayer.Combined"));
	EXPECT_EQ("depth", GetGroup("View Layer.Depth"));
	EXPECT_EQ("depth", GetGroup("ViewLayer.Mist"));
	EXPECT_EQ("normal", GetGroup("ViewLayer.Normal"));
	EXPECT_EQ("velocity", GetGroup("ViewLayer.Vector"));
	EXPECT_EQ("customstencil", GetGroup("ViewLayer.IndexOB"));
	EXPECT_EQ("customstencil", GetGroup("ViewLayer.Object Index"));
	EXPECT_EQ("shadingmodel", GetGroup("ViewLayer.IndexMA"));
	EXPECT_EQ("basecolor", GetGroup("ViewLayer.DiffCol"));
	EXPECT_EQ("", GetGroup("ViewLayer.Denoising Normal"));
	EXPECT_EQ("", GetGroup("ViewLayer.CryptoObject00"));
	EXPECT_EQ("none", GetGroup("ViewLayer.GlossDir"));
	EXPECT_EQ("none", GetGroup("ViewLayer.UV"));
}

TEST(ImportNameRule, NamesOfFiles)
{
	EXPECT_EQ("shot_WorldNormal", GetPassOfFile("out/shot_WorldNormal.0001.exr"));
	EXPECT_EQ("WorldNormal", GetPassOfFile("shot.WorldNormal.0001.exr"));
	EXPECT_EQ("HighresScreenshot00000_BaseColor", GetPassOfFile("HighresScreenshot00000_BaseColor.png"));
	EXPECT_EQ("depth", GetGroup(GetPassOfFile("walk_depth_0012.exr")));
	EXPECT_EQ("customstencil", GetGroup(GetPassOfFile("walk_id.png")));
	EXPECT_EQ("none", GetGroup(GetPassOfFile("grid.png")));
}

TEST(ImportTargets, AreAllChannelsThatASceneCanHave)
{
	std::vector<std::string> Names;
	for (const FImportTarget& Target : GetImportTargets())
	{
		Names.insert(Names.end(), Target.Channels.begin(), Target.Channels.end());
	}
	std::vector<std::string> Known = GetSceneChannelNames();
	std::sort(Names.begin(), Names.end());
	std::sort(Known.begin(), Known.end());
	EXPECT_EQ(Known, Names);
}

using ImportLayersRead = FImportFolder;

TEST_F(ImportLayersRead, OfAMovieRenderQueueFile)
{
	FPart Part;
	Part.Channels = Join({MakeLayer("", "RGBA", {1}), MakeLayer("FinalImageMovieRenderQueue_WorldDepth", "RGB", {1}),
		MakeLayer("FinalImageWorldNormal", "RGB", {1})});
	const FImportLayers Layers = ReadImportLayers({Write("shot.exr", Part)});
	EXPECT_EQ((std::vector<std::string>{
				  "FinalImageMovieRenderQueue_WorldDepth:012", "FinalImageWorldNormal:012", "shot.exr:0123"}),
		GetNames(Layers));
	EXPECT_EQ(EImportOrigin::Unreal, FindImportOrigin(Layers, 0));
}

TEST_F(ImportLayersRead, OfOnePartToAPass)
{
	FPart Color;
	Color.Name = "FinalImage";
	Color.Channels = MakeLayer("", "RGBA", {1});
	FPart Normal;
	Normal.Name = "FinalImageWorldNormal";
	Normal.Channels = MakeLayer("", "RGB", {1});
	FPart Depth;
	Depth.Name = "FinalImageMovieRenderQueue_WorldDepth";
	Depth.Channels = MakeLayer("", "R", {7}, OIIO::TypeDesc::FLOAT);
	WriteParts(PathOf("parts.exr"), {Color, Normal, Depth});
	const FImportLayers Layers = ReadImportLayers({PathOf("parts.exr")});
	EXPECT_EQ((std::vector<std::string>{
				  "FinalImage:0123", "FinalImageMovieRenderQueue_WorldDepth:0", "FinalImageWorldNormal:012"}),
		GetNames(Layers));
}

TEST_F(ImportLayersRead, OfTwoFilesOfOneNameInFoldersOfTheirPasses)
{
	FPart Part;
	Part.Channels = MakeLayer("", "RGB", {1});
	const FImportLayers Layers =
		ReadImportLayers({Write("FinalImage/seq.0001.exr", Part), Write("FinalImageWorldNormal/seq.0001.exr", Part)});
	EXPECT_EQ((std::vector<std::string>{"FinalImage/seq.0001.exr:012", "FinalImageWorldNormal/seq.0001.exr:012"}),
		GetNames(Layers));
	EXPECT_EQ("FinalImageWorldNormal", Layers.Layers[1].Hint);
}

TEST_F(ImportLayersRead, MissingAndBrokenFilesAreErrorsOfFiles)
{
	EXPECT_EQ("5001 3", ErrorOf([&] { ReadImportLayers({PathOf("none.exr")}); }));
	std::ofstream(PathOf("text.exr")) << "no picture";
	EXPECT_EQ("5002 3", ErrorOf([&] { ReadImportLayers({PathOf("text.exr")}); }));
}
