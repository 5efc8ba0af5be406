// Reads picture files into textures as the engine's import makes them, and makes render targets.
#include "Objects/ConfigAssets.h"

#include "Config/ConfigKeys.h"
#include "Config/ConfigReader.h"
#include "Engine/Texture.h"
#include "Engine/TextureRenderTarget2D.h"
#include "Picture/ImageFile.h"
#include "Picture/ImageFormat.h"
#include "Picture/ImagePlane.h"
#include "Objects/IniText.h"
#include "TexelRows.h"
#include "TextTools.h"
#include "TextureResource.h"
#include "UObject/Assets.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Red, green, blue and alpha; a single channel is grey, what lacks of colour 0, and of alpha 1. */
std::vector<int> ChooseChannels(const FImageFile& File)
{
	const std::vector<int> Named = {
		File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B"), File.FindChannel("A")};
	return Named[0] < 0 ? std::vector<int>{0, 0, 0, Named[3]} : Named;
}

UTexture2D* MakeTexture(const std::string& Path)
{
	FImageFile File(Path);
	const std::vector<int> Wanted = ChooseChannels(File);
	std::vector<int> Present;
	std::copy_if(Wanted.begin(), Wanted.end(), std::back_inserter(Present), [](int Channel) { return Channel >= 0; });
	const std::vector<FImagePlane> Planes = File.ReadPart(0, Present);
	const double Greatest = File.GetParts()[0].Greatest.empty() ? 0.0 : File.GetParts()[0].Greatest[size_t(Present[0])];
	const bool bBytes = Greatest > 0.0 && Greatest <= 255.0;
	UTexture2D* const Texture =
		UTexture2D::CreateTransient(File.GetWidth(), File.GetHeight(), bBytes ? PF_B8G8R8A8 : PF_FloatRGBA);
	Texture->SetFName(Files::path(Path).stem().c_str());
	Texture->SRGB = File.IsEncoded() ? 1 : 0;
	uint8* Texel = static_cast<uint8*>(Texture->GetPlatformData()->Mips[0].BulkData.Lock(LOCK_READ_WRITE));
	const size_t NumPixels = size_t(File.GetWidth()) * size_t(File.GetHeight());
	for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
	{
		float Color[4] = {0.0f, 0.0f, 0.0f, 1.0f};
		for (size_t Channel = 0, Plane = 0; Channel < 4; ++Channel)
		{
			Color[Channel] = Wanted[Channel] >= 0 ? Planes[Plane++].Get(Pixel) : Color[Channel];
		}
		EncodeTexelRow(bBytes ? ETexelStorage::BGRA8_UNORM : ETexelStorage::RGBA16_FLOAT, Color, 1, Texel);
		Texel += bBytes ? 4 : 8;
	}
	Texture->UpdateResource();
	return Texture;
}

/** The texture of a file as it is now. Throws FError. */
UTexture2D* FindOrLoad(const std::string& Path)
{
	static std::map<std::pair<std::string, Files::file_time_type>, UTexture2D*> Loaded;
	std::error_code Missing; // the reader reports it
	UTexture2D*& Texture = Loaded[{Path, Files::last_write_time(Path, Missing)}];
	Texture = Texture != nullptr ? Texture : MakeTexture(Path);
	return Texture;
}

/** "/Game/FX/RT.RT" of "TextureRenderTarget2D'/Game/FX/RT.RT'", without the object's name where it is the package's:
 * "/Game/FX/RT". */
std::string GetPackage(const std::string& Path)
{
	const size_t Begin = Path.find('\'');
	const std::string Whole = Begin == std::string::npos ? Path : Path.substr(Begin + 1, Path.rfind('\'') - Begin - 1);
	return Whole.substr(0, Whole.find('.', Whole.rfind('/') == std::string::npos ? 0 : Whole.rfind('/')));
}

std::string GetLastName(const std::string& Package)
{
	return Package.substr(Package.rfind('/') + 1);
}

/** The entry of "assets" that a text means; null: none. A key without a folder is a name, which any path may end with.
 */
const FJsonMember* FindEntry(const FConfig& Config, const std::string& Text)
{
	const std::string Package = GetPackage(Text);
	for (const FJsonMember& Entry : Config.Assets.Members)
	{
		const std::string Key = GetPackage(Entry.Key);
		const bool bName = Key.find('/') == std::string::npos || Package.find('/') == std::string::npos;
		if (bName ? IsSameName(GetLastName(Key), GetLastName(Package)) : IsSameName(Key, Package))
		{
			return &Entry;
		}
	}
	return nullptr;
}

/** Those that were asked for, by the config's file and their key. */
std::map<std::pair<std::string, std::string>, UTextureRenderTarget2D*>& GetTargets()
{
	static std::map<std::pair<std::string, std::string>, UTextureRenderTarget2D*> Targets;
	return Targets;
}

/** Makes the target anew, cleared. */
void SetUp(UTextureRenderTarget2D& Target, const FJsonMember& Entry)
{
	const FJsonValue& Value = Entry.Value;
	const auto GetSize = [&](const char* Key)
	{
		const FJsonValue* const Size = Value.Find(Key);
		return Size != nullptr ? static_cast<int32>(Size->Number) : 0;
	};
	Target.SetFName(GetLastName(GetPackage(Entry.Key)).c_str());
	Target.RenderTargetFormat = RTF_RGBA16f;
	if (const FJsonValue* const Format = Value.Find("RenderTargetFormat"))
	{
		const std::vector<std::string> Names = SplitText(FindConfigKey("asset", "RenderTargetFormat")->Of, '|');
		const auto Found = std::ranges::find(Names, Format->String);
		Target.RenderTargetFormat = static_cast<ETextureRenderTargetFormat>(Found - Names.begin());
	}
	Target.ClearColor = FLinearColor(0.0f, 1.0f, 0.0f);
	if (const FJsonValue* const Color = Value.Find("ClearColor"))
	{
		const auto Get = [&](size_t Index)
		{
			return static_cast<float>(Color->Elements[Index].Number);
		};
		Target.ClearColor = FLinearColor(Get(0), Get(1), Get(2), Get(3));
	}
	const FJsonValue* const UAV = Value.Find("bCanCreateUAV");
	Target.bCanCreateUAV = UAV != nullptr && UAV->Bool;
	Target.InitAutoFormat(GetSize("SizeX"), GetSize("SizeY"));
}

/** Reports what is wrong with an entry whose keys have the right types. */
void CheckEntry(const FJsonValue& Entry, FConfigMessages& Messages)
{
	const bool bFile = Entry.Find("file") != nullptr;
	const bool bSize = Entry.Find("SizeX") != nullptr && Entry.Find("SizeY") != nullptr;
	if (bFile ? Entry.Members.size() > 1 : !bSize)
	{
		Messages.Error(ErrorBadValue, Entry,
			bFile ? "\"file\" makes a picture, which has no other key"
				  : "expected either \"file\", or \"SizeX\" and \"SizeY\" of a render target");
	}
	for (const char* const Key : {"SizeX", "SizeY"})
	{
		const FJsonValue* const Size = Entry.Find(Key);
		if (Size != nullptr && Size->Type == EJsonType::Number &&
			(Size->Number < 1.0 || Size->Number > 16384.0 || Size->Number != std::floor(Size->Number)))
		{
			Messages.Error(ErrorBadValue, *Size, "expected a whole number of texels from 1 to 16384");
		}
	}
}

FGivenAsset FindIn(const FConfig& Config, const std::string& Text)
{
	const FJsonMember* const Entry = FindEntry(Config, Text);
	const FJsonValue* const File = Entry != nullptr ? Entry->Value.Find("file") : nullptr;
	if (Entry != nullptr && File == nullptr)
	{
		UTextureRenderTarget2D*& Target = GetTargets()[{Config.File, Entry->Key}];
		if (Target == nullptr)
		{
			Target = NewObject<UTextureRenderTarget2D>();
			SetUp(*Target, *Entry);
		}
		return {Target, ""};
	}
	const std::string& Path = File != nullptr ? File->String : Text;
	if (File == nullptr && !IsImagePath(Path))
	{
		return {};
	}
	try
	{
		return {FindOrLoad(Config.Resolve(Path)), ""};
	}
	catch (const FError& Error)
	{
		const FDiagnostic& Reason = Error.GetDiagnostics().front();
		return {nullptr, Reason.File + ": " + Reason.Message};
	}
}

} // namespace

void BeginAssets(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	const auto Kept = std::make_shared<FConfig>();
	Kept->File = Config.File;
	Kept->Assets = Config.Assets;
	const size_t NumBefore = Diagnostics.size();
	for (const FJsonMember& Entry : Config.Assets.Members)
	{
		CheckEntry(Entry.Value, Messages);
		const auto Known = GetTargets().find({Config.File, Entry.Key});
		if (Known != GetTargets().end() && Diagnostics.size() == NumBefore)
		{
			SetUp(*Known->second, Entry);
		}
	}
	if (Diagnostics.size() > NumBefore)
	{
		Kept->Assets = {};
	}
	SetAssetFinder([Kept](const std::string& Text) { return FindIn(*Kept, Text); });
}

std::vector<FAssetTarget> GetAssetTargets(const FConfig& Config)
{
	std::vector<FAssetTarget> Targets;
	for (const FJsonMember& Entry : Config.Assets.Members)
	{
		if (Entry.Value.Find("file") == nullptr)
		{
			const auto Found = GetTargets().find({Config.File, Entry.Key});
			Targets.push_back({Entry.Key, Found == GetTargets().end() ? nullptr : Found->second});
		}
	}
	return Targets;
}

} // namespace Drydock
