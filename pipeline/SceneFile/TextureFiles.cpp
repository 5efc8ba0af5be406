// Loads image files that settings name as textures.
#include "SceneFile/TextureFiles.h"

#include "Config/ConfigReader.h"
#include "Picture/ColorCube.h"
#include "Picture/ImageFile.h"
#include "Picture/ImageFormat.h"
#include "Picture/Srgb.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** R, G and B by name; else the first channel for all three. */
std::vector<int> ChooseChannels(const FImageFile& File)
{
	const std::vector<int> Named = {File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")};
	const bool bAll = std::all_of(Named.begin(), Named.end(), [](int Channel) { return Channel >= 0; });
	return bAll ? Named : std::vector<int>{0, 0, 0};
}

/** A table of codes as the picture that the engine has of it, in linear light as pictures are. */
FTextureRHIRef LoadColorCube(const std::string& File, const std::string& Name)
{
	const FImage Table = MakeLegacyTable(ReadColorCube(File));
	std::vector<FLinearColor> Colors;
	for (size_t Index = 0; Index < Table.Values.size(); Index += 3)
	{
		const auto Decode = [&](size_t Channel)
		{
			return static_cast<float>(DecodeSrgb(Table.Values[Index + Channel]));
		};
		Colors.push_back(FLinearColor(Decode(0), Decode(1), Decode(2), 1.0f));
	}
	return MakePictureTexture(FIntPoint(Table.Width, Table.Height), Colors, Name);
}

FTextureRHIRef LoadPicture(const std::string& File, const std::string& Name)
{
	FImageFile Image(File);
	const std::vector<std::vector<float>> Planes = Image.Read(ChooseChannels(Image));
	std::vector<FLinearColor> Colors;
	Colors.reserve(Planes[0].size());
	for (size_t Index = 0; Index < Planes[0].size(); ++Index)
	{
		Colors.push_back(FLinearColor(Planes[0][Index], Planes[1][Index], Planes[2][Index], 1.0f));
	}
	return MakePictureTexture(FIntPoint(Image.GetWidth(), Image.GetHeight()), Colors, Name);
}

} // namespace

void CheckTextureFiles(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	const auto Check = [&](const FConfigSettings& Settings, const std::string& From)
	{
		FConfigMessages Messages(From, Diagnostics);
		for (const auto& [Name, Place] : Settings.Places)
		{
			const FSettingField& Field = *FindSettingField(Name);
			const UObject* const Object =
				Field.IsOverridden(Settings.Settings) ? Field.Get(Settings.Settings).Object : nullptr;
			const std::string Path = GetObjectPath(Object);
			if (Object == nullptr || !(IsImagePath(Path) || IsColorCubePath(Path)))
			{
				continue;
			}
			try
			{
				IsColorCubePath(Path) ? (void)ReadColorCube(Config.Resolve(Path))
									  : (void)FImageFile(Config.Resolve(Path));
			}
			catch (const FError& Error)
			{
				const FDiagnostic& Reason = Error.GetDiagnostics().front();
				Messages.Error(Reason.Code, Place, Name + " " + Reason.File + ": " + Reason.Message);
			}
		}
	};
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Check(Volume.Settings, Config.File);
	}
	Check(Config.Camera.Settings, Config.File);
	Check(Config.CommandLine, CommandLineName);
}

FTextureLoader MakeTextureLoader(const FConfig& Config)
{
	return [Config](const std::string& Path) -> FTextureRHIRef
	{
		return IsColorCubePath(Path) ? LoadColorCube(Config.Resolve(Path), Path)
			   : IsImagePath(Path)   ? LoadPicture(Config.Resolve(Path), Path)
									 : nullptr;
	};
}

} // namespace Drydock
