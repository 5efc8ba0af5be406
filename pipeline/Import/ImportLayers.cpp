// Groups the channels of files and parts by layer.
#include "Import/ImportLayers.h"

#include "Import/ImportTargets.h"
#include "Picture/ImageFile.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** -1 if the name is not a component. */
int FindSlot(const std::string& Component)
{
	static const std::map<std::string, int> Slots = {{"r", 0}, {"g", 1}, {"b", 2}, {"a", 3}, {"x", 0}, {"y", 1},
		{"z", 2}, {"w", 3}, {"u", 0}, {"v", 1}, {"red", 0}, {"green", 1}, {"blue", 2}, {"alpha", 3}, {"i", 0},
		{"id", 0}};
	const auto Found = Slots.find(ToLowerCase(Component));
	return Found == Slots.end() ? -1 : Found->second;
}

/** Whether these are Unreal's layers, whose components are R, G, B and A alone. */
bool IsUnrealLayer(const std::string& Layer)
{
	return Layer.starts_with("FinalImage") || Layer.starts_with("ActorHitProxyMask");
}

size_t FindUnprintable(const std::string& Text)
{
	const auto Found =
		std::ranges::find_if(Text, [](unsigned char Character) { return Character < 0x20 || Character >= 0x7F; });
	return static_cast<size_t>(Found - Text.begin());
}

FImportLayer& FindOrAddLayer(FImportLayers& Read, size_t File, int Part, const std::string& Name)
{
	const auto Found = std::ranges::find_if(Read.Layers,
		[&](const FImportLayer& Layer) { return Layer.File == File && Layer.Part == Part && Layer.Name == Name; });
	if (Found != Read.Layers.end())
	{
		return *Found;
	}
	Read.Layers.push_back({.File = File, .Part = Part, .Name = Name});
	return Read.Layers.back();
}

void AddPart(FImportLayers& Read, const FImagePart& Picture)
{
	const size_t File = Read.Files.size() - 1;
	FImportFile& Of = Read.Files.back();
	const int Part = static_cast<int>(Of.Parts.size());
	for (size_t Index = 0; Index < Picture.Channels.size(); ++Index)
	{
		FImportChannelName Name = SplitChannelName(Picture.Channels[Index]);
		if (Name.Layer.empty() && !Picture.Name.empty())
		{
			Name.Layer = Picture.Name; // a part is named by its pass, its channels by their components alone
		}
		FImportLayer& Layer = FindOrAddLayer(Read, File, Part, Name.Layer);
		Layer.Channels.push_back(
			{Picture.Channels[Index], std::max(Name.Slot, 0), static_cast<int>(Index), Picture.Greatest[Index]});
	}
	Of.Parts.push_back({Picture.Width, Picture.Height, Picture.Window});
	Of.Attributes.insert(Picture.Attributes.begin(), Picture.Attributes.end());
	Of.Chromaticities = Of.Chromaticities.empty() ? Picture.Chromaticities : Of.Chromaticities;
}

/** One channel alone is its layer's first, whatever its letter, and so is a grey one (Y); of one slot the first named
 * counts. */
void SortChannels(FImportLayer& Layer)
{
	if (Layer.Channels.size() == 1)
	{
		Layer.Channels[0].Slot = 0;
	}
	else if (Layer.Find(0) == nullptr && Layer.Find(2) == nullptr)
	{
		for (FImportChannel& Channel : Layer.Channels)
		{
			Channel.Slot = Channel.Slot == 1 ? 0 : Channel.Slot;
		}
	}
	std::ranges::stable_sort(Layer.Channels, {}, &FImportChannel::Slot);
	Layer.Channels.erase(std::unique(Layer.Channels.begin(), Layer.Channels.end(),
							 [](const FImportChannel& A, const FImportChannel& B) { return A.Slot == B.Slot; }),
		Layer.Channels.end());
}

/** The name of a file, with its folder's where another file has the same. */
std::string GetLabel(const FImportLayers& Read, size_t File)
{
	const Files::path Path = Read.Files[File].Path;
	const bool bTwice = std::ranges::count_if(Read.Files, [&Path](const FImportFile& Other)
							{ return Files::path(Other.Path).filename() == Path.filename(); }) > 1;
	return bTwice ? (Path.parent_path().filename() / Path.filename()).string() : Path.filename().string();
}

/** One of several files may be a pass, which its name or that of its folder says. */
std::string GetHint(const FImportLayers& Read, size_t File)
{
	const std::string& Path = Read.Files[File].Path;
	const std::string Pass = GetPassOfFile(Path);
	const std::string Folder = Files::path(Path).parent_path().filename().string();
	return Read.Files.size() == 1                                                         ? ""
		   : FindImportNameRule(Pass) == nullptr && FindImportNameRule(Folder) != nullptr ? Folder
																						  : Pass;
}

} // namespace

const FImportChannel* FImportLayer::Find(int Slot) const
{
	return FindItem(Channels, Slot, &FImportChannel::Slot);
}

FImportChannelName SplitChannelName(const std::string& FullName)
{
	const std::string Name = FullName.substr(0, FindUnprintable(FullName));
	const size_t Dot = Name.rfind('.');
	const std::string Component = Dot == std::string::npos ? Name : Name.substr(Dot + 1);
	const std::string Layer = Dot == std::string::npos ? "" : Name.substr(0, Dot);
	if (const int Slot = FindSlot(Component); Slot >= 0)
	{
		// A lone Z is depth by OpenEXR's custom.
		const bool bDepth = Layer.empty() && (Component == "Z" || Component == "z");
		return bDepth ? FImportChannelName{"Z", 0} : FImportChannelName{Layer, Slot};
	}
	if (const size_t First = Name.find('.'); First != std::string::npos && IsUnrealLayer(Name))
	{
		const int Slot = FindSlot(Name.substr(First + 1, 1));
		return Slot >= 0 ? FImportChannelName{Name.substr(0, First), Slot} : FImportChannelName{Name, -1};
	}
	return {Name, -1};
}

std::string GetPassOfFile(const std::string& Path)
{
	const auto IsNumber = [](unsigned char Character)
	{
		return std::isdigit(Character) != 0 || Character == '.' || Character == '_' || Character == '-';
	};
	std::string Pass = Files::path(Path).stem().string();
	while (!Pass.empty() && IsNumber(static_cast<unsigned char>(Pass.back())))
	{
		Pass.pop_back();
	}
	const size_t Dot = Pass.rfind('.'); // "shot.WorldNormal": the last word is the pass
	return Dot == std::string::npos ? Pass : Pass.substr(Dot + 1);
}

FImportLayers ReadImportLayers(const std::vector<std::string>& Paths)
{
	FImportLayers Read;
	for (const std::string& Path : Paths)
	{
		const FImageFile File(Path);
		Read.Files.push_back({.Path = Path, .bEncoded = File.IsEncoded()});
		for (const FImagePart& Part : File.GetParts())
		{
			AddPart(Read, Part);
		}
	}
	for (FImportLayer& Layer : Read.Layers)
	{
		SortChannels(Layer);
		Layer.Label = Layer.Name.empty() ? GetLabel(Read, Layer.File) : Layer.Name;
		Layer.Hint = Layer.Name.empty() ? GetHint(Read, Layer.File) : Layer.Name;
	}
	return Read;
}

} // namespace Drydock
