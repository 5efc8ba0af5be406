// Makes the analytic sequences and writes them as scene files.
#include "Scenes/JitteredScenes.h"

#include "Picture/ImageFile.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace Drydock
{

namespace
{

constexpr double FarDepth = 20.0; // metres
constexpr double FrontDepth = 5.0;
constexpr int ToonModel = 8; // cloth, which marks toon shading here
constexpr int LitModel = 1;

FAnalyticShape MakeShape(std::vector<FVector2D> Corners, const FLinearColor& Color, double Depth, int Model)
{
	FAnalyticShape Shape;
	Shape.Corners = std::move(Corners);
	Shape.Color = Color;
	Shape.Depth = Depth;
	Shape.ShadingModel = Model;
	Shape.CustomMask = Model == ToonModel ? 1.0f : 0.0f;
	return Shape;
}

FAnalyticShape MakeBox(double Width, double Height, const FLinearColor& Color, double Depth, int Model = LitModel)
{
	const double X = 0.5 * Width;
	const double Y = 0.5 * Height;
	return MakeShape({{-X, -Y}, {X, -Y}, {X, Y}, {-X, Y}}, Color, Depth, Model);
}

FLinearColor Grey(float Light)
{
	return FLinearColor(Light, Light, Light, 1.0f);
}

FAnalyticFrame MakeEmpty(FIntPoint Size, float Light)
{
	FAnalyticFrame Frame;
	Frame.Size = Size;
	Frame.Background = MakeBox(1.0, 1.0, Grey(Light), FarDepth);
	return Frame;
}

void Place(FAnalyticShape& Shape, const FPose& Now, const FPose& Before)
{
	Shape.Pose = Now;
	Shape.PoseBefore = Before;
}

/** A line of 0.6 pixels, 32 times as bright as white paper, that turns by a degree a frame; a toon-shaded disc below.
 */
FAnalyticFrame MakeLine(FIntPoint Size, int Number)
{
	FAnalyticFrame Frame = MakeEmpty(Size, 0.05f);
	FAnalyticShape Line = MakeBox(0.8 * Size.GetMin(), 0.6, Grey(32.0f), FrontDepth);
	const FVector2D Center(0.4 * Size.X + 0.3, 0.5 * Size.Y + 0.2);
	constexpr double Degree = UE_DOUBLE_PI / 180.0;
	Place(Line, {Center, (12.0 + Number) * Degree}, {Center, (11.0 + Number) * Degree});
	std::vector<FVector2D> Corners;
	constexpr int NumCorners = 24;
	for (int Corner = 0; Corner < NumCorners; ++Corner)
	{
		const double Angle = 2.0 * UE_DOUBLE_PI * Corner / NumCorners;
		Corners.push_back(FVector2D(std::cos(Angle), std::sin(Angle)) * (0.16 * Size.GetMin()));
	}
	FAnalyticShape Disc = MakeShape(std::move(Corners), FLinearColor(2.0f, 1.6f, 1.2f, 1.0f), FrontDepth, ToonModel);
	const FPose Rest{FVector2D(0.8 * Size.X, 0.6 * Size.Y), 0.0};
	Place(Disc, Rest, Rest);
	Frame.Shapes = {Line, Disc};
	return Frame;
}

/** A point of 0.8 pixels, 400 times as bright as white paper, that moves by a tenth of a pixel a frame. */
FAnalyticFrame MakePoint(FIntPoint Size, int Number)
{
	FAnalyticFrame Frame = MakeEmpty(Size, 0.02f);
	FAnalyticShape Point = MakeBox(0.8, 0.8, Grey(400.0f), FrontDepth);
	const auto PoseOf = [&](int Of)
	{
		return FPose{FVector2D(0.5 * Size.X + 0.1 * Of, 0.5 * Size.Y + 0.25), 0.0};
	};
	Place(Point, PoseOf(Number), PoseOf(Number - 1));
	Frame.Shapes = {Point};
	return Frame;
}

/** A dark bar that moves by two pixels a frame and uncovers a checkerboard. */
FAnalyticFrame MakeOccluder(FIntPoint Size, int Number)
{
	FAnalyticFrame Frame = MakeEmpty(Size, 0.1f);
	FAnalyticShape Bar = MakeBox(0.2 * Size.X, 2.0 * Size.Y, Grey(0.01f), FrontDepth);
	const auto PoseOf = [&](int Of)
	{
		return FPose{FVector2D(0.25 * Size.X + 2.0 * Of, 0.5 * Size.Y), 0.1};
	};
	Place(Bar, PoseOf(Number), PoseOf(Number - 1));
	Frame.Shapes = {Bar};
	constexpr int Side = 10;
	for (int Y = 0; Y * Side < Size.Y; ++Y)
	{
		for (int X = Y % 2; X * Side < Size.X; X += 2)
		{
			FAnalyticShape Field = MakeBox(Side, Side, FLinearColor(1.0f, 0.8f, 0.6f, 1.0f), FarDepth);
			const FPose Rest{FVector2D((X + 0.5) * Side + 0.3, (Y + 0.5) * Side + 0.7), 0.0};
			Place(Field, Rest, Rest);
			Frame.Shapes.push_back(Field);
		}
	}
	return Frame;
}

/** Boxes at rest, turned so that no edge lies along the pixels. */
FAnalyticFrame MakeStill(FIntPoint Size, int)
{
	FAnalyticFrame Frame = MakeEmpty(Size, 0.2f);
	for (int Index = 0; Index < 3; ++Index)
	{
		FAnalyticShape Box = MakeBox(0.2 * Size.X, 0.35 * Size.Y, Grey(0.3f + 0.2f * static_cast<float>(Index)),
			FrontDepth + Index, Index == 1 ? ToonModel : LitModel);
		const FPose Rest{FVector2D((0.2 + 0.3 * Index) * Size.X, (0.35 + 0.15 * Index) * Size.Y), 0.17 + 0.4 * Index};
		Place(Box, Rest, Rest);
		Frame.Shapes.push_back(Box);
	}
	return Frame;
}

constexpr int GCutFrame = 8;

/** The boxes, and from the cut on the checkerboard. */
FAnalyticFrame MakeCut(FIntPoint Size, int Number)
{
	return Number < GCutFrame ? MakeStill(Size, Number) : MakeOccluder(Size, Number - GCutFrame);
}

double GetHalton(int Index, int Base)
{
	double Result = 0.0;
	double Digit = 1.0;
	for (int Rest = Index; Rest > 0; Rest /= Base)
	{
		Digit /= Base;
		Result += Digit * (Rest % Base);
	}
	return Result;
}

using FTexel = std::vector<double>;

const std::vector<std::string> GChannels = {"R", "G", "B", "A", "depth.Z", "velocity.X", "velocity.Y", "normal.X",
	"normal.Y", "normal.Z", "shadingmodel.ID", "basecolor.R", "basecolor.G", "basecolor.B", "custommask.B", "shadow.R",
	"shadow.G"};

FTexel MakeTexel(const FLinearColor& Color, const FAnalyticShape& Shape, FVector2D Movement)
{
	const auto ToDouble = [](float Value)
	{
		return static_cast<double>(Value);
	};
	// The velocities of a movement are stored in half floats where all of them are such: 1/256 pixel is fine enough.
	const auto Round = [](double Pixels)
	{
		return std::round(Pixels * 256.0) / 256.0;
	};
	return {ToDouble(Color.R), ToDouble(Color.G), ToDouble(Color.B), 1.0, Shape.Depth, Round(Movement.X),
		Round(Movement.Y), 0.0, 0.0, 1.0, static_cast<double>(Shape.ShadingModel),
		std::min(1.0, ToDouble(Shape.Color.R)), std::min(1.0, ToDouble(Shape.Color.G)),
		std::min(1.0, ToDouble(Shape.Color.B)), ToDouble(Shape.CustomMask), 1.0, 1.0};
}

/** bTruth: the exact mean of each pixel; else the sample that a camera with this jitter takes. */
FImage MakeImage(const FAnalyticFrame& Frame, FVector2D Jitter, bool bTruth)
{
	const FAnalyticPicture Picture(Frame);
	FImage Image{Frame.Size.X, Frame.Size.Y, static_cast<int>(GChannels.size()), {}};
	for (int Y = 0; Y < Frame.Size.Y; ++Y)
	{
		for (int X = 0; X < Frame.Size.X; ++X)
		{
			const FVector2D Point = FVector2D(X + 0.5, Y + 0.5) - Jitter;
			const FAnalyticShape& Shape = Picture.FindShape(Point);
			const FTexel Texel = MakeTexel(bTruth ? Picture.ComputeMean(X, Y) : Shape.Color, Shape,
				&Shape == &Frame.Background ? FVector2D(0.0, 0.0) : GetMovement(Shape, Point));
			Image.Values.insert(Image.Values.end(), Texel.begin(), Texel.end());
		}
	}
	return Image;
}

std::string MakeCameraJson(int Number, FVector2D Jitter, bool bCut)
{
	return fmt::format("{{\"frame\": {}, \"delta_time_s\": {}, \"position_uecm\": [0, 0, 150], "
					   "\"rotator_ue_deg\": {{\"pitch\": 0, \"yaw\": 0, \"roll\": 0}}, \"hfov_deg\": 60, "
					   "\"jitter_px\": [{}, {}], \"camera_cut\": {}}}",
		Number, 1.0 / 24.0, Jitter.X, Jitter.Y, bCut);
}

/** Configs of the two sequences; the truth needs no antialiasing. */
std::string MakeConfig(const std::string& Name, const FJitteredScene& Scene, bool bTruth)
{
	return fmt::format("// {}{}\n{{\n  \"scene\": {{ \"file\": \"{}.####.exr\", \"frames\": \"all\" }},\n"
					   "  \"view\": {{ \"exposure\": 0.5 }},\n  \"cvars\": {{ \"r.AntiAliasingMethod\": {} }}\n}}\n",
		Scene.Doc, bTruth ? ": the exact mean of each pixel." : ": one jittered sample a pixel.", Name, bTruth ? 0 : 2);
}

} // namespace

const std::vector<FJitteredScene>& GetJitteredScenes()
{
	static const std::vector<FJitteredScene> Scenes = {
		{"line", "A thin bright line turns; a toon-shaded disc rests", &MakeLine},
		{"point", "A bright point moves by a tenth of a pixel a frame", &MakePoint},
		{"occluder", "A dark bar moves and uncovers a checkerboard", &MakeOccluder},
		{"cut", "The camera cuts from boxes to a checkerboard", &MakeCut, GCutFrame},
		{"still", "Turned boxes at rest", &MakeStill},
	};
	return Scenes;
}

const FJitteredScene* FindJitteredScene(const std::string& Name)
{
	const auto& Scenes = GetJitteredScenes();
	const auto Found = std::ranges::find_if(Scenes, [&](const FJitteredScene& Scene) { return Scene.Name == Name; });
	return Found == Scenes.end() ? nullptr : &*Found;
}

FVector2D GetHaltonJitter(int Frame, int NumSamples)
{
	const int Index = Frame % NumSamples + 1;
	return NumSamples <= 1 ? FVector2D(0.0, 0.0) : FVector2D(GetHalton(Index, 2) - 0.5, GetHalton(Index, 3) - 0.5);
}

std::vector<std::string> WriteJitteredScene(const FJitteredSceneOptions& Options, const std::string& Folder)
{
	const FJitteredScene& Scene = *Options.Scene;
	std::vector<std::string> Names;
	for (const bool bTruth : {false, true})
	{
		const std::string Name = std::string(Scene.Name) + (bTruth ? ".truth" : "");
		Names.push_back(Name + ".json");
		WriteWholeFile((std::filesystem::path(Folder) / Names.back()).string(), MakeConfig(Name, Scene, bTruth));
		for (int Index = 0; Index < Options.NumFrames; ++Index)
		{
			const FVector2D Jitter = bTruth ? FVector2D(0.0, 0.0) : GetHaltonJitter(Index, Options.NumSamples);
			Names.push_back(fmt::format("{}.{:04}.exr", Name, Index + 1));
			WriteExr((std::filesystem::path(Folder) / Names.back()).string(),
				MakeImage(Scene.MakeFrame(Options.Size, Index), Jitter, bTruth), GChannels,
				{{"drydock:camera_json", MakeCameraJson(Index + 1, Jitter, Index == Scene.CutFrame)}});
		}
	}
	return Names;
}

} // namespace Drydock
