// Whole frames through an import: files as Unreal, Blender and others write them, and the scene that comes out.
#include "pipeline/Import/ImportTestUtils.h"

#include "Import/Import.h"

#include <cmath>
#include <fstream>
#include <cstring>
#include <limits>

using namespace Drydock;
using namespace ImportTest;

namespace
{

class ImportWhole : public FImportFolder
{
protected:
	FImportResult Import(const std::vector<std::string>& Inputs, FImportAsked Asked = {}, bool bDryRun = false) const
	{
		FImportOptions Options;
		for (const std::string& Input : Inputs)
		{
			Options.Inputs.push_back(PathOf(Input));
		}
		Options.OutputFile = PathOf("scene.exr");
		Options.Asked = std::move(Asked);
		Options.bDryRun = bDryRun;
		return ImportFrame(Options);
	}

	std::string ErrorOfImport(const std::vector<std::string>& Inputs, const FImportAsked& Asked = {}) const
	{
		return ErrorOf([&] { Import(Inputs, Asked); });
	}

	float At(const std::string& Channel, size_t Pixel = 0) const { return Read("scene.exr", Channel).at(Pixel); }
};

std::string Numbers(const FImportResult& Result)
{
	std::string Text;
	for (const FDiagnostic& Diagnostic : Result.Diagnostics)
	{
		Text += std::to_string(Diagnostic.Code) + " ";
	}
	return Text;
}

bool Tells(const FImportResult& Result, int Code, const std::string& Part)
{
	for (const FDiagnostic& Diagnostic : Result.Diagnostics)
	{
		if (Diagnostic.Code == Code && Diagnostic.Message.find(Part) != std::string::npos)
		{
			return true;
		}
	}
	return false;
}

bool Contains(const std::string& Text, const std::string& Part)
{
	return Text.find(Part) != std::string::npos;
}

/** A frame as the movie render queue writes it; values by hand. */
FPart MakeUnrealFrame()
{
	FPart Part;
	Part.Channels = Join(
		{MakeLayer("", "RGBA", {0.5, 0.25, 0.125, 0}), MakeLayer("FinalImagePreTonemapHDRColor", "RGBA", {4, 2, 1, 0}),
			MakeLayer("FinalImageMovieRenderQueue_WorldDepth", "RGBA", {350}, OIIO::TypeDesc::FLOAT),
			MakeLayer("FinalImageMovieRenderQueue_MotionVectors", "RGBA", {0.6, 0.5}, OIIO::TypeDesc::FLOAT),
			MakeLayer("FinalImageWorldNormal", "RGB", {0.5, 1.0, 0.5}), MakeLayer("FinalImageBaseColor", "RGB", {0.75}),
			MakeLayer("FinalImageDrydockIds", "RGB", {8, 3, 350}, OIIO::TypeDesc::FLOAT)});
	Part.Attributes = {
		{"unreal/camera/curPos/x", "1"}, {"unreal/camera/curPos/y", "2"}, {"unreal/camera/curPos/z", "3"}};
	return Part;
}

} // namespace

TEST_F(ImportWhole, AMovieRenderQueueFrame)
{
	Write("shot.exr", MakeUnrealFrame());
	const FImportResult Result = Import({"shot.exr"});
	EXPECT_EQ(4.0f, At("R"));
	EXPECT_EQ(2.0f, At("G"));
	EXPECT_EQ(1.0f, At("A")); // 0 everywhere: Unreal's alpha says nothing
	EXPECT_FLOAT_EQ(3.5f, At("depth.Z"));
	EXPECT_NEAR(0.1 * 2 * 4, At("velocity.X"), 1e-5); // of 4 pixels across
	EXPECT_EQ(0.0f, At("velocity.Y"));
	EXPECT_EQ(-1.0f, At("normal.Y")); // the engine's +Y
	EXPECT_EQ(0.75f, At("basecolor.G"));
	EXPECT_EQ(8.0f, At("shadingmodel.ID"));
	EXPECT_EQ(3.0f, At("customstencil.ID"));
	EXPECT_FLOAT_EQ(3.5f, At("customdepth.Z"));
	EXPECT_TRUE(Tells(Result, 1093, "custommask")) << Numbers(Result);
	EXPECT_TRUE(Contains(Result.Report, "FinalImageMovieRenderQueue_WorldDepth")) << Result.Report;
	EXPECT_TRUE(Contains(Result.Report, "0..1, Unreal's world")) << Result.Report;
	EXPECT_TRUE(Contains(FImageFile(PathOf("scene.exr")).GetAttribute("drydock:camera_json"), "position_uecm"));
}

TEST_F(ImportWhole, ABlenderFrame)
{
	FPart Part;
	Part.Channels = Join({MakeLayer("ViewLayer.Combined", "RGBA", {2, 1, 0.5, 1}),
		{{"ViewLayer.Depth.Z",
			[](int X, int)
			{
				return X == 0 ? 1e10 : 5.0;
			}}},
		MakeLayer("ViewLayer.Normal", "XYZ", {0, -1, 0}, OIIO::TypeDesc::FLOAT),
		MakeLayer("ViewLayer.Vector", "XYZW", {3, -2, 0, 0}, OIIO::TypeDesc::FLOAT),
		{{"ViewLayer.IndexOB.X", Constant(7)}}, MakeLayer("ViewLayer.UV", "UVA", {0.5})});
	Write("frame.exr", Part);
	FImportAsked Asked;
	Asked.Toon = {"7"};
	const FImportResult Result = Import({"frame.exr"}, Asked);
	EXPECT_EQ(2.0f, At("R"));
	EXPECT_EQ(65504.0f, At("depth.Z", 0));
	EXPECT_EQ(5.0f, At("depth.Z", 1));
	EXPECT_EQ(-1.0f, At("normal.Y"));
	EXPECT_EQ(-3.0f, At("velocity.X"));
	EXPECT_EQ(-2.0f, At("velocity.Y"));
	EXPECT_EQ(7.0f, At("customstencil.ID"));
	EXPECT_EQ(8.0f, At("shadingmodel.ID"));
	EXPECT_EQ(1.0f, At("custommask.B"));
	EXPECT_TRUE(Contains(Result.Report, "ViewLayer.UV")) << Result.Report; // said to be left out
}

TEST_F(ImportWhole, OneFileToAPassAndIdsAsPng)
{
	FPart Color;
	Color.Channels = MakeLayer("", "RGBA", {3, 3, 3, 1});
	Write("shot.exr", Color);
	FPart Depth;
	Depth.Channels = {{"Y", Constant(2)}};
	Write("shot_depth.exr", Depth);
	FImage Ids{4, 3, 3, {}};
	for (int Value = 0; Value < 36; ++Value)
	{
		Ids.Values.push_back(8.0 / 255.0);
	}
	WritePng(PathOf("shot_ShadingModelID.png"), Ids);
	Import({"shot.exr", "shot_depth.exr", "shot_ShadingModelID.png"});
	EXPECT_EQ(3.0f, At("G"));
	EXPECT_EQ(2.0f, At("depth.Z"));
	EXPECT_EQ(8.0f, At("shadingmodel.ID")); // a whole number, not a colour
}

TEST_F(ImportWhole, PartsTilesAndWholeNumbers)
{
	FPart Color;
	Color.Name = "rgba";
	Color.Channels = MakeLayer("", "RGB", {2}, OIIO::TypeDesc::FLOAT);
	FPart Ids = Color;
	Ids.Name = "ObjectID";
	Ids.Channels = {{"R", [](int X, int) { return X + 250.0; }, OIIO::TypeDesc::UINT32}};
	Color.bTiled = Ids.bTiled = true;
	WriteParts(PathOf("parts.exr"), {Color, Ids});
	Import({"parts.exr"});
	EXPECT_EQ(2.0f, At("B"));
	EXPECT_EQ((std::vector<float>{250, 251, 252, 253}),
		[this]
		{
			std::vector<float> Row = Read("scene.exr", "customstencil.ID");
			Row.resize(4);
			return Row;
		}());
}

TEST_F(ImportWhole, DataWindowsAreLaidIntoThePicture)
{
	FPart Color; // overscan: a pixel more at the left
	Color.Width = 5;
	Color.X = -1;
	Color.FullWidth = 4;
	Color.FullHeight = 3;
	Color.Channels = {{"R",
						  [](int X, int Y)
						  {
							  return X + 10.0 * Y;
						  }},
		{"G", Constant(2)}, {"B", Constant(2)}};
	Write("shot.exr", Color);
	FPart Depth; // a part of the picture alone
	Depth.Width = 2;
	Depth.Height = 1;
	Depth.X = 1;
	Depth.Y = 2;
	Depth.FullWidth = 4;
	Depth.FullHeight = 3;
	Depth.Channels = {{"Z", Constant(6)}};
	Write("shot_z.exr", Depth);
	const FImportResult Result = Import({"shot.exr", "shot_z.exr"});
	EXPECT_EQ((std::vector<float>{1, 2, 3, 4, 11, 12, 13, 14, 21, 22, 23, 24}), Read("scene.exr", "R"));
	const float None = 65504.0f;
	EXPECT_EQ((std::vector<float>{None, None, None, None, None, None, None, None, None, 6, 6, None}),
		Read("scene.exr", "depth.Z"));
	EXPECT_TRUE(Tells(Result, 1098, "cut")) << Numbers(Result);
	EXPECT_TRUE(Tells(Result, 1098, "infinitely far")) << Numbers(Result);
}

TEST_F(ImportWhole, ObjectsOfACryptomatteAreChosenByName)
{
	// Ids are the bits of floats; any that are finite numbers will do.
	const uint32_t Hero = 0x3f2a6c51;
	const uint32_t Tree = 0x40123456;
	const auto Float = [](uint32_t Bits)
	{
		float Value = 0.0f;
		std::memcpy(&Value, &Bits, sizeof(Value));
		return static_cast<double>(Value);
	};
	FPart Part;
	Part.Channels = Join({MakeLayer("", "RGB", {2}), {{"Z", Constant(4)}},
		{{"ActorHitProxyMask00.R",
			 [=](int X, int)
			 {
				 return Float(X < 2 ? Hero : Tree);
			 }},
			{"ActorHitProxyMask00.G", Constant(1)}, {"ActorHitProxyMask00.B", Constant(0)},
			{"ActorHitProxyMask00.A", Constant(0)}}});
	Part.Attributes = {{"cryptomatte/1a2b3c4/name", "ActorHitProxyMask"},
		{"cryptomatte/1a2b3c4/manifest", R"({"Chars/Hero.Body":"3f2a6c51","Props/Tree.Mesh":"40123456"})"}};
	Write("shot.exr", Part);
	FImportAsked Asked;
	Asked.Toon = {"*Hero*"};
	Asked.Stencil = {"Props/*=5"};
	const FImportResult Result = Import({"shot.exr"}, Asked);
	EXPECT_EQ(8.0f, At("shadingmodel.ID", 1));
	EXPECT_EQ(1.0f, At("shadingmodel.ID", 2));
	EXPECT_EQ(1.0f, At("custommask.B", 0));
	EXPECT_EQ(0.0f, At("customstencil.ID", 1));
	EXPECT_EQ(5.0f, At("customstencil.ID", 2));
	EXPECT_EQ(At("depth.Z", 2), At("customdepth.Z", 2)); // where it is seen
	EXPECT_EQ(0.0f, At("customdepth.Z", 1));
	EXPECT_TRUE(Contains(Result.Report, "Chars/Hero.Body, Props/Tree.Mesh")) << Result.Report;
	Asked.Toon = {"Chars/Hero.Bdy"};
	EXPECT_EQ("1090 2", ErrorOfImport({"shot.exr"}, Asked));
	Asked.Toon = {};
	Asked.Stencil = {"Props/*", "*=256", "*=x"};
	EXPECT_EQ("1090 1090 1090 2", ErrorOfImport({"shot.exr"}, Asked));
}

TEST_F(ImportWhole, OtherPrimariesAreConverted)
{
	FPart Part;
	Part.Channels = MakeLayer("", "RGB", {0, 2, 0}, OIIO::TypeDesc::FLOAT);
	Part.Chromaticities = {0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};
	Write("shot.exr", Part);
	const FImportResult Result = Import({"shot.exr"});
	EXPECT_NEAR(2 * -0.5876, At("R"), 1e-3); // BT.2087
	EXPECT_NEAR(2 * 1.1329, At("G"), 1e-3);
	EXPECT_TRUE(Tells(Result, 1098, "Rec.709")) << Numbers(Result);
}

TEST_F(ImportWhole, AlphaAsItIsAsked)
{
	FPart Part;
	Part.Channels = MakeLayer("", "RGBA", {4, 4, 4, 0.25});
	Write("shot.exr", Part);
	Import({"shot.exr"});
	EXPECT_EQ(4.0f, At("R"));
	EXPECT_EQ(0.25f, At("A"));
	FImportAsked Asked;
	Asked.Alpha = EImportAlpha::Straight;
	Import({"shot.exr"}, Asked);
	EXPECT_EQ(1.0f, At("R"));
	Asked.Alpha = EImportAlpha::Opaque;
	Import({"shot.exr"}, Asked);
	EXPECT_EQ(4.0f, At("R"));
	EXPECT_EQ(1.0f, At("A"));
}

TEST_F(ImportWhole, WhatIsHardlySoIsSaid)
{
	const double NaN = std::numeric_limits<double>::quiet_NaN();
	FPart Part = MakeUnrealFrame();
	Part.Channels = Join({MakeLayer("", "RGB", {0.5}), MakeLayer("FinalImageMovieRenderQueue_WorldDepth", "R", {3.5}),
		MakeLayer("FinalImageWorldNormal", "RGB", {0.1}), MakeLayer("FinalImageShadingModel", "RGB", {0.4}),
		MakeLayer("FinalImageMovieRenderQueue_MotionVectors", "RG", {30, 0})});
	Write("shot.exr", Part);
	const FImportResult Result = Import({"shot.exr"});
	EXPECT_TRUE(Tells(Result, 1094, "above 1"));
	EXPECT_TRUE(Tells(Result, 1094, "--unit m"));
	EXPECT_TRUE(Tells(Result, 1094, "not of length 1"));
	EXPECT_TRUE(Tells(Result, 1094, "not whole numbers"));
	EXPECT_TRUE(Tells(Result, 1094, "not around 0.5"));
	Part.Channels = Join({MakeLayer("", "RGB", {3}), {{"Z", Constant(NaN)}}});
	Write("shot.exr", Part);
	const FImportResult Broken = Import({"shot.exr"});
	EXPECT_TRUE(Tells(Broken, 1098, "12 depths are NaN"));
	EXPECT_TRUE(Tells(Broken, 1094, "empty everywhere"));
}

TEST_F(ImportWhole, OnePixelIsAFrame)
{
	FPart Part = MakeUnrealFrame();
	Part.Width = Part.Height = 1;
	Write("shot.exr", Part);
	Import({"shot.exr"});
	EXPECT_EQ(4.0f, At("R"));
	EXPECT_FLOAT_EQ(3.5f, At("depth.Z"));
}

TEST_F(ImportWhole, ADryRunWritesNothing)
{
	Write("shot.exr", MakeUnrealFrame());
	EXPECT_TRUE(Contains(Import({"shot.exr"}, {}, true).Report, "depth.Z"));
	EXPECT_FALSE(std::filesystem::exists(PathOf("scene.exr")));
	EXPECT_FALSE(std::filesystem::exists(PathOf("scene.json")));
}

TEST_F(ImportWhole, NothingOfTheUsersIsOverwritten)
{
	Write("shot.exr", MakeUnrealFrame());
	EXPECT_EQ(PathOf("scene.json"), Import({"shot.exr"}).Config);
	EXPECT_EQ(PathOf("scene.json"), Import({"shot.exr"}).Config); // its own, unchanged
	std::ofstream(PathOf("scene.json")) << "{}";
	const FImportResult Kept = Import({"shot.exr"});
	EXPECT_EQ("", Kept.Config);
	EXPECT_TRUE(Tells(Kept, 1097, "kept"));
	std::filesystem::copy_file(
		PathOf("shot.exr"), PathOf("scene.exr"), std::filesystem::copy_options::overwrite_existing);
	EXPECT_EQ("5030 3", ErrorOfImport({"shot.exr"}));
	EXPECT_EQ("5030 3", ErrorOfImport({"scene.exr"}));
}

TEST_F(ImportWhole, FramesOfASequence)
{
	for (const int Number : {7, 8})
	{
		FPart Part = MakeUnrealFrame();
		Part.Channels[4].Value = Constant(Number); // red of the frame before the tonemapper
		Write("shot.000" + std::to_string(Number) + ".exr", Part);
	}
	FImportOptions Options;
	Options.Inputs = {PathOf("shot.####.exr")};
	Options.OutputFile = PathOf("walk.####.exr");
	const FImportResult Result = ImportFrame(Options);
	EXPECT_EQ(2u, Result.Scenes.size());
	EXPECT_EQ(PathOf("walk.json"), Result.Config);
	EXPECT_EQ(7.0f, Read("walk.0007.exr", "R")[0]);
	EXPECT_EQ(8.0f, Read("walk.0008.exr", "R")[0]);

	Write("shot_depth.0007.exr", MakeUnrealFrame());
	Options.Inputs.push_back(PathOf("shot_depth.####.exr"));
	EXPECT_EQ("5031 3", ErrorOf([&] { ImportFrame(Options); })); // no frame 8
	Options.Inputs = {PathOf("shot.####.exr")};
	FPart Other = MakeUnrealFrame();
	Other.Channels.pop_back();
	Write("shot.0009.exr", Other);
	EXPECT_EQ("5031 3", ErrorOf([&] { ImportFrame(Options); })); // other layers
	Options.OutputFile = PathOf("walk.exr");
	EXPECT_EQ("1090 2", ErrorOf([&] { ImportFrame(Options); }));
	Options.Inputs = {PathOf("none.####.exr")};
	Options.OutputFile = PathOf("walk.####.exr");
	EXPECT_EQ("5031 3", ErrorOf([&] { ImportFrame(Options); }));
}

TEST_F(ImportWhole, DamagedFilesLeaveNothing)
{
	const std::string Path = Write("shot.exr", MakeUnrealFrame());
	std::ifstream Stream(Path, std::ios::binary);
	const std::string Bytes(std::istreambuf_iterator<char>(Stream), {});
	for (const double Part : {0.3, 0.6, 0.95})
	{
		std::ofstream(PathOf("cut.exr"), std::ios::binary)
			<< Bytes.substr(0, static_cast<size_t>(Part * static_cast<double>(Bytes.size())));
		EXPECT_TRUE(Contains(ErrorOfImport({"cut.exr"}), " 3")) << Part;
		EXPECT_FALSE(std::filesystem::exists(PathOf("scene.exr")));
	}
}
