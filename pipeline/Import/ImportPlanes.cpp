// Reads planes part by part and lays them into the picture.
#include "Import/ImportPlanes.h"

#include "Import/ImportErrors.h"
#include "Picture/ImageFile.h"
#include "Picture/ImagePlane.h"
#include "Text/Fmt.inl"
#include "RangeTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

/** A plane that is wanted. */
struct FWanted
{
	FImportSource Source;
	const FImportChannel* Channel = nullptr;
	bool bColor = false; // decoded where the file is encoded
	bool bWhole = false; // whole numbers are wanted as such
	float Outside = 0.0f;
};

using FWantedByPart = std::map<std::pair<size_t, int>, std::vector<FWanted>>; // by file and part

bool IsColor(const FImportTarget& Target)
{
	const std::string Group = Target.Group;
	return Target.Kind == EImportKind::Color || Group == "basecolor" || Group == "translucency";
}

FWantedByPart FindWanted(const FImportLayers& Layers, const FImportPlan& Plan, const std::vector<FImportSource>& More)
{
	FWantedByPart Wanted;
	const auto Add = [&](FWanted One)
	{
		const FImportLayer& Layer = Layers.Layers[One.Source.Layer];
		One.Channel = Layer.Find(One.Source.Slot);
		std::vector<FWanted>& OfPart = Wanted[{Layer.File, Layer.Part}];
		const bool bKnown = std::any_of(
			OfPart.begin(), OfPart.end(), [&One](const FWanted& Other) { return Other.Source == One.Source; });
		if (!bKnown && One.Channel != nullptr)
		{
			OfPart.push_back(One);
		}
	};
	for (const FImportRow& Row : Plan.Rows)
	{
		const EImportKind Kind = Row.Target->Kind;
		for (const std::optional<FImportSource>& Source : Row.Sources)
		{
			if (Source)
			{
				Add({*Source, nullptr, IsColor(*Row.Target), Kind == EImportKind::Number || Kind == EImportKind::Depth,
					Kind == EImportKind::Depth ? std::numeric_limits<float>::infinity() : 0.0f});
			}
		}
	}
	for (const FImportSource& Source : More)
	{
		Add({Source, nullptr, false, false, 0.0f});
	}
	return Wanted;
}

/** The plane in the picture, and whole numbers as such. */
std::vector<float> LayInto(
	const FImportPlanes& Picture, const FImportPart& Part, const FWanted& Wanted, const std::vector<float>& Values)
{
	const double Scale = Wanted.bWhole && Wanted.Channel->Greatest > 0.0 ? Wanted.Channel->Greatest : 0.0;
	std::vector<float> Plane(static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.Height), Wanted.Outside);
	const int FirstX = std::max(0, -Part.Window.X);
	const int EndX = std::min(Part.Width, Picture.Width - Part.Window.X);
	for (int Y = std::max(0, -Part.Window.Y); Y < std::min(Part.Height, Picture.Height - Part.Window.Y); ++Y)
	{
		for (int X = FirstX; X < EndX; ++X)
		{
			const size_t From = static_cast<size_t>(Y) * static_cast<size_t>(Part.Width) + static_cast<size_t>(X);
			const size_t To = static_cast<size_t>(Y + Part.Window.Y) * static_cast<size_t>(Picture.Width) +
							  static_cast<size_t>(X + Part.Window.X);
			Plane[To] =
				Scale > 0.0 ? static_cast<float>(std::round(static_cast<double>(Values[From]) * Scale)) : Values[From];
		}
	}
	return Plane;
}

void ReportWindow(const std::string& File, const FImportPart& Part, std::vector<FDiagnostic>& Diagnostics)
{
	const int EndX = Part.Window.X + Part.Width;
	const int EndY = Part.Window.Y + Part.Height;
	const bool bOver =
		Part.Window.X < 0 || Part.Window.Y < 0 || EndX > Part.GetFullWidth() || EndY > Part.GetFullHeight();
	const bool bShort =
		Part.Window.X > 0 || Part.Window.Y > 0 || EndX < Part.GetFullWidth() || EndY < Part.GetFullHeight();
	if (bOver || bShort)
	{
		Diagnostics.push_back({.Severity = ESeverity::Note,
			.Code = NoteImportChanged,
			.Message =
				fmt::format("the data window of {} x {} pixels at ({}, {}) is laid into the picture of {} x {}{}{}",
					Part.Width, Part.Height, Part.Window.X, Part.Window.Y, Part.GetFullWidth(), Part.GetFullHeight(),
					bOver ? "; parts outside the picture are cut" : "",
					bShort ? "; missing pixels are 0, and infinitely far" : ""),
			.File = File});
	}
}

} // namespace

FImportPlanes ReadImportPlanes(const FImportLayers& Layers, const FImportPlan& Plan,
	const std::vector<FImportSource>& More, std::vector<FDiagnostic>& Diagnostics)
{
	FImportPlanes Planes{Plan.Width, Plan.Height, {}};
	for (const auto& [Where, AllWanted] : FindWanted(Layers, Plan, More))
	{
		const FImportFile& File = Layers.Files[Where.first];
		const FImportPart& Part = File.Parts[static_cast<size_t>(Where.second)];
		ReportWindow(File.Path, Part, Diagnostics);
		// An encoded file is read once for colour and once for all that is none.
		for (const bool bColor : {true, false})
		{
			std::vector<FWanted> Wanted;
			std::copy_if(AllWanted.begin(), AllWanted.end(), std::back_inserter(Wanted),
				[&](const FWanted& One) { return File.bEncoded ? One.bColor == bColor : bColor; });
			auto Indices = ToVector<int>(Wanted, [&](const FWanted& One) { return One.Channel->Index; });
			FImageFile Image(File.Path);
			std::vector<FImagePlane> Values =
				bColor && Where.second == 0 ? Image.ReadPlanes(Indices) : Image.ReadPart(Where.second, Indices);
			for (size_t Index = 0; Index < Wanted.size(); ++Index)
			{
				const FImportSource& Source = Wanted[Index].Source;
				Values[Index].MakeFloats();
				Planes.Planes[{Source.Layer, Source.Slot}] = LayInto(Planes, Part, Wanted[Index], Values[Index].Floats);
			}
		}
	}
	return Planes;
}

} // namespace Drydock
