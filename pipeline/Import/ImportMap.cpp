// Reads --map against the layers that there are.
#include "Import/ImportMap.h"

#include "Config/ConfigReader.h"
#include "Import/ImportErrors.h"
#include "Text/Fmt.inl"

#include <algorithm>

namespace Drydock
{

namespace
{

FDiagnostic MakeMapError(const std::string& Text, const std::string& Why)
{
	return {.Code = ErrorImportOption, .Message = "\"" + Text + "\": " + Why, .Where = "--map"};
}

std::optional<size_t> FindLayer(const FImportLayers& Layers, const std::string& Name)
{
	for (size_t Index = 0; Index < Layers.Layers.size(); ++Index)
	{
		const FImportLayer& Layer = Layers.Layers[Index];
		if (Layer.Label == Name || (!Layer.Name.empty() && Layer.Name == Name) ||
			(Layer.Name.empty() && Layers.Files[Layer.File].Path == Name))
		{
			return Index;
		}
	}
	return std::nullopt;
}

std::optional<FImportSource> FindChannel(const FImportLayers& Layers, const std::string& Name)
{
	for (size_t Index = 0; Index < Layers.Layers.size(); ++Index)
	{
		for (const FImportChannel& Channel : Layers.Layers[Index].Channels)
		{
			if (Channel.Name == Name)
			{
				return FImportSource{Index, Channel.Slot};
			}
		}
	}
	return std::nullopt;
}

std::vector<std::string> GetLeftNames(const FImportLayers& Layers)
{
	std::vector<std::string> Names;
	for (const FImportLayer& Layer : Layers.Layers)
	{
		Names.push_back(Layer.Label);
		for (const FImportChannel& Channel : Layer.Channels)
		{
			Names.push_back(Channel.Name);
		}
	}
	return Names;
}

std::vector<std::string> GetRightNames()
{
	std::vector<std::string> Names = {"none"};
	for (const FImportTarget& Target : GetImportTargets())
	{
		Names.emplace_back(Target.Group);
		Names.insert(Names.end(), Target.Channels.begin(), Target.Channels.end());
	}
	return Names;
}

} // namespace

bool FImportMaps::IsSpokenFor(size_t Layer) const
{
	const auto IsIts = [Layer](const auto& Named)
	{
		return Named.second == Layer;
	};
	return None.count(Layer) > 0 || std::ranges::any_of(Groups, IsIts) ||
		   std::ranges::any_of(Channels, [Layer](const auto& Named) { return Named.second.Layer == Layer; });
}

bool FImportMaps::Apply(const FImportTarget& Target, const FImportLayers& Layers,
	std::vector<std::optional<FImportSource>>& Sources, std::vector<FDiagnostic>& Errors) const
{
	const auto Group = Groups.find(Target.Group);
	std::vector<std::optional<FImportSource>> Asked(Target.Channels.size());
	std::string Missing;
	for (size_t Index = 0; Index < Target.Channels.size(); ++Index)
	{
		const int Slot = static_cast<int>(Index);
		const auto Channel = Channels.find(Target.Channels[Index]);
		if (Channel != Channels.end())
		{
			Asked[Index] = Channel->second;
		}
		else if (Group != Groups.end() && Layers.Layers[Group->second].Find(Slot) != nullptr)
		{
			Asked[Index] = FImportSource{Group->second, Slot};
		}
		else if (Index < Target.NumNeeded)
		{
			Missing += (Missing.empty() ? "" : ", ") + Target.Channels[Index];
		}
	}
	const bool bAny = std::ranges::any_of(Asked, [](const auto& Source) { return Source.has_value(); });
	if (!bAny)
	{
		return false;
	}
	if (!Missing.empty())
	{
		Errors.push_back({.Code = ErrorImportOption,
			.Message = fmt::format("{} needs all its channels, but --map names nothing for {}", Target.Group, Missing),
			.Where = "--map"});
	}
	Sources = std::move(Asked);
	return true;
}

FImportMaps ReadImportMaps(
	const std::vector<std::string>& Texts, const FImportLayers& Layers, std::vector<FDiagnostic>& Errors)
{
	FImportMaps Maps;
	for (const std::string& Text : Texts)
	{
		const size_t Equals = Text.rfind('=');
		const std::string Left = Text.substr(0, Equals);
		const std::string Right = Equals == std::string::npos ? "" : Text.substr(Equals + 1);
		if (Left.empty() || Right.empty())
		{
			Errors.push_back(MakeMapError(Text, "expected LAYER=CHANNEL"));
			continue;
		}
		const std::optional<size_t> Layer = FindLayer(Layers, Left);
		const std::optional<FImportSource> Channel = Layer ? std::nullopt : FindChannel(Layers, Left);
		if (!Layer && !Channel)
		{
			Errors.push_back(MakeMapError(
				Text, "no file has a layer or channel \"" + Left + "\"" + Suggest(Left, GetLeftNames(Layers))));
			continue;
		}
		const std::vector<std::string> Known = GetRightNames();
		if (std::ranges::find(Known, Right) == Known.end())
		{
			Errors.push_back(MakeMapError(Text, "a scene has no channel \"" + Right + "\"" + Suggest(Right, Known)));
			continue;
		}
		const FImportTarget* const Group = FindImportTarget(Right);
		if (Right == "none")
		{
			Maps.None.insert(Layer ? *Layer : Channel->Layer);
		}
		else if (Group != nullptr && Layer)
		{
			Maps.Groups[Right] = *Layer;
		}
		else
		{
			// One channel of a group of one may be called by the group.
			Maps.Channels[Group != nullptr ? Group->Channels[0] : Right] = Layer ? FImportSource{*Layer, 0} : *Channel;
		}
	}
	return Maps;
}

} // namespace Drydock
