// Makes the scene's planes, target by target.
#include "Import/ImportConvert.h"

#include "Import/ImportErrors.h"
#include "Import/ImportPrimaries.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr float ToonId = 8.0f;       // cloth, which marks toon shading
constexpr float DefaultLitId = 1.0f; // the default

class FConversion
{
public:
	FConversion(const FImportLayers& InLayers, const FImportPlanes& InPlanes, const FImportChoices& InChoices,
		const FImportCamera& InCamera, std::vector<FDiagnostic>& InDiagnostics)
		: Layers(InLayers)
		, Planes(InPlanes)
		, Choices(InChoices)
		, Camera(InCamera)
		, Diagnostics(InDiagnostics)
		, NumPixels(static_cast<size_t>(Planes.Width) * static_cast<size_t>(Planes.Height))
	{
		Scene.Width = Planes.Width;
		Scene.Height = Planes.Height;
	}

	FImportScene Convert(const FImportPlan& Plan)
	{
		for (const FImportRow& Row : Plan.Rows)
		{
			switch (Row.Target->Kind)
			{
			case EImportKind::Color:
				AddColor(Row);
				break;
			case EImportKind::Depth:
				AddDepth(Row);
				break;
			case EImportKind::Normal:
				AddNormal(Row);
				break;
			case EImportKind::Velocity:
				AddVelocity(Row);
				break;
			default:
				AddAsIs(Row);
				break;
			}
		}
		ApplyStencil();
		ApplyToon();
		return std::move(Scene);
	}

private:
	std::vector<float>& Add(const std::string& Name, float Value = 0.0f)
	{
		Scene.Channels.push_back({Name, std::vector<float>(NumPixels, Value)});
		return Scene.Channels.back().Values;
	}

	std::vector<float>* Find(const std::string& Name) { return const_cast<std::vector<float>*>(Scene.Find(Name)); }

	/** As it stands, 0 where there is no such source. */
	std::vector<float> Copy(const std::optional<FImportSource>& Source) const
	{
		return Source ? Planes.Get(*Source) : std::vector<float>(NumPixels, 0.0f);
	}

	const std::string& GetLabel(const FImportRow& Row) const { return Layers.Layers[Row.Sources[0]->Layer].Label; }

	void Note(const FImportRow& Row, const std::string& Message)
	{
		Diagnostics.push_back(
			{.Severity = ESeverity::Note, .Code = NoteImportChanged, .Message = GetLabel(Row) + ": " + Message});
	}

	/** To Rec.709, where the file has other primaries. */
	void ConvertPrimaries(const FImportRow& Row, std::array<std::vector<float>, 3>& Color)
	{
		const FImportFile& File = Layers.Files[Layers.Layers[Row.Sources[0]->Layer].File];
		const std::optional<FColorMatrix> Matrix = MakeRec709Matrix(File.Chromaticities);
		if (!Matrix)
		{
			return;
		}
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			std::array<double, 3> Sum = {};
			for (size_t To = 0; To < 3; ++To)
			{
				for (size_t From = 0; From < 3; ++From)
				{
					Sum[To] += (*Matrix)[To][From] * static_cast<double>(Color[From][Pixel]);
				}
			}
			for (size_t To = 0; To < 3; ++To)
			{
				Color[To][Pixel] = static_cast<float>(Sum[To]);
			}
		}
		Note(Row, "colours of the file's primaries (chromaticities) are converted to Rec.709");
	}

	void AddColor(const FImportRow& Row)
	{
		std::array<std::vector<float>, 3> Color;
		for (size_t Index = 0; Index < 3; ++Index)
		{
			Color[Index] = Copy(Row.Sources[Index] ? Row.Sources[Index] : Row.Sources[0]); // grey
		}
		ConvertPrimaries(Row, Color);
		std::vector<float> Alpha = Row.Sources[3] ? Planes.Get(*Row.Sources[3]) : std::vector<float>(NumPixels, 1.0f);
		const bool bNoAlpha = std::ranges::all_of(Alpha, [](float Value) { return Value == 0.0f; });
		if (bNoAlpha && Row.Encoding.Alpha == EImportAlpha::Premultiplied)
		{
			Note(Row, "alpha is 0 everywhere: 1 is used");
		}
		if (bNoAlpha || Row.Encoding.Alpha == EImportAlpha::Opaque)
		{
			std::ranges::fill(Alpha, 1.0f);
		}
		for (size_t Index = 0; Index < 3; ++Index)
		{
			for (size_t Pixel = 0; Row.Encoding.Alpha == EImportAlpha::Straight && Pixel < NumPixels; ++Pixel)
			{
				Color[Index][Pixel] *= Alpha[Pixel];
			}
			Scene.Channels.push_back({Row.Target->Channels[Index], std::move(Color[Index])});
		}
		Scene.Channels.push_back({Row.Target->Channels[3], std::move(Alpha)});
	}

	/** Custom depth is 0 where there is none. */
	void AddDepth(const FImportRow& Row)
	{
		const bool bCustom = Row.Target->Group == std::string("customdepth");
		const std::optional<double> Focal = GetFocalLength(Camera, Planes.Width);
		if (Row.Encoding.Depth == EImportDepth::Ray && !Focal)
		{
			throw FError({.Code = ErrorImportOption,
							 .Message = "distances from the camera need its field of view, which is not in the file: "
										"pass --fov DEGREES",
							 .Where = "--depth"},
				ExitUsage);
		}
		const std::vector<float>& Values = Planes.Get(*Row.Sources[0]);
		std::vector<float>& Depth = Add(Row.Target->Channels[0], bCustom ? 0.0f : NoSurfaceDepth);
		size_t NumBroken = 0;
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const int X = static_cast<int>(Pixel % static_cast<size_t>(Planes.Width));
			const int Y = static_cast<int>(Pixel / static_cast<size_t>(Planes.Width));
			const std::optional<float> Distance =
				ConvertDepth(Values[Pixel], Row.Encoding, {X, Y, Planes.Width, Planes.Height}, Focal.value_or(1.0));
			Depth[Pixel] = Distance.value_or(Depth[Pixel]);
			NumBroken += std::isnan(Values[Pixel]) || Values[Pixel] < 0.0f ? 1 : 0;
		}
		if (NumBroken > 0)
		{
			Note(Row, fmt::format("{} {} NaN or below 0: no surface there", NumBroken,
						  NumBroken == 1 ? "depth is" : "depths are"));
		}
	}

	void AddNormal(const FImportRow& Row)
	{
		if (Row.Encoding.NormalSpace == EImportNormalSpace::Camera && !Camera.Rotation)
		{
			Diagnostics.push_back({.Severity = ESeverity::Warning,
				.Code = WarnImportMissing,
				.Message = "normals are in the camera's space, but its rotation is unknown; drydock assumes that it "
						   "looks along X; pass --rotation PITCH,YAW,ROLL"});
		}
		const std::array<double, 3> Rotation = Camera.Rotation.value_or(std::array<double, 3>());
		std::array<std::vector<float>, 3> Normal;
		for (size_t Axis = 0; Axis < 3; ++Axis)
		{
			Normal[Axis] = Planes.Get(*Row.Sources[Axis]);
		}
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const std::array<float, 3> World =
				ConvertNormal({Normal[0][Pixel], Normal[1][Pixel], Normal[2][Pixel]}, Row.Encoding, Rotation);
			for (size_t Axis = 0; Axis < 3; ++Axis)
			{
				Normal[Axis][Pixel] = World[Axis];
			}
		}
		for (size_t Axis = 0; Axis < 3; ++Axis)
		{
			Scene.Channels.push_back({Row.Target->Channels[Axis], std::move(Normal[Axis])});
		}
	}

	void AddVelocity(const FImportRow& Row)
	{
		std::vector<float> X = Planes.Get(*Row.Sources[0]);
		std::vector<float> Y = Planes.Get(*Row.Sources[1]);
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const std::array<float, 2> Velocity =
				ConvertVelocity({X[Pixel], Y[Pixel]}, Row.Encoding, Planes.Width, Planes.Height);
			X[Pixel] = Velocity[0];
			Y[Pixel] = Velocity[1];
		}
		Scene.Channels.push_back({Row.Target->Channels[0], std::move(X)});
		Scene.Channels.push_back({Row.Target->Channels[1], std::move(Y)});
	}

	void AddAsIs(const FImportRow& Row)
	{
		const bool bNumber = Row.Target->Kind == EImportKind::Number;
		for (size_t Index = 0; Index < Row.Target->Channels.size(); ++Index)
		{
			const bool bShadow = Row.Target->Group == std::string("shadow"); // a shadow that nobody gives is none
			if (!Row.Sources[Index])
			{
				Add(Row.Target->Channels[Index], bShadow ? 1.0f : 0.0f);
				continue;
			}
			std::vector<float>& Plane = Add(Row.Target->Channels[Index]);
			size_t NumBroken = 0;
			const std::vector<float>& Values = Planes.Get(*Row.Sources[Index]);
			for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
			{
				const float Value = Values[Pixel];
				NumBroken += std::isfinite(Value) ? 0 : 1;
				Plane[Pixel] = !std::isfinite(Value) ? 0.0f
							   : bNumber             ? std::clamp(std::round(Value), 0.0f, 255.0f)
													 : Value;
			}
			if (NumBroken > 0)
			{
				Note(Row, fmt::format("{} values are NaN or infinite: 0 is used", NumBroken));
			}
		}
	}

	/** Objects chosen by name get their value, and their depth where they are seen. */
	void ApplyStencil()
	{
		if (Choices.Stencil.empty())
		{
			return;
		}
		std::vector<float>* const Known = Find("customstencil.ID");
		std::vector<float> Stencil = Known != nullptr ? *Known : std::vector<float>(NumPixels, 0.0f);
		const std::vector<float>* const Depth = Scene.Find("depth.Z");
		std::vector<float>* const KnownDepth = Find("customdepth.Z");
		std::vector<float> CustomDepth = KnownDepth != nullptr ? *KnownDepth : std::vector<float>(NumPixels, 0.0f);
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			for (const FImportChoice& Choice : Choices.Stencil)
			{
				if (IsChosen(Choice, Planes, Pixel, -1))
				{
					Stencil[Pixel] = static_cast<float>(Choice.Value);
					CustomDepth[Pixel] =
						Depth != nullptr && KnownDepth == nullptr ? (*Depth)[Pixel] : CustomDepth[Pixel];
				}
			}
		}
		Put("customstencil.ID", std::move(Stencil));
		if (Depth != nullptr)
		{
			Put("customdepth.Z", std::move(CustomDepth));
		}
	}

	void ApplyToon()
	{
		if (Choices.Toon.empty())
		{
			return;
		}
		const std::vector<float>* const Depth = Scene.Find("depth.Z");
		const std::vector<float>* const Stencil = Scene.Find("customstencil.ID");
		const std::vector<float>* const Known = Scene.Find("shadingmodel.ID");
		const std::vector<float>* const KnownMask = Scene.Find("custommask.B");
		std::vector<float> Ids = Known != nullptr ? *Known : std::vector<float>(NumPixels, DefaultLitId);
		std::vector<float> Mask = KnownMask != nullptr ? *KnownMask : std::vector<float>(NumPixels, 0.0f);
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const int Value = Stencil != nullptr ? static_cast<int>((*Stencil)[Pixel]) : -1;
			const bool bToon = std::ranges::any_of(
				Choices.Toon, [&](const FImportChoice& Choice) { return IsChosen(Choice, Planes, Pixel, Value); });
			const bool bOpen = Known == nullptr && Depth != nullptr && (*Depth)[Pixel] == NoSurfaceDepth;
			Ids[Pixel] = bToon ? ToonId : bOpen ? 0.0f : Ids[Pixel];
			Mask[Pixel] = bToon ? 1.0f : Mask[Pixel];
		}
		Put("shadingmodel.ID", std::move(Ids));
		Put("custommask.B", std::move(Mask));
	}

	void Put(const std::string& Name, std::vector<float> Values)
	{
		std::vector<float>* const Known = Find(Name);
		(Known != nullptr ? *Known : Add(Name)) = std::move(Values);
	}

	const FImportLayers& Layers;
	const FImportPlanes& Planes;
	const FImportChoices& Choices;
	const FImportCamera& Camera;
	std::vector<FDiagnostic>& Diagnostics;
	const size_t NumPixels;
	FImportScene Scene;
};

} // namespace

const std::vector<float>* FImportScene::Find(const std::string& Name) const
{
	const auto Found = std::ranges::find(Channels, Name, &FImportChannelPlane::Name);
	return Found == Channels.end() ? nullptr : &Found->Values;
}

FImportScene ConvertImport(const FImportLayers& Layers, const FImportPlan& Plan, const FImportPlanes& Planes,
	const FImportChoices& Choices, const FImportCamera& Camera, std::vector<FDiagnostic>& Diagnostics)
{
	return FConversion(Layers, Planes, Choices, Camera, Diagnostics).Convert(Plan);
}

} // namespace Drydock
