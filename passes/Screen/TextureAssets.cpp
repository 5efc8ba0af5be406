// Loads the pixels behind texture paths, once for each loader.
#include "Screen/TextureAssets.h"

#include "Screen/BuiltinTextures.h"
#include "SettingObjects.h"
#include "RangeTools.h"

#include <map>
#include <mutex>
#include <utility>

namespace Drydock
{

namespace
{

std::mutex LoaderMutex;
FTextureLoader CurrentLoader;

std::map<std::string, FTextureRHIRef>& GetLoaded()
{
	static std::map<std::string, FTextureRHIRef> Loaded;
	return Loaded;
}

FTextureRHIRef MakeBuiltinTexture(const std::string& Path)
{
	const std::vector<float> Values = MakeBuiltinKernel(Path);
	if (Values.empty())
	{
		return nullptr;
	}
	auto Colors =
		ToVector<FLinearColor>(Values, [&](const float Value) { return FLinearColor(Value, Value, Value, 1.0f); });
	return MakePictureTexture(FIntPoint(BuiltinKernelSize, BuiltinKernelSize), Colors, Path);
}

} // namespace

FScopedTextureLoader::FScopedTextureLoader(FTextureLoader Loader)
{
	const std::lock_guard<std::mutex> Lock(LoaderMutex);
	Previous = std::exchange(CurrentLoader, std::move(Loader));
	GetLoaded().clear();
}

FScopedTextureLoader::~FScopedTextureLoader()
{
	const std::lock_guard<std::mutex> Lock(LoaderMutex);
	CurrentLoader = std::move(Previous);
	GetLoaded().clear();
}

FTextureRHIRef FindTexturePixels(const UTexture* Texture)
{
	return Texture != nullptr ? FindTexturePixels(GetObjectPath(Texture)) : nullptr;
}

FTextureRHIRef FindTexturePixels(const std::string& Path)
{
	const std::lock_guard<std::mutex> Lock(LoaderMutex);
	const auto Found = GetLoaded().find(Path);
	if (Found != GetLoaded().end())
	{
		return Found->second;
	}
	FTextureRHIRef Pixels = MakeBuiltinTexture(Path);
	if (!Pixels && CurrentLoader)
	{
		Pixels = CurrentLoader(Path);
	}
	return GetLoaded()[Path] = Pixels;
}

FTextureRHIRef MakePictureTexture(FIntPoint Size, const std::vector<FLinearColor>& Colors, const std::string& Name)
{
	check(Colors.size() == static_cast<size_t>(Size.X) * static_cast<size_t>(Size.Y));
	const FTextureRHIRef Texture = new FRHITexture(
		FRHITextureDesc::Create2D(Size, PF_A32B32G32R32F, FClearValueBinding::None, TexCreate_ShaderResource),
		Name.c_str());
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		Texture->WriteRow(
			0, Y, TConstArrayView<FLinearColor>(&Colors[static_cast<size_t>(Y) * static_cast<size_t>(Size.X)], Size.X));
	}
	return Texture;
}

} // namespace Drydock
