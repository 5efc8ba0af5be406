// Chooses a layer for every group of channels.
#include "Import/ImportGuess.h"

#include "Config/ConfigReader.h"
#include "Import/ImportErrors.h"
#include "Import/ImportMap.h"
#include "Text/Fmt.inl"
#include "TextTools.h"

#include <algorithm>
#include <ranges>

namespace Drydock
{

namespace
{

/** A layer that may become a group. */
struct FCandidate
{
	size_t Layer = 0;
	int FirstSlot = 0; // of the group's first channel
	int Rank = 0;
	std::string Remark = "";
};

using FCandidates = std::map<std::string, std::vector<FCandidate>>; // by group

/** The view layer or camera of a name: "ViewLayer" of "ViewLayer.Depth". */
std::string GetScope(const std::string& Name)
{
	const size_t Dot = Name.rfind('.');
	return Dot == std::string::npos ? "" : Name.substr(0, Dot);
}

void AddCandidates(const FImportLayers& Layers, size_t Index, FCandidates& Candidates, FImportPlan& Plan)
{
	const FImportLayer& Layer = Layers.Layers[Index];
	const FImportNameRule* const Rule = Layer.Hint.empty() ? nullptr : FindImportNameRule(Layer.Hint);
	if (Rule == nullptr && Layer.Name.empty())
	{
		// The picture itself, after those that say it.
		Candidates["color"].push_back({Index, 0, Layer.Hint.empty() ? 3 : 1});
	}
	else if (Rule == nullptr)
	{
		Plan.LeftOut.push_back({Index, "no channel of a scene has such a name"});
	}
	else if (Rule->Group.empty())
	{
		Plan.LeftOut.push_back({Index, Rule->Remark});
	}
	else if (Rule->Group == "ids")
	{
		Candidates["shadingmodel"].push_back({Index, 0, Rule->Rank});
		Candidates["customstencil"].push_back({Index, 1, Rule->Rank});
		Candidates["customdepth"].push_back({Index, 2, Rule->Rank});
	}
	else
	{
		Candidates[Rule->Group].push_back({Index, 0, Rule->Rank, Rule->Remark});
	}
}

/** Empty where the layer has too few components. */
std::vector<std::optional<FImportSource>> FindSources(
	const FImportLayers& Layers, const FImportTarget& Target, const FCandidate& Candidate)
{
	std::vector<std::optional<FImportSource>> Sources;
	for (size_t Index = 0; Index < Target.Channels.size(); ++Index)
	{
		const int Slot = Candidate.FirstSlot + static_cast<int>(Index);
		const bool bThere = Layers.Layers[Candidate.Layer].Find(Slot) != nullptr;
		if (!bThere && Index < Target.NumNeeded)
		{
			return {};
		}
		Sources.push_back(bThere ? std::optional(FImportSource{Candidate.Layer, Slot}) : std::nullopt);
	}
	return Sources;
}

/** Unreal writes radiance and transmittance of translucency as two materials, each of three equal or four components.
 */
void JoinTranslucency(const FImportLayers& Layers, std::vector<FCandidate>& Candidates, FImportRow& Row)
{
	const auto IsTransmittance = [&Layers](const FCandidate& Candidate)
	{
		const std::string& Hint = Layers.Layers[Candidate.Layer].Hint;
		return Hint.ends_with("TranslucencyA") || Hint.ends_with("translucency_a");
	};
	const auto Alpha = std::find_if(Candidates.begin(), Candidates.end(), IsTransmittance);
	const auto Color = std::find_if_not(Candidates.begin(), Candidates.end(), IsTransmittance);
	if (Alpha == Candidates.end() || Color == Candidates.end())
	{
		return;
	}
	Row.Sources = {{{Color->Layer, 0}}, {{Color->Layer, 1}}, {{Color->Layer, 2}}, {{Alpha->Layer, 0}}};
	const auto [First, Second] = std::minmax(Alpha->Layer, Color->Layer);
	std::erase_if(Candidates, [First = First, Second = Second](const FCandidate& Candidate)
		{ return Candidate.Layer == First || Candidate.Layer == Second; });
}

class FGuess
{
public:
	FGuess(const FImportLayers& InLayers, const FImportAsked& InAsked, std::vector<FDiagnostic>& InDiagnostics)
		: Layers(InLayers)
		, Asked(InAsked)
		, Diagnostics(InDiagnostics)
	{
	}

	FImportPlan Guess()
	{
		const FImportMaps Maps = ReadImportMaps(Asked.Maps, Layers, Errors);
		FCandidates Candidates;
		for (size_t Index = 0; Index < Layers.Layers.size(); ++Index)
		{
			if (Maps.IsSpokenFor(Index))
			{
				continue;
			}
			AddCandidates(Layers, Index, Candidates, Plan);
		}
		for (const size_t Index : Maps.None)
		{
			Plan.LeftOut.push_back({Index, "left out by --map"});
		}
		for (const FImportTarget& Target : GetImportTargets())
		{
			AddRow(Target, Candidates[Target.Group], Maps);
		}
		if (Plan.Find("color") == nullptr)
		{
			Errors.push_back({.Code = ErrorImportNoColor,
				.Message =
					"none of the layers is the frame's colour: " + ListLayers() + "; --map LAYER=color names it"});
		}
		CheckSizes();
		if (!Errors.empty())
		{
			throw FError(Errors, ExitUsage);
		}
		return std::move(Plan);
	}

private:
	void AddRow(const FImportTarget& Target, std::vector<FCandidate> Candidates, const FImportMaps& Maps)
	{
		FImportRow Row;
		Row.Target = &Target;
		const bool bMapped = Maps.Apply(Target, Layers, Row.Sources, Errors);
		if (!bMapped && Target.Group == std::string("translucency"))
		{
			JoinTranslucency(Layers, Candidates, Row);
		}
		const std::string Scope = Plan.Rows.empty() ? "" : GetScope(GetLayer(Plan.Rows[0]).Name);
		std::stable_sort(Candidates.begin(), Candidates.end(),
			[&](const FCandidate& A, const FCandidate& B) { return GetOrder(A, Scope) > GetOrder(B, Scope); });
		const FCandidate* Taken = nullptr;
		for (const FCandidate& Candidate : Candidates)
		{
			if (Target.Kind == EImportKind::Depth && Candidate.Rank == 1 && !Asked.Mist)
			{
				Plan.LeftOut.push_back({Candidate.Layer, Candidate.Remark});
				continue;
			}
			if (!Row.Sources.empty())
			{
				ReportOther(Target, Row, Taken, Candidate);
				continue;
			}
			Row.Sources = FindSources(Layers, Target, Candidate);
			if (Row.Sources.empty())
			{
				ReportTooFew(Target, Candidate);
				continue;
			}
			Taken = &Candidate;
			Row.Remark = Candidate.Remark;
		}
		if (!Row.Sources.empty())
		{
			ChooseEncoding(Row, Taken);
			Plan.Rows.push_back(std::move(Row));
		}
	}

	std::pair<bool, int> GetOrder(const FCandidate& Candidate, const std::string& Scope) const
	{
		return {GetScope(Layers.Layers[Candidate.Layer].Name) == Scope, Candidate.Rank};
	}

	void ReportOther(
		const FImportTarget& Target, const FImportRow& Row, const FCandidate* Taken, const FCandidate& Candidate)
	{
		const std::string& Other = Layers.Layers[Candidate.Layer].Label;
		const std::string& Chosen = GetLayer(Row).Label;
		Plan.LeftOut.push_back({Candidate.Layer, fmt::format("{} is taken from {}", Target.Group, Chosen)});
		// A layer that --map names is not a guess, and a layer of lower rank is not in doubt.
		if (Taken != nullptr && Taken->Rank == Candidate.Rank)
		{
			Diagnostics.push_back({.Severity = ESeverity::Warning,
				.Code = WarnImportAmbiguous,
				.Message = fmt::format("{} could be {} or {}: the first is used; --map \"{}={}\" selects the other",
					Target.Group, Chosen, Other, Other, Target.Group)});
		}
	}

	void ReportTooFew(const FImportTarget& Target, const FCandidate& Candidate)
	{
		if (Layers.Layers[Candidate.Layer].Hint.find("rydockI") == std::string::npos)
		{
			Plan.LeftOut.push_back({Candidate.Layer,
				fmt::format("it has fewer than the {} components of {}", Target.NumNeeded, Target.Group)});
		}
	}

	void ChooseEncoding(FImportRow& Row, const FCandidate* Taken) const
	{
		const FImportLayer& Layer = GetLayer(Row);
		Row.Origin = Asked.Origin.value_or(FindOrigin(Layer.File));
		const bool bUnreal = Row.Origin == EImportOrigin::Unreal;
		const std::string Remark = Taken != nullptr ? Taken->Remark : "";
		FImportEncoding& Encoding = Row.Encoding;
		Encoding.Unit = Asked.Unit.value_or(bUnreal ? "cm" : "m");
		Encoding.Depth = Asked.Depth.value_or(
			Asked.Mist && Taken != nullptr && Taken->Rank == 1 ? EImportDepth::Mist : EImportDepth::Distance);
		Encoding.Mist = Asked.Mist.value_or(FImportMist());
		Encoding.NormalSpace =
			Asked.NormalSpace.value_or(Remark.find("camera") != std::string::npos ? EImportNormalSpace::Camera
									   : bUnreal                                  ? EImportNormalSpace::Unreal
																				  : EImportNormalSpace::World);
		Encoding.bHalved = Asked.bHalved.value_or(false);
		Encoding.Velocity = Asked.Velocity.value_or(bUnreal                                ? EImportVelocity::Unreal
													: Row.Origin == EImportOrigin::Blender ? EImportVelocity::Blender
																						   : EImportVelocity::Pixels);
		Encoding.bFlipVelocity = Asked.bFlipVelocity;
		Encoding.Alpha = Asked.Alpha.value_or(EImportAlpha::Premultiplied);
	}

	/** A file that does not say is of the same origin as another. */
	EImportOrigin FindOrigin(size_t File) const
	{
		EImportOrigin Origin = FindImportOrigin(Layers, File);
		for (size_t Other = 0; Other < Layers.Files.size() && Origin == EImportOrigin::Plain; ++Other)
		{
			Origin = FindImportOrigin(Layers, Other);
		}
		return Origin;
	}

	/** Colour's picture is the scene's. */
	void CheckSizes()
	{
		for (const FImportRow& Row : Plan.Rows)
		{
			for (const std::optional<FImportSource>& Source : Row.Sources)
			{
				const FImportPart* const Part = Source ? &GetPart(Source->Layer) : nullptr;
				if (Part == nullptr)
				{
					continue;
				}
				if (Plan.Width == 0)
				{
					Plan.Width = Part->GetFullWidth();
					Plan.Height = Part->GetFullHeight();
				}
				if (Part->GetFullWidth() != Plan.Width || Part->GetFullHeight() != Plan.Height)
				{
					Errors.push_back({.Code = ErrorImportSizes,
						.Message = fmt::format("{} is {} x {} pixels, and {} is {} x {}: one frame has one size",
							Layers.Layers[Source->Layer].Label, Part->GetFullWidth(), Part->GetFullHeight(),
							GetLayer(Plan.Rows[0]).Label, Plan.Width, Plan.Height),
						.File = Layers.Files[Layers.Layers[Source->Layer].File].Path});
					break;
				}
			}
		}
	}

	const FImportPart& GetPart(size_t Layer) const
	{
		const FImportLayer& Found = Layers.Layers[Layer];
		return Layers.Files[Found.File].Parts[static_cast<size_t>(Found.Part)];
	}

	/** The layer of the first channel that has one. */
	const FImportLayer& GetLayer(const FImportRow& Row) const
	{
		const auto First = std::find_if(Row.Sources.begin(), Row.Sources.end(),
			[](const std::optional<FImportSource>& Source) { return Source.has_value(); });
		return Layers.Layers[(*First)->Layer];
	}

	std::string ListLayers() const
	{
		constexpr size_t MaxNamed = 12;
		return JoinText(Layers.Layers | std::views::take(MaxNamed), ", ", &FImportLayer::Label) +
			   (Layers.Layers.size() > MaxNamed ? ", ..." : "");
	}

	const FImportLayers& Layers;
	const FImportAsked& Asked;
	std::vector<FDiagnostic>& Diagnostics;
	std::vector<FDiagnostic> Errors;
	FImportPlan Plan;
};

} // namespace

const FImportRow* FImportPlan::Find(const std::string& Group) const
{
	const auto Found =
		std::find_if(Rows.begin(), Rows.end(), [&Group](const FImportRow& Row) { return Row.Target->Group == Group; });
	return Found == Rows.end() ? nullptr : &*Found;
}

EImportOrigin FindImportOrigin(const FImportLayers& Layers, size_t File)
{
	const std::map<std::string, std::string>& Attributes = Layers.Files[File].Attributes;
	const auto HasAttribute = [&Attributes](const std::string& Begin)
	{
		const auto Found = Attributes.lower_bound(Begin);
		return Found != Attributes.end() && Found->first.starts_with(Begin);
	};
	const auto HasLayer = [&](auto IsOne)
	{
		return std::any_of(Layers.Layers.begin(), Layers.Layers.end(),
			[&](const FImportLayer& Layer) { return Layer.File == File && IsOne(Layer.Hint); });
	};
	const auto IsUnreal = [](const std::string& Hint)
	{
		for (const char* const Name : {"FinalImage", "MovieRenderQueue_", "ActorHitProxyMask", "HighresScreenshot",
				 "SceneDepthWorldUnits", "PreTonemapHDRColor", "WorldDepth"})
		{
			if (Hint.find(Name) != std::string::npos)
			{
				return true;
			}
		}
		return false;
	};
	const auto IsBlender = [](const std::string& Hint)
	{
		return Hint.starts_with("ViewLayer") || Hint.starts_with("View Layer") || Hint.starts_with("RenderLayer") ||
			   Hint.starts_with("Scene.");
	};
	return HasAttribute("drydock:")                                     ? EImportOrigin::Drydock
		   : HasAttribute("unreal/") || HasLayer(IsUnreal)              ? EImportOrigin::Unreal
		   : HasAttribute("BlenderMultiChannel") || HasLayer(IsBlender) ? EImportOrigin::Blender
																		: EImportOrigin::Plain;
}

FImportPlan GuessImport(const FImportLayers& Layers, const FImportAsked& Asked, std::vector<FDiagnostic>& Diagnostics)
{
	return FGuess(Layers, Asked, Diagnostics).Guess();
}

} // namespace Drydock
