// Measures what an import made.
#include <Imath/half.h>

#include "Import/ImportFigures.h"

#include "Import/ImportErrors.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Drydock
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

std::string FormatFigures(const FImportFigures& Figures, const char* Unit = "")
{
	return fmt::format(
		"{:.4g}{} to {:.4g}{}, mean {:.4g}{}", Figures.Least, Unit, Figures.Greatest, Unit, Figures.Mean, Unit);
}

double GetPercent(size_t Count, size_t All)
{
	return All == 0 ? 0.0 : 100.0 * static_cast<double>(Count) / static_cast<double>(All);
}

std::vector<float> GetLengths(const FImportScene& Scene, const FImportTarget& Target)
{
	const size_t NumPixels = static_cast<size_t>(Scene.Width) * static_cast<size_t>(Scene.Height);
	std::vector<float> Lengths(NumPixels, 0.0f);
	for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
	{
		double Square = 0.0;
		for (const std::string& Channel : Target.Channels)
		{
			const double Value = static_cast<double>((*Scene.Find(Channel))[Pixel]);
			Square += Value * Value;
		}
		Lengths[Pixel] = static_cast<float>(std::sqrt(Square));
	}
	return Lengths;
}

std::string DescribeDepth(const FImportScene& Scene, const FImportTarget& Target)
{
	const std::vector<float>& Depth = *Scene.Find(Target.Channels[0]);
	const FImportFigures Figures =
		MeasureImport(Depth, std::numeric_limits<float>::denorm_min(), static_cast<double>(NoSurfaceDepth) - 1.0);
	if (Figures.Count == 0)
	{
		return "no surface anywhere";
	}
	return FormatFigures(Figures, " m") +
		   fmt::format("; no surface in {:.1f} %", GetPercent(Depth.size() - Figures.Count, Depth.size()));
}

std::string DescribeNormal(const FImportScene& Scene, const FImportTarget& Target)
{
	const std::vector<float> Lengths = GetLengths(Scene, Target);
	const FImportFigures Figures = MeasureImport(Lengths, 1e-6, Infinity);
	return fmt::format("of length {:.4g} to {:.4g}; no surface in {:.1f} %", Figures.Least, Figures.Greatest,
		GetPercent(Lengths.size() - Figures.Count, Lengths.size()));
}

std::string DescribeVelocity(const FImportScene& Scene, const FImportTarget& Target)
{
	const FImportFigures X = MeasureImport(*Scene.Find(Target.Channels[0]), -Infinity, Infinity);
	const FImportFigures Y = MeasureImport(*Scene.Find(Target.Channels[1]), -Infinity, Infinity);
	constexpr double Moving = 0.5;
	const std::vector<float> Lengths = GetLengths(Scene, Target);
	return fmt::format("{:.4g} to {:.4g} pixels right, {:.4g} to {:.4g} down; {:.1f} % move", X.Least, X.Greatest,
		Y.Least, Y.Greatest, GetPercent(MeasureImport(Lengths, Moving, Infinity).Count, Lengths.size()));
}

std::string DescribeNumbers(const std::vector<float>& Values)
{
	constexpr size_t MaxListed = 12;
	const std::set<float> Distinct(Values.begin(), Values.end());
	std::string Text;
	size_t NumListed = 0;
	for (const float Value : Distinct)
	{
		if (NumListed++ == MaxListed)
		{
			return Text + fmt::format(", ... ({} values)", Distinct.size());
		}
		const auto Count = std::ranges::count(Values, Value);
		Text += fmt::format("{}{:g} ({:.1f} %)", Text.empty() ? "" : ", ", Value,
			GetPercent(static_cast<size_t>(Count), Values.size()));
	}
	return Text;
}

void Warn(std::vector<FDiagnostic>& Diagnostics, const std::string& Message)
{
	Diagnostics.push_back({.Severity = ESeverity::Warning, .Code = WarnImportImplausible, .Message = Message});
}

void CheckColor(const FImportScene& Scene, std::vector<FDiagnostic>& Diagnostics)
{
	double Greatest = -Infinity;
	size_t NumBroken = 0;
	for (const char* const Name : {"R", "G", "B"})
	{
		const std::vector<float>& Values = *Scene.Find(Name);
		const FImportFigures Figures = MeasureImport(Values, -Infinity, Infinity);
		Greatest = std::max(Greatest, Figures.Count == 0 ? -Infinity : Figures.Greatest);
		NumBroken += Values.size() - Figures.Count;
	}
	if (NumBroken > 0)
	{
		Warn(Diagnostics,
			fmt::format(
				"{} values of the colour are NaN or infinite: they are kept, and a run reports where they spread",
				NumBroken));
	}
	if (Greatest <= 1.0)
	{
		Warn(Diagnostics,
			"no value of the colour is above 1: a tone curve was on, or the file has 8 bits; there are no "
			"highlights to bloom (docs/your-frame.md)");
	}
}

void CheckDepth(const FImportScene& Scene, const FImportRow& Row, std::vector<FDiagnostic>& Diagnostics)
{
	constexpr double Nearest = 0.05; // metres: all of a frame is hardly nearer
	constexpr double Farthest = 2000.0;
	const FImportFigures Figures = MeasureImport(*Scene.Find(Row.Target->Channels[0]),
		std::numeric_limits<float>::denorm_min(), static_cast<double>(NoSurfaceDepth) - 1.0);
	const std::string Unit = Row.Encoding.Unit;
	if (Figures.Count == 0)
	{
		Warn(Diagnostics, fmt::format("{}: empty everywhere", Row.Target->Group));
	}
	else if (Figures.Greatest <= GetMetres(Unit) && Row.Encoding.Depth == EImportDepth::Distance && Unit == "m")
	{
		Warn(Diagnostics, fmt::format("all values of {} are within 0..1; if they are not distances in metres, pass "
									  "--depth inverse, device or mist",
							  Row.Target->Group));
	}
	else if (Figures.Mean < Nearest)
	{
		Warn(
			Diagnostics, fmt::format("mean {} is {:.3g} m when read as \"{}\"; if the file is in metres, pass --unit m",
							 Row.Target->Group, Figures.Mean, Unit));
	}
	else if (Figures.Mean > Farthest)
	{
		Warn(Diagnostics,
			fmt::format("mean {} is {:.3g} m when read as \"{}\"; if the file is in centimetres, pass --unit cm",
				Row.Target->Group, Figures.Mean, Unit));
	}
}

void CheckNormal(const FImportPlanes& Planes, const FImportRow& Row, std::vector<FDiagnostic>& Diagnostics)
{
	constexpr double LargestError = 0.1;
	constexpr double LargestShare = 5.0; // percent
	size_t NumOff = 0;
	size_t NumSome = 0;
	const size_t NumPixels = Planes.Get(*Row.Sources[0]).size();
	for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
	{
		double Square = 0.0;
		bool bSome = false;
		for (size_t Axis = 0; Axis < 3; ++Axis)
		{
			const double Value = static_cast<double>(Planes.Get(*Row.Sources[Axis])[Pixel]);
			const double Component = Row.Encoding.bHalved ? 2.0 * Value - 1.0 : Value;
			Square += Component * Component;
			bSome = bSome || Value != 0.0;
		}
		NumSome += bSome ? 1 : 0;
		NumOff += bSome && !(std::abs(std::sqrt(Square) - 1.0) <= LargestError) ? 1 : 0;
	}
	if (GetPercent(NumOff, NumSome) > LargestShare)
	{
		Warn(Diagnostics, fmt::format("{:.1f} % of the normals are not of length 1 when {}; if they are stored "
									  "otherwise, pass --normals encoded or signed",
							  GetPercent(NumOff, NumSome),
							  Row.Encoding.bHalved ? "0..1 stands for -1..1" : "they are read as they are"));
	}
}

void CheckVelocity(const FImportScene& Scene, const FImportPlanes& Planes, const FImportRow& Row,
	std::vector<FDiagnostic>& Diagnostics)
{
	const FImportFigures Figures = MeasureImport(GetLengths(Scene, *Row.Target), 0.0, Infinity);
	if (Figures.Greatest > std::hypot(Scene.Width, Scene.Height))
	{
		Warn(Diagnostics,
			fmt::format(
				"the largest movement is {:.4g} pixels in a picture of {} x {}; if that is wrong, pass --velocity",
				Figures.Greatest, Scene.Width, Scene.Height));
	}
	const auto IsHalf = [](float Value)
	{
		return static_cast<float>(half(Value)) == Value;
	};
	const std::vector<float>& X = Planes.Get(*Row.Sources[0]);
	if (Row.Encoding.Velocity == EImportVelocity::Unreal && Figures.Greatest > 0.0 && std::ranges::all_of(X, IsHalf))
	{
		constexpr double HalfStep = 1.0 / 2048.0; // between halves from 0.5 on
		Warn(Diagnostics,
			fmt::format("velocity is stored in half floats around 0.5, in steps of {:.2g} pixels: \"Use 32 Bit "
						"Post Process Materials\" gives full precision",
				2.0 * Scene.Width * HalfStep));
	}
}

void CheckNumbers(const FImportPlanes& Planes, const FImportRow& Row, std::vector<FDiagnostic>& Diagnostics)
{
	constexpr double LargestShare = 0.5; // percent
	const std::vector<float>& Values = Planes.Get(*Row.Sources[0]);
	const auto NumOff = static_cast<size_t>(std::ranges::count_if(
		Values, [](float Value) { return std::isfinite(Value) && std::abs(Value - std::round(Value)) > 0.01f; }));
	if (GetPercent(NumOff, Values.size()) > LargestShare)
	{
		Warn(Diagnostics,
			fmt::format("{:.1f} % of {} are not whole numbers (a visualisation, or antialiased); they are rounded",
				GetPercent(NumOff, Values.size()), Row.Target->Channels[0]));
	}
}

} // namespace

FImportFigures MeasureImport(const std::vector<float>& Values, double Least, double Greatest)
{
	FImportFigures Figures;
	double Sum = 0.0;
	for (const float Value : Values)
	{
		const double Number = static_cast<double>(Value);
		if (!std::isfinite(Number) || Number < Least || Number > Greatest)
		{
			continue;
		}
		Figures.Least = Figures.Count == 0 ? Number : std::min(Figures.Least, Number);
		Figures.Greatest = Figures.Count == 0 ? Number : std::max(Figures.Greatest, Number);
		Sum += Number;
		++Figures.Count;
	}
	Figures.Mean = Figures.Count == 0 ? 0.0 : Sum / static_cast<double>(Figures.Count);
	return Figures;
}

std::string DescribeFigures(const FImportScene& Scene, const FImportTarget& Target)
{
	switch (Target.Kind)
	{
	case EImportKind::Depth:
		return DescribeDepth(Scene, Target);
	case EImportKind::Normal:
		return DescribeNormal(Scene, Target);
	case EImportKind::Velocity:
		return DescribeVelocity(Scene, Target);
	case EImportKind::Number:
		return DescribeNumbers(*Scene.Find(Target.Channels[0]));
	default:
		break;
	}
	std::vector<float> All;
	const size_t NumColors = Target.Channels.size() == 4 ? 3 : Target.Channels.size(); // without alpha
	for (size_t Index = 0; Index < NumColors; ++Index)
	{
		const std::vector<float>& Values = *Scene.Find(Target.Channels[Index]);
		All.insert(All.end(), Values.begin(), Values.end());
	}
	std::string Text = FormatFigures(MeasureImport(All, -Infinity, Infinity));
	if (NumColors == 3 && Target.Channels.size() == 4)
	{
		const FImportFigures Alpha = MeasureImport(*Scene.Find(Target.Channels[3]), -Infinity, Infinity);
		Text += Alpha.Least == Alpha.Greatest ? fmt::format("; alpha {:.4g}", Alpha.Least)
											  : fmt::format("; alpha {:.4g} to {:.4g}", Alpha.Least, Alpha.Greatest);
	}
	return Text;
}

void CheckFigures(const FImportScene& Scene, const FImportPlan& Plan, const FImportPlanes& Planes,
	std::vector<FDiagnostic>& Diagnostics)
{
	for (const FImportRow& Row : Plan.Rows)
	{
		switch (Row.Target->Kind)
		{
		case EImportKind::Color:
			CheckColor(Scene, Diagnostics);
			break;
		case EImportKind::Depth:
			if (Row.Target->Group == std::string("depth"))
			{
				CheckDepth(Scene, Row, Diagnostics);
			}
			break;
		case EImportKind::Normal:
			CheckNormal(Planes, Row, Diagnostics);
			break;
		case EImportKind::Velocity:
			CheckVelocity(Scene, Planes, Row, Diagnostics);
			break;
		case EImportKind::Number:
			CheckNumbers(Planes, Row, Diagnostics);
			break;
		default:
			break;
		}
	}
}

} // namespace Drydock
