// Reads picture files into textures as the engine's import makes them.
#include "Objects/ObjectPictures.h"

#include "Engine/Texture.h"
#include "Picture/ImageFile.h"
#include "Picture/ImageFormat.h"
#include "Picture/ImagePlane.h"
#include "TexelRows.h"
#include "TextureResource.h"

#include <cmath>
#include <filesystem>
#include <map>

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

} // namespace

bool LoadPictures(const FConfig& Config, const FPropertyType& Type, FPropertyValue& Value, FPropertyProblem& OutProblem)
{
	if (Type.Kind == EPropertyKind::Object && Type.SetObject != nullptr && Value.Kind == FPropertyValue::EKind::Text)
	{
		if (!IsImagePath(Value.Text))
		{
			return true; // refused as no picture
		}
		try
		{
			Value = FPropertyValue::MakeObject(FindOrLoad(Config.Resolve(Value.Text)));
		}
		catch (const FError& Error)
		{
			const FDiagnostic& Reason = Error.GetDiagnostics().front();
			OutProblem = {FPropertyProblem::EKind::WrongValue, "", Reason.File + ": " + Reason.Message};
			return false;
		}
	}
	const FReflectedStruct* const Struct =
		Type.Kind == EPropertyKind::Struct ? FReflection::Get().FindStruct(*Type.Type) : nullptr;
	for (size_t Index = 0; Index < Value.Items.size(); ++Index)
	{
		auto& [Name, Item] = Value.Items[Index];
		const FFoundProperty Member =
			Struct != nullptr ? FReflection::Get().FindProperty(*Struct, Name, true) : FFoundProperty();
		const FPropertyType* const ItemType = Type.Kind == EPropertyKind::Array ? Type.Element
											  : Member.Property != nullptr      ? Member.Property->Type
																				: nullptr;
		if (ItemType != nullptr && !LoadPictures(Config, *ItemType, Item, OutProblem))
		{
			OutProblem.Path = "/" + (Struct != nullptr ? Name : std::to_string(Index)) + OutProblem.Path;
			return false;
		}
	}
	return true;
}

} // namespace Drydock
