// The exact mean of a pixel against 4,096 samples, the jitter's sequence, and movements against the poses.
#include "Scenes/JitteredScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace Drydock;

namespace
{

/** The mean of Side x Side samples on a grid. */
double SampleMean(const FAnalyticPicture& Picture, int X, int Y, int Side)
{
	double Sum = 0.0;
	for (int Index = 0; Index < Side * Side; ++Index)
	{
		const FVector2D Point(X + (Index % Side + 0.5) / Side, Y + (Index / Side + 0.5) / Side);
		Sum += static_cast<double>(Picture.FindShape(Point).Color.R);
	}
	return Sum / (Side * Side);
}

} // namespace

TEST(AnalyticScene, APixelsMeanIsThatOf4096Samples)
{
	for (const FJitteredScene& Scene : GetJitteredScenes())
	{
		const FAnalyticFrame Frame = Scene.MakeFrame(FIntPoint(48, 27), 5);
		const FAnalyticPicture Picture(Frame);
		double Brightest = static_cast<double>(Frame.Background.Color.R);
		for (const FAnalyticShape& Shape : Frame.Shapes)
		{
			Brightest = std::max(Brightest, static_cast<double>(Shape.Color.R));
		}
		for (int Y = 0; Y < Frame.Size.Y; Y += 4)
		{
			for (int X = 0; X < Frame.Size.X; X += 2)
			{
				// An edge misses a grid of 64 x 64 by less than its length in cells: a 40th of the pixel at most here.
				EXPECT_NEAR(
					SampleMean(Picture, X, Y, 64), static_cast<double>(Picture.ComputeMean(X, Y).R), 0.025 * Brightest)
					<< Scene.Name << " " << X << "," << Y;
			}
		}
	}
}

TEST(AnalyticScene, AreasOfAKnownPixelAreExact)
{
	FAnalyticFrame Frame;
	Frame.Size = FIntPoint(4, 4);
	Frame.Background.Color = FLinearColor(1.0f, 0.0f, 0.0f, 1.0f);
	FAnalyticShape Half;
	Half.Corners = {{-8, -8}, {8, -8}, {8, 8}};
	Half.Pose.Center = FVector2D(0.0, 0.0); // its long edge is the diagonal of the pixels
	Half.Color = FLinearColor(0.0f, 1.0f, 0.0f, 1.0f);
	FAnalyticShape Quarter;
	Quarter.Corners = {{0, 0}, {0, 0.5}, {0.5, 0.5}, {0.5, 0}};
	Quarter.Pose.Center = FVector2D(2.0, 2.0);
	Quarter.Color = FLinearColor(0.0f, 0.0f, 1.0f, 1.0f);
	Frame.Shapes = {Quarter, Half};
	const FLinearColor Mean = FAnalyticPicture(Frame).ComputeMean(2, 2);
	EXPECT_NEAR(0.25f, Mean.B, 1e-6f);
	EXPECT_NEAR(0.375f, Mean.G, 1e-6f);
	EXPECT_NEAR(0.375f, Mean.R, 1e-6f);
}

TEST(AnalyticScene, MovementLeadsBackToTheFrameBefore)
{
	for (const FJitteredScene& Scene : GetJitteredScenes())
	{
		const FIntPoint Size(64, 36);
		const FAnalyticFrame Before = Scene.MakeFrame(Size, 4), Now = Scene.MakeFrame(Size, 5);
		for (size_t Index = 0; Index < Now.Shapes.size(); ++Index)
		{
			const FAnalyticShape& Shape = Now.Shapes[Index];
			EXPECT_EQ(Before.Shapes[Index].Pose.Center, Shape.PoseBefore.Center) << Scene.Name;
			EXPECT_NEAR(Before.Shapes[Index].Pose.Angle, Shape.PoseBefore.Angle, 1e-12) << Scene.Name;
			// A corner now, less its movement, is the same corner before.
			const auto Placed = [](const FPose& Pose, FVector2D Corner)
			{
				return Pose.Center + FVector2D(Corner.X * std::cos(Pose.Angle) - Corner.Y * std::sin(Pose.Angle),
										 Corner.X * std::sin(Pose.Angle) + Corner.Y * std::cos(Pose.Angle));
			};
			const FVector2D Point = Placed(Shape.Pose, Shape.Corners[1]);
			const FVector2D Expected = Placed(Shape.PoseBefore, Shape.Corners[1]);
			EXPECT_NEAR(Expected.X, Point.X - GetMovement(Shape, Point).X, 1e-9) << Scene.Name;
			EXPECT_NEAR(Expected.Y, Point.Y - GetMovement(Shape, Point).Y, 1e-9) << Scene.Name;
		}
	}
}

TEST(AnalyticScene, TheJitterIsHaltonsSequence)
{
	const FVector2D First = GetHaltonJitter(0, 8), Second = GetHaltonJitter(1, 8);
	EXPECT_NEAR(0.0, First.X, 1e-12);
	EXPECT_NEAR(1.0 / 3.0 - 0.5, First.Y, 1e-12);
	EXPECT_NEAR(-0.25, Second.X, 1e-12);
	EXPECT_NEAR(2.0 / 3.0 - 0.5, Second.Y, 1e-12);
	EXPECT_EQ(First, GetHaltonJitter(8, 8));
	EXPECT_EQ(FVector2D(0.0, 0.0), GetHaltonJitter(3, 1));
	std::set<double> Places;
	for (int Frame = 0; Frame < 64; ++Frame)
	{
		Places.insert(GetHaltonJitter(Frame, 64).X);
	}
	EXPECT_EQ(64u, Places.size());
}
