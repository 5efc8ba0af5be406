// Finds the encoding of a layer from its values.
#include "Import/ImportConvert.h"
#include "Import/ImportErrors.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** How far the lengths of vectors are from 1, on the mean over those that are some, when they are Scale * v + Offset.
 */
double GetLengthError(const std::array<const std::vector<float>*, 3>& Planes, double Scale, double Offset)
{
	double Sum = 0.0;
	size_t Count = 0;
	for (size_t Pixel = 0; Pixel < Planes[0]->size(); ++Pixel)
	{
		double Square = 0.0;
		bool bNone = true;
		for (const std::vector<float>* Plane : Planes)
		{
			const double Value = static_cast<double>((*Plane)[Pixel]);
			Square += (Scale * Value + Offset) * (Scale * Value + Offset);
			bNone = bNone && Value == 0.0;
		}
		if (!bNone && std::isfinite(Square))
		{
			Sum += std::abs(std::sqrt(Square) - 1.0);
			++Count;
		}
	}
	return Count == 0 ? 0.0 : Sum / static_cast<double>(Count);
}

bool AreHalved(const FImportRow& Row, const FImportPlanes& Planes)
{
	std::array<const std::vector<float>*, 3> Normal = {};
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		Normal[Axis] = &Planes.Get(*Row.Sources[Axis]);
	}
	const bool bSigned = std::ranges::any_of(Normal, [](const std::vector<float>* Plane)
		{ return std::any_of(Plane->begin(), Plane->end(), [](float Value) { return Value < -0.01f; }); });
	return !bSigned && GetLengthError(Normal, 2.0, -1.0) < GetLengthError(Normal, 1.0, 0.0);
}

/** Part of the values that lie within a range. */
double GetShareWithin(const std::vector<float>& Plane, float Least, float Greatest)
{
	const auto Count = std::ranges::count_if(Plane, [=](float Value) { return Value >= Least && Value <= Greatest; });
	return Plane.empty() ? 0.0 : static_cast<double>(Count) / static_cast<double>(Plane.size());
}

/** Most of a frame moves little: most values are near 0.5 where that stands for no movement, and none is far from it.
 */
bool AreAroundHalf(const FImportRow& Row, const FImportPlanes& Planes)
{
	return std::ranges::all_of(Row.Sources,
		[&Planes](const std::optional<FImportSource>& Source)
		{
			const std::vector<float>& Plane = Planes.Get(*Source);
			return GetShareWithin(Plane, -0.5f, 1.5f) > 0.999 && GetShareWithin(Plane, 0.25f, 0.75f) > 0.5;
		});
}

} // namespace

void LookAtValues(
	FImportPlan& Plan, const FImportPlanes& Planes, const FImportAsked& Asked, std::vector<FDiagnostic>& Diagnostics)
{
	for (FImportRow& Row : Plan.Rows)
	{
		FImportEncoding& Encoding = Row.Encoding;
		if (Row.Target->Kind == EImportKind::Normal && !Asked.bHalved)
		{
			Encoding.bHalved = AreHalved(Row, Planes);
		}
		if (Row.Target->Kind == EImportKind::Velocity && !Asked.Velocity)
		{
			const bool bHalf = AreAroundHalf(Row, Planes);
			if (Encoding.Velocity == EImportVelocity::Unreal && !bHalf)
			{
				Encoding.Velocity = EImportVelocity::Ndc;
				Diagnostics.push_back({.Severity = ESeverity::Warning,
					.Code = WarnImportImplausible,
					.Message = "velocity is not around 0.5, as Unreal's MotionVectors are: it is read as screen "
							   "positions (-2..2, y up); --velocity overrides this"});
			}
			else if (Encoding.Velocity == EImportVelocity::Pixels && bHalf && Row.Origin == EImportOrigin::Plain)
			{
				Encoding.Velocity = EImportVelocity::Unreal;
			}
		}
	}
}

} // namespace Drydock
