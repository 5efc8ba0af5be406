// Writes PNG files by libpng, row by row. No date: equal pictures give equal bytes.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>
#include <functional>
#include <string>

namespace Drydock
{

/** Gives row Y, NumChannels bytes a pixel. Called from one thread, in order. */
using FByteRowSource = std::function<void(int Y, uint8_t* Row)>;

/** 8 bits per channel, sRGB: grey, grey and alpha, colour, colour and alpha. Compression: 1 to 9. Throws FError (exit
 * code 3) when it cannot be written. */
DRYDOCK_API void WritePngRows(
	const std::string& Path, int Width, int Height, int NumChannels, int Compression, const FByteRowSource& Rows);

} // namespace Drydock
