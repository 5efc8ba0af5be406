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

enum class EPngEffort
{
	Quick, // of frames: runs of what Paeth's filter leaves; as small as level 6 of deflate, in a sixth of its time
	Small, // of drawings: all that deflate can find
};

/** 8 bits per channel, sRGB: grey, grey and alpha, colour, colour and alpha. Throws FError (exit code 3) when it cannot
 * be written. */
DRYDOCK_API void WritePngRows(
	const std::string& Path, int Width, int Height, int NumChannels, EPngEffort Effort, const FByteRowSource& Rows);

} // namespace Drydock
