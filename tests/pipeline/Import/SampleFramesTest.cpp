// The frames of configs/frames: a shipped scene, encoded as Unreal and Blender would write it, made here in double.
// With DRYDOCK_BLESS=1 they are written anew. Imported again, they are the scene.
#include "pipeline/Import/ImportTestUtils.h"

#include "Import/Import.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace Drydock;
using namespace ImportTest;

namespace
{

constexpr int Step = 4; // of the scene's pixels, each way
constexpr int Width = 240;
constexpr int Height = 135;
const std::string Frames = DRYDOCK_TEST_SOURCE_DIR "/configs/frames/";

/** The scene at a quarter of its size: colour is the mean of a block, all else its middle. */
class FQuarter
{
public:
	FQuarter()
		: File(DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/toon_character.exr")
	{
		for (const std::string& Name : File.GetChannels())
		{
			Planes[Name] = File.Read({File.FindChannel(Name)})[0];
		}
	}

	double Get(const std::string& Channel, int X, int Y) const
	{
		return static_cast<double>(Planes.at(Channel)[At(X * Step + Step / 2, Y * Step + Step / 2)]);
	}

	double GetMean(const std::string& Channel, int X, int Y) const
	{
		double Sum = 0.0;
		for (int J = 0; J < Step; ++J)
		{
			for (int I = 0; I < Step; ++I)
			{
				Sum += static_cast<double>(Planes.at(Channel)[At(X * Step + I, Y * Step + J)]);
			}
		}
		return static_cast<double>(static_cast<float>(half(static_cast<float>(Sum / (Step * Step)))));
	}

	FValue Of(const std::string& Channel, double Scale = 1.0, double Offset = 0.0) const
	{
		return [this, Channel, Scale, Offset](int X, int Y)
		{
			return Get(Channel, X, Y) * Scale + Offset;
		};
	}

	FValue MeanOf(const std::string& Channel) const
	{
		return [this, Channel](int X, int Y)
		{
			return GetMean(Channel, X, Y);
		};
	}

private:
	size_t At(int X, int Y) const
	{
		return static_cast<size_t>(Y) * static_cast<size_t>(File.GetWidth()) + static_cast<size_t>(X);
	}

	FImageFile File;
	std::map<std::string, std::vector<float>> Planes;
};

const FQuarter& GetScene()
{
	static const FQuarter Scene;
	return Scene;
}

const OIIO::TypeDesc Half = OIIO::TypeDesc::HALF;
const OIIO::TypeDesc Float = OIIO::TypeDesc::FLOAT;

FValue Clamped(const FValue& Value)
{
	return [Value](int X, int Y)
	{
		return std::min(Value(X, Y), 1.0);
	};
}

/** Movie render queue, one camera: the names of docs/your-frame.md. */
FPart MakeUnrealFrame()
{
	const FQuarter& Scene = GetScene();
	FPart Part;
	Part.Width = Width;
	Part.Height = Height;
	const std::string Depth = "FinalImageMovieRenderQueue_WorldDepth.";
	const std::string Motion = "FinalImageMovieRenderQueue_MotionVectors.";
	const auto Stencil = [&Scene](int X, int Y)
	{
		return Scene.Get("custommask.B", X, Y) == 0.5 ? 1.0 : 0.0;
	};
	const auto CustomDepth = [&Scene, Stencil](int X, int Y)
	{
		return Stencil(X, Y) > 0.0 ? 100.0 * Scene.Get("depth.Z", X, Y) : 1e8;
	};
	Part.Channels = {{"R", Clamped(Scene.MeanOf("R")), Half}, {"G", Clamped(Scene.MeanOf("G")), Half},
		{"B", Clamped(Scene.MeanOf("B")), Half}, {"A", Constant(0), Half},
		{"FinalImagePreTonemapHDRColor.R", Scene.MeanOf("R"), Half},
		{"FinalImagePreTonemapHDRColor.G", Scene.MeanOf("G"), Half},
		{"FinalImagePreTonemapHDRColor.B", Scene.MeanOf("B"), Half}, {Depth + "R", Scene.Of("depth.Z", 100.0), Float},
		{Motion + "R", Scene.Of("velocity.X", 0.5 / (4 * Width), 0.5), Float},
		{Motion + "G", Scene.Of("velocity.Y", -0.5 / (4 * Height), 0.5), Float},
		{"FinalImageWorldNormal.R", Scene.Of("normal.X", 0.5, 0.5), Half},
		{"FinalImageWorldNormal.G", Scene.Of("normal.Y", -0.5, 0.5), Half},
		{"FinalImageWorldNormal.B", Scene.Of("normal.Z", 0.5, 0.5), Half},
		{"FinalImageBaseColor.R", Scene.Of("basecolor.R"), Half},
		{"FinalImageBaseColor.G", Scene.Of("basecolor.G"), Half},
		{"FinalImageBaseColor.B", Scene.Of("basecolor.B"), Half},
		{"FinalImageDrydockIds.R", Scene.Of("shadingmodel.ID"), Float}, {"FinalImageDrydockIds.G", Stencil, Float},
		{"FinalImageDrydockIds.B", CustomDepth, Float}};
	// Of the scene's camera, in its own words.
	Part.Attributes = {{"unreal/camera/curPos/x", "25"}, {"unreal/camera/curPos/y", "470"},
		{"unreal/camera/curPos/z", "135"}, {"unreal/camera/curRot/pitch", "-1.584"},
		{"unreal/camera/curRot/yaw", "-91.584"}, {"unreal/camera/curRot/roll", "0"},
		{"unreal/camera/FinalImage/fov", "53.130"}, {"unreal/frameRate", "24"}};
	return Part;
}

constexpr uint32_t CharacterId = 0x3f2a6c51; // any two that are finite numbers
constexpr uint32_t RoomId = 0xbe91d0e4;

FPart MakeBlenderFrame()
{
	const FQuarter& Scene = GetScene();
	FPart Part;
	Part.Width = Width;
	Part.Height = Height;
	const auto Id = [&Scene](int X, int Y)
	{
		const uint32_t Bits = Scene.Get("shadingmodel.ID", X, Y) == 8.0 ? CharacterId : RoomId;
		float Value = 0.0f;
		std::memcpy(&Value, &Bits, sizeof(Value));
		return static_cast<double>(Value);
	};
	const std::string View = "ViewLayer.";
	Part.Channels = {{View + "Combined.R", Scene.MeanOf("R"), Half}, {View + "Combined.G", Scene.MeanOf("G"), Half},
		{View + "Combined.B", Scene.MeanOf("B"), Half}, {View + "Combined.A", Constant(1), Half},
		{View + "Depth.Z", Scene.Of("depth.Z"), Float}, {View + "Normal.X", Scene.Of("normal.X"), Float},
		{View + "Normal.Y", Scene.Of("normal.Y"), Float}, {View + "Normal.Z", Scene.Of("normal.Z"), Float},
		// To where it was, y up: the way back is left of what moves right, and above what moves down.
		{View + "Vector.X", Scene.Of("velocity.X", -0.25), Float},
		{View + "Vector.Y", Scene.Of("velocity.Y", 0.25), Float}, {View + "Vector.Z", Constant(0), Float},
		{View + "Vector.W", Constant(0), Float}, {View + "DiffCol.R", Scene.Of("basecolor.R"), Half},
		{View + "DiffCol.G", Scene.Of("basecolor.G"), Half}, {View + "DiffCol.B", Scene.Of("basecolor.B"), Half},
		{View + "CryptoObject00.r", Id, Float}, {View + "CryptoObject00.g", Constant(1), Float},
		{View + "CryptoObject00.b", Constant(0), Float}, {View + "CryptoObject00.a", Constant(0), Float}};
	Part.Attributes = {{"BlenderMultiChannel", "Blender V2.55.1 and newer"},
		{"cryptomatte/c8f7b5f/name", "ViewLayer.CryptoObject"}, {"cryptomatte/c8f7b5f/hash", "MurmurHash3_32"},
		{"cryptomatte/c8f7b5f/conversion", "uint32_to_float32"},
		{"cryptomatte/c8f7b5f/manifest", R"({"Character":"3f2a6c51","Room":"be91d0e4"})"}};
	return Part;
}

bool IsBlessed()
{
	return std::getenv("DRYDOCK_BLESS") != nullptr;
}

class SampleFrames : public FImportFolder
{
protected:
	/** Whether the shipped file holds what is made here, to the bit. */
	void ExpectShipped(const std::string& Name, const FPart& Part) const
	{
		if (IsBlessed())
		{
			WriteParts(Frames + Name, {Part});
		}
		FImageFile File(Frames + Name);
		ASSERT_EQ(Width, File.GetWidth());
		for (const FChannel& Channel : Part.Channels)
		{
			const std::vector<float> Plane = File.Read({File.FindChannel(Channel.Name)})[0];
			size_t NumOff = 0;
			for (size_t Pixel = 0; Pixel < Plane.size(); ++Pixel)
			{
				const float Value =
					static_cast<float>(Channel.Value(static_cast<int>(Pixel) % Width, static_cast<int>(Pixel) / Width));
				NumOff += Plane[Pixel] == (Channel.Type == Half ? static_cast<float>(half(Value)) : Value) ? 0 : 1;
			}
			EXPECT_EQ(0u, NumOff) << Channel.Name;
		}
	}

	void Import(const std::string& Name, const FImportAsked& Asked = {}) const
	{
		FImportOptions Options;
		Options.Inputs = {Frames + Name};
		Options.OutputFile = PathOf("scene.exr");
		Options.Asked = Asked;
		for (const FDiagnostic& Diagnostic : ImportFrame(Options).Diagnostics)
		{
			EXPECT_NE(1094, Diagnostic.Code) << Diagnostic.Message; // nothing implausible
		}
	}

	void ExpectChannel(const std::string& Channel, const FValue& Expected, double Tolerance) const
	{
		const std::vector<float> Plane = Read("scene.exr", Channel);
		double Worst = 0.0;
		for (size_t Pixel = 0; Pixel < Plane.size(); ++Pixel)
		{
			const double Value = Expected(static_cast<int>(Pixel) % Width, static_cast<int>(Pixel) / Width);
			const double Off = std::abs(static_cast<double>(Plane[Pixel]) - Value);
			Worst = Off <= Worst ? Worst : Off;
		}
		EXPECT_LE(Worst, Tolerance) << Channel;
	}

	void ExpectScene(double NormalTolerance) const
	{
		const FQuarter& Scene = GetScene();
		for (const char* const Channel : {"R", "G", "B"})
		{
			ExpectChannel(Channel, Scene.MeanOf(Channel), 0.0);
		}
		ExpectChannel("depth.Z", Scene.Of("depth.Z"), 1e-5);
		for (const char* const Channel : {"normal.X", "normal.Y", "normal.Z"})
		{
			ExpectChannel(Channel, Scene.Of(Channel), NormalTolerance);
		}
		for (const char* const Channel : {"velocity.X", "velocity.Y"})
		{
			ExpectChannel(Channel, Scene.Of(Channel, 1.0 / Step), 1e-4); // a quarter of the pixels
		}
		for (const char* const Channel : {"basecolor.R", "basecolor.G", "basecolor.B"})
		{
			ExpectChannel(Channel, Scene.Of(Channel), 0.0);
		}
	}
};

} // namespace

TEST_F(SampleFrames, AreWhatTheySay)
{
	ExpectShipped("unreal.exr", MakeUnrealFrame());
	ExpectShipped("blender.exr", MakeBlenderFrame());
}

TEST_F(SampleFrames, OfUnrealIsTheSceneAgain)
{
	Import("unreal.exr");
	ExpectScene(2e-3); // halves from 0 to 1, and the length set to 1 again
	ExpectChannel("shadingmodel.ID", GetScene().Of("shadingmodel.ID"), 0.0);
	ExpectChannel(
		"customstencil.ID", [](int X, int Y) { return GetScene().Get("custommask.B", X, Y) == 0.5 ? 1.0 : 0.0; }, 0.0);
	ExpectChannel(
		"customdepth.Z",
		[](int X, int Y)
		{ return GetScene().Get("custommask.B", X, Y) == 0.5 ? GetScene().Get("depth.Z", X, Y) : 0.0; },
		1e-5);
}

TEST_F(SampleFrames, OfBlenderIsTheSceneAgain)
{
	FImportAsked Asked;
	Asked.Toon = {"Character"};
	Import("blender.exr", Asked);
	ExpectScene(0.0);
	ExpectChannel(
		"shadingmodel.ID", [](int X, int Y) { return GetScene().Get("shadingmodel.ID", X, Y) == 8.0 ? 8.0 : 1.0; },
		0.0);
}
