// The lens of depth of field: how far out of focus a depth is, and the form of a point that is. Source: engine file
// PostProcess/DiaphragmDOFUtils.cpp (the lens, its limits); the settings' tooltips, from memory (the blades).
#include "Lens/DiaphragmDOF.h"

#include "HAL/IConsoleManager.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace
{

TAutoConsoleVariable<float> CVarMaxForegroundRadius(TEXT("r.DOF.Kernel.MaxForegroundRadius"), 0.025f,
	TEXT("Largest blur before the focus, as a part of the view's width, at most 1 (0.025)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);
TAutoConsoleVariable<float> CVarMaxBackgroundRadius(TEXT("r.DOF.Kernel.MaxBackgroundRadius"), 0.025f,
	TEXT("Largest blur behind the focus, as a part of the view's width, at most 1 (0.025)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarEnableGatherBokehSettings(TEXT("r.DOF.Gather.EnableBokehSettings"), 1,
	TEXT("Form of the bokeh: 0 a disc, 1 that of the diaphragm's blades (default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

/** A corner's distance from the centre of Blades arcs of this radius that enclose the area of the disc of radius 1. */
double FindCircumscribedRadius(int32 Blades, double BladeRadius)
{
	const double HalfAngle = std::numbers::pi / Blades;
	const auto MeasureArea = [&](double Corner)
	{
		const double HalfAperture = std::asin(std::min(Corner * std::sin(HalfAngle) / BladeRadius, 1.0));
		const double Triangle = 0.5 * Corner * Corner * std::sin(2.0 * HalfAngle);
		return Blades * (Triangle + BladeRadius * BladeRadius * (HalfAperture - 0.5 * std::sin(2.0 * HalfAperture)));
	};
	double Least = 1.0;
	double Most = std::sqrt(2.0 * HalfAngle / std::sin(2.0 * HalfAngle)); // of straight sides
	for (int32 Step = 0; Step < 60; ++Step)
	{
		const double Middle = 0.5 * (Least + Most);
		(MeasureArea(Middle) < std::numbers::pi ? Least : Most) = Middle;
	}
	return 0.5 * (Least + Most);
}

} // namespace

namespace DiaphragmDOF
{

FPhysicalCocModel FPhysicalCocModel::Compile(
	const FFinalPostProcessSettings& Settings, int32 ViewWidth, float CotHalfFov)
{
	constexpr float MillimetresPerCentimetre = 10.0f;
	constexpr float CentimetresPerKilometre = 100000.0f;
	const float Width = static_cast<float>(ViewWidth);
	const float SensorWidth = Settings.DepthOfFieldSensorWidth;
	const float FocalLength = 0.5f * SensorWidth * CotHalfFov;
	const float Aperture = FocalLength / Settings.DepthOfFieldFstop;
	const float Focus = MillimetresPerCentimetre * Settings.DepthOfFieldFocalDistance;

	FPhysicalCocModel Model;
	Model.FocusDistance = Settings.DepthOfFieldFocalDistance;
	// A lens cannot focus nearer than its focal length.
	const float Diameter = Focus > FocalLength ? Aperture * FocalLength / (Focus - FocalLength) : 0.0f;
	const float InfinityRadius = 0.5f * Diameter / SensorWidth * Width;
	// Any larger one is cut to the largest blur but in the plane of focus, where it would not be a number.
	Model.InfinityRadius = InfinityRadius > 0.0f ? FMath::Min(InfinityRadius, 1e6f * Width) : 0.0f;
	Model.MaxForegroundRadius = FMath::Clamp(CVarMaxForegroundRadius.GetValueOnRenderThread(), 0.0f, 1.0f) * Width;
	Model.MaxBackgroundRadius = FMath::Clamp(CVarMaxBackgroundRadius.GetValueOnRenderThread(), 0.0f, 1.0f) * Width;
	Model.DepthBlurRadius = FMath::Min(FMath::Max(Settings.DepthOfFieldDepthBlurRadius, 0.0f) * Width / 1920.0f, Width);
	Model.DepthBlurHalfDepth = FMath::Max(Settings.DepthOfFieldDepthBlurAmount * CentimetresPerKilometre, 1.0f);
	return Model;
}

float FPhysicalCocModel::DepthToCocRadius(float Depth) const
{
	if (!(Depth > 0.0f) || !std::isfinite(Depth))
	{
		return 0.0f;
	}
	const float Lens =
		FMath::Clamp(InfinityRadius * (1.0f - FocusDistance / Depth), -MaxForegroundRadius, MaxBackgroundRadius);
	const float Air = DepthBlurRadius * (1.0f - std::exp2(-Depth / DepthBlurHalfDepth));
	return Depth > FocusDistance ? FMath::Max(Lens, Air) : Lens;
}

bool IsEnabled(const FFinalPostProcessSettings& Settings)
{
	return Settings.DepthOfFieldFocalDistance > 0.0f && Settings.DepthOfFieldFstop > 0.0f &&
		   Settings.DepthOfFieldSensorWidth > 0.0f;
}

FBokehModel FBokehModel::Compile(const FFinalPostProcessSettings& Settings)
{
	FBokehModel Model;
	const double Fstop = Settings.DepthOfFieldFstop;
	const double MinFstop = std::max(static_cast<double>(Settings.DepthOfFieldMinFstop), 0.0);
	if (!(Fstop > MinFstop) || CVarEnableGatherBokehSettings.GetValueOnRenderThread() == 0)
	{
		return Model;
	}
	Model.DiaphragmBladeCount = FMath::Clamp(Settings.DepthOfFieldBladeCount, 4, 16);
	const double HalfAngle = std::numbers::pi / Model.DiaphragmBladeCount;
	if (MinFstop > 0.0)
	{
		// Beyond this the arcs are straight to the last digit.
		Model.BokehShape = EBokehShape::RoundedBlades;
		Model.DiaphragmBladeRadius = std::min(Fstop / MinFstop, 1e4);
		Model.CocRadiusToCircumscribedRadius =
			FindCircumscribedRadius(Model.DiaphragmBladeCount, Model.DiaphragmBladeRadius);
	}
	else
	{
		Model.BokehShape = EBokehShape::StraightBlades;
		Model.CocRadiusToCircumscribedRadius = std::sqrt(2.0 * HalfAngle / std::sin(2.0 * HalfAngle));
	}
	Model.CocRadiusToIncircleRadius = 1.0 / Model.MeasureDistance(std::sin(HalfAngle), std::cos(HalfAngle));
	return Model;
}

double FBokehModel::MeasureDistance(double X, double Y) const
{
	const double Distance = std::hypot(X, Y);
	if (BokehShape == EBokehShape::Circle)
	{
		return Distance;
	}
	const double HalfAngle = std::numbers::pi / DiaphragmBladeCount;
	// From the middle of the nearest side.
	const double Angle = std::abs(std::fmod(std::abs(std::atan2(X, Y)), 2.0 * HalfAngle) - HalfAngle);
	const double ToSide = CocRadiusToCircumscribedRadius * std::cos(HalfAngle);
	if (BokehShape == EBokehShape::StraightBlades)
	{
		return Distance * std::cos(Angle) / ToSide;
	}
	// An arc's centre lies beyond that of the bokeh.
	const double HalfSide = CocRadiusToCircumscribedRadius * std::sin(HalfAngle);
	const double Radius = DiaphragmBladeRadius;
	const double ToCentre = std::sqrt(Radius * Radius - HalfSide * HalfSide) - ToSide;
	const double Across = ToCentre * std::sin(Angle);
	return Distance / (std::sqrt(Radius * Radius - Across * Across) - ToCentre * std::cos(Angle));
}

} // namespace DiaphragmDOF
