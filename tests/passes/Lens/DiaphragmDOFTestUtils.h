// A lens that is easy to reckon with, and the opening that its blades leave, by geometry: for tests of depth of field.
#pragma once

#include "PassTestUtils.h"

#include "Lens/DiaphragmDOF.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace PassTest
{

/** 24 mm of sensor, a field of view of 90 degrees: focal length 12 mm. */
inline FFinalPostProcessSettings MakeLens()
{
	FFinalPostProcessSettings Settings;
	Settings.DepthOfFieldSensorWidth = 24.0f;
	Settings.DepthOfFieldFstop = 1.0f;
	Settings.DepthOfFieldFocalDistance = 101.2f;
	Settings.DepthOfFieldDepthBlurRadius = 0.0f;
	return Settings;
}

/** The opening by its geometry: the points within all of as many discs as there are blades, whose edges pass through
 * neighbouring corners; of the area of the disc of radius 1. A corner points along +y. */
struct FOpening
{
	int Blades = 0;
	double BladeRadius = 0;
	double Corner = 1;

	FOpening(int InBlades, double InBladeRadius)
		: Blades(InBlades)
		, BladeRadius(InBladeRadius)
	{
		// At most that of straight sides.
		double Least = 1, Most = std::sqrt(2 * Pi / (Blades * std::sin(2 * Pi / Blades)));
		for (int Step = 0; Step < 40; ++Step)
		{
			Corner = (Least + Most) / 2;
			(Mean([](double, double) { return 1.0; }) < Pi ? Least : Most) = Corner;
		}
	}

	/** Distance of the edge at an angle from +y. */
	double Edge(double Angle) const
	{
		double Nearest = 10;
		for (int Blade = 0; Blade < Blades; ++Blade)
		{
			// Seen along the blade's middle: the disc's centre lies behind, at Y = -Behind.
			const double Half = Pi / Blades, Middle = (2 * Blade + 1) * Half;
			const double Behind =
				std::sqrt(BladeRadius * BladeRadius - std::pow(Corner * std::sin(Half), 2)) - Corner * std::cos(Half);
			const double B = Behind * std::cos(Angle - Middle);
			Nearest = std::min(Nearest, -B + std::sqrt(B * B + BladeRadius * BladeRadius - Behind * Behind));
		}
		return Nearest;
	}

	/** Integral over the opening of what depends on the distance squared and the angle. */
	double Mean(const std::function<double(double, double)>& Value) const
	{
		constexpr int Angles = 720, Rings = 20;
		double Sum = 0;
		for (int Index = 0; Index < Angles; ++Index)
		{
			const double Angle = 2 * Pi * (Index + 0.5) / Angles, Most = Edge(Angle);
			for (int Ring = 0; Ring < Rings; ++Ring)
			{
				// Rings of equal area.
				const double Square = Most * Most * (Ring + 0.5) / Rings;
				Sum += Value(Square, Angle) * Most * Most / 2 / Rings * 2 * Pi / Angles;
			}
		}
		return Sum;
	}

	static constexpr double Pi = 3.14159265358979324;
};

inline DiaphragmDOF::FBokehModel MakeBokeh(float Fstop, float MinFstop, int32 Blades)
{
	FFinalPostProcessSettings Settings = MakeLens();
	Settings.DepthOfFieldFstop = Fstop;
	Settings.DepthOfFieldMinFstop = MinFstop;
	Settings.DepthOfFieldBladeCount = Blades;
	return DiaphragmDOF::FBokehModel::Compile(Settings);
}

} // namespace PassTest
