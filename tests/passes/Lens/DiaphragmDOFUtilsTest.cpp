// The lens by its formula: circles of confusion, and the form of the opening.
#include "DiaphragmDOFTestUtils.h"

#include <random>
#include <tuple>

using namespace PassTest;
using DiaphragmDOF::EBokehShape;
using DiaphragmDOF::FBokehModel;
using DiaphragmDOF::FPhysicalCocModel;

TEST(PhysicalCocModel, LensFollowsTheThinLensFormula)
{
	// f = 12 mm, A = 12 mm, focus 1012 mm: A f / (F - f) = 144 / 1000 = 0.144 mm of diameter at infinity; of 24 mm over
	// 1000 pixels that is 6 pixels, 3 of radius.
	const FPhysicalCocModel Model = FPhysicalCocModel::Compile(MakeLens(), 1000, 1.0f);
	EXPECT_NEAR(3.0, Model.InfinityRadius, 1e-5);
	EXPECT_EQ(0.0f, Model.DepthToCocRadius(101.2f));
	EXPECT_NEAR(1.5, Model.DepthToCocRadius(202.4f), 1e-5);
	EXPECT_NEAR(-3.0, Model.DepthToCocRadius(50.6f), 1e-5);
}

TEST(PhysicalCocModel, StopFocalLengthAndSensorActAsInALens)
{
	FFinalPostProcessSettings Settings = MakeLens();
	Settings.DepthOfFieldFstop = 4.0f;
	EXPECT_NEAR(0.75, FPhysicalCocModel::Compile(Settings, 1000, 1.0f).InfinityRadius, 1e-5);
	// Twice the focal length, 24 mm: A f / (F - f) = 24 * 24 / 988 mm, of 24 mm: 0.024291 of the width.
	EXPECT_NEAR(1000 * 24.0 / 988 / 2, FPhysicalCocModel::Compile(MakeLens(), 1000, 2.0f).InfinityRadius, 1e-4);
}

TEST(PhysicalCocModel, RadiusIsLimitedOnBothSides)
{
	FPhysicalCocModel Model = FPhysicalCocModel::Compile(MakeLens(), 1000, 1.0f);
	Model.MaxBackgroundRadius = 1.0f;
	Model.MaxForegroundRadius = 2.0f;
	EXPECT_EQ(1.0f, Model.DepthToCocRadius(1e6f));
	EXPECT_EQ(-2.0f, Model.DepthToCocRadius(1.0f));
}

TEST(PhysicalCocModel, NoLensGivesARadiusThatIsNoNumberOrWiderThanTheView)
{
	const float Extremes[] = {1e-40f, 1e-20f, 1.0f, 1e9f, 1e20f, 3e38f};
	const FScopedConsoleVariable Foreground(TEXT("r.DOF.Kernel.MaxForegroundRadius"), 1e9f);
	const FScopedConsoleVariable Background(TEXT("r.DOF.Kernel.MaxBackgroundRadius"), 3e38f);
	for (const float Fstop : Extremes)
	{
		for (const float SensorWidth : Extremes)
		{
			for (const float FocalDistance : Extremes)
			{
				FFinalPostProcessSettings Settings;
				Settings.DepthOfFieldFstop = Fstop;
				Settings.DepthOfFieldSensorWidth = SensorWidth;
				Settings.DepthOfFieldFocalDistance = FocalDistance;
				Settings.DepthOfFieldDepthBlurRadius = Fstop;
				const FPhysicalCocModel Model = FPhysicalCocModel::Compile(Settings, 1000, 1.0f);
				for (const float Depth : {1e-30f, 1.0f, FocalDistance, 1e9f, 3e38f})
				{
					EXPECT_GE(1000.0f, std::abs(Model.DepthToCocRadius(Depth)))
						<< Fstop << " " << SensorWidth << " " << FocalDistance << " " << Depth;
				}
			}
		}
	}
}

TEST(PhysicalCocModel, TheAirBlursTheDistance)
{
	FFinalPostProcessSettings Settings = MakeLens();
	Settings.DepthOfFieldFstop = 1e6f;
	Settings.DepthOfFieldDepthBlurRadius = 4.0f;
	Settings.DepthOfFieldDepthBlurAmount = 0.5f; // km
	const FPhysicalCocModel Model = FPhysicalCocModel::Compile(Settings, 960, 1.0f);
	EXPECT_NEAR(1.0, Model.DepthToCocRadius(50000.0f), 1e-5); // half of 4 pixels at 1920 wide
	EXPECT_NEAR(2.0, Model.DepthToCocRadius(5e6f), 1e-4);
}

TEST(PhysicalCocModel, DepthsThatAreNoneAreInFocus)
{
	const FPhysicalCocModel Model = FPhysicalCocModel::Compile(MakeLens(), 1000, 1.0f);
	for (const double Depth : {NaN, Infinity, 0.0, -5.0})
	{
		EXPECT_EQ(0.0f, Model.DepthToCocRadius(static_cast<float>(Depth))) << Depth;
	}
}

TEST(BokehModel, IsADiscWhereTheLensIsWideOpen)
{
	for (const float Fstop : {0.5f, 1.2f})
	{
		const FBokehModel Model = MakeBokeh(Fstop, 1.2f, 5);
		EXPECT_EQ(EBokehShape::Circle, Model.BokehShape);
		EXPECT_DOUBLE_EQ(5.0, Model.MeasureDistance(3.0, -4.0));
	}
	const FScopedConsoleVariable Off(TEXT("r.DOF.Gather.EnableBokehSettings"), 0);
	EXPECT_EQ(EBokehShape::Circle, MakeBokeh(4.0f, 1.2f, 5).BokehShape);
}

TEST(BokehModel, IsARegularPolygonOfTheDiscsAreaWhereBladesAreStraight)
{
	for (const int Blades : {4, 5, 6, 9, 16})
	{
		const FBokehModel Model = MakeBokeh(2.0f, 0.0f, Blades);
		EXPECT_EQ(EBokehShape::StraightBlades, Model.BokehShape);
		const double Angle = 2 * FOpening::Pi / Blades;
		// Blades triangles of two sides R and the angle between them.
		const double Corner = std::sqrt(FOpening::Pi / (Blades * std::sin(Angle) / 2));
		EXPECT_NEAR(Corner, Model.CocRadiusToCircumscribedRadius, 1e-12);
		EXPECT_NEAR(Corner * std::cos(Angle / 2), Model.CocRadiusToIncircleRadius, 1e-12);
		EXPECT_NEAR(1.0, Model.MeasureDistance(0.0, Corner), 1e-12);
		EXPECT_NEAR(1.0, Model.MeasureDistance(Corner * std::sin(Angle), Corner * std::cos(Angle)), 1e-12);
	}
	EXPECT_EQ(4, MakeBokeh(2.0f, 0.0f, 1).DiaphragmBladeCount);
	EXPECT_EQ(16, MakeBokeh(2.0f, 0.0f, 99).DiaphragmBladeCount);
}

TEST(BokehModel, BladesBendAsTheEdgeOfTheOpenLens)
{
	std::mt19937 Random(3);
	std::uniform_real_distribution<double> Angle(0, 2 * FOpening::Pi);
	for (const auto& [Fstop, MinFstop, Blades] : {std::tuple(4.0f, 1.2f, 5), {2.0f, 1.8f, 6}, {16.0f, 2.0f, 9}})
	{
		const FBokehModel Model = MakeBokeh(Fstop, MinFstop, Blades);
		EXPECT_EQ(EBokehShape::RoundedBlades, Model.BokehShape);
		const FOpening Opening(Blades, Fstop / static_cast<double>(MinFstop));
		EXPECT_NEAR(Opening.Corner, Model.CocRadiusToCircumscribedRadius, 1e-4);
		for (int Case = 0; Case < 20; ++Case)
		{
			const double At = Angle(Random), Edge = Opening.Edge(At);
			EXPECT_NEAR(1.0, Model.MeasureDistance(Edge * std::sin(At), Edge * std::cos(At)), 2e-4) << At;
		}
	}
}
