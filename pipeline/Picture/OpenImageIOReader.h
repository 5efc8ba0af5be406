// Reads all other image formats, by OpenImageIO. It brings hundreds of libraries with it and stays in a module of its
// own, which is loaded when a picture in such a format is first opened.
#pragma once

#include "Picture/ImageReader.h"

namespace Drydock
{

/** The function of the module: Format is OpenImageIO's name of the reader; null with the reason in OutFault. */
using FMakeOpenImageIOReader = IImageReader* (*)(const char* Path, FImageBytesPointer Bytes, const char* Format,
	std::string& OutFault);

/** Its name in the module. */
constexpr const char* MakeOpenImageIOReaderName = "DrydockMakeOpenImageIOReader";

/** Loads the module. Throws std::exception, also where the module is not there. */
std::unique_ptr<IImageReader> MakeOpenImageIOReader(
	const std::string& Path, FImageBytesPointer Bytes, const std::string& Format);

} // namespace Drydock
