// Encoders of pictures, which are absent: the engine's names compile, and using them is an error that names the way
// round. Source: engine files IImageWrapper.h, IImageWrapperModule.h.
#pragma once

#include "CoreMinimal.h"
#include "Modules/ModuleInterface.h"

enum class EImageFormat : int8
{
	Invalid = -1,
	PNG,
	JPEG,
	GrayscaleJPEG,
	BMP,
	ICO,
	EXR,
	ICNS,
	TGA,
	HDR,
	TIFF
};

enum class ERGBFormat : int8
{
	Invalid = -1,
	RGBA,
	BGRA,
	Gray,
	RGBAF,
	BGRE,
	GrayF
};

class IImageWrapper;

class IImageWrapperModule : public IModuleInterface
{
public:
	DRYDOCK_ABSENT(CreateImageWrapper, "extract the texture, and let the run write it (docs/outputs.md)")
	TSharedPtr<IImageWrapper> CreateImageWrapper(EImageFormat ImageFormat);
};
